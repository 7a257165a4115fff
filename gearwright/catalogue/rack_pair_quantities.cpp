#include "gearwright/catalogue/rack_pair_quantities.hpp"

#include <cmath>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/pair_parts.hpp"

namespace gearwright {

namespace {

using V = RackPair;

const Quantities<RackPair>& rack_backlash_quantities() {
  static const Quantities<V> kAll("rack_pair.backlash", [](Quantities<V>& q) {
    q.mm("", "normal_base_mm", "normal backlash along the line of action", "j_bn",
         "along the common normal", [](const V& v) { return Value(v.base_backlash()); })
        .always();
    q.mm("", "normal_mm", "normal backlash", "j_n", "j_bn/cos α_n", [](const V& v) {
       return Value(v.normal_backlash());
     }).always();
    q.mm("", "circumferential_mm", "circumferential backlash", "j_wt",
         "of the pinion at its reference circle, and along the rack",
         [](const V& v) {
           const double j = v.circumferential_backlash();
           return Value(std::array{j, j});
         })
        .per_gear()
        .always();
    q.deg("", "rotation_deg", "angular backlash of the pinion", "j_φ", "with the rack held",
          [](const V& v) {
            return Value(
                Angle::radians(2 * v.circumferential_backlash() / v.pinion.reference_diameter)
                    .deg());
          })
        .always();
  });
  return kAll;
}

void say_mounting(Quantities<V>& q) {
  q.word(kMounting, "kind", "kind of pair", "the pair is a pinion and a rack",
         [](const V&) { return Value("rack_and_pinion"); })
      .always()
      .one_of({"rack_and_pinion"})
      .doors(kJson);
  q.pure(kMounting, "gear_ratio", "gear ratio", "u", "null: a rack has no number of teeth per turn",
         [](const V&) { return Value(); })
      .doors(kJson);
  q.mm(kMounting, "center_distance_mm", "centre distance", "a",
       "pinion axis to the datum line of the rack [T2.36]",
       [](const V& v) { return Value(v.center_distance); })
      .always();
  q.mm(kMounting, "mounting_distance_mm", "mounting distance", "",
       "pinion axis to the back of the rack; null without `height_mm`",
       [](const V& v) { return Value(v.mounting_distance()); });
  q.mm(kMounting, "backlash_free_center_distance_mm", "backlash-free centre distance", "",
       "of the teeth as cut, allowances included [T2.36]",
       [](const V& v) { return Value(v.backlash_free_center_distance); })
      .always();
  q.mm(kMounting, "travel_mm_per_turn", "travel per turn of the pinion", "", "π m_t z",
       [](const V& v) { return Value(v.travel_per_turn); })
      .always();
  q.deg(kMounting, "working_normal_pressure_angle_deg", "working normal pressure angle", "α_wn",
        "that of the basic rack at every centre distance",
        [](const V& v) { return Value(v.pinion.spec.normal_pressure_angle.deg()); })
      .always();
  q.deg(kMounting, "working_transverse_pressure_angle_deg", "working transverse pressure angle",
        "α_wt", "that of the basic rack at every centre distance",
        [](const V& v) {
          return Value(Angle::radians(v.pinion.reference().transverse_pressure_angle).deg());
        })
      .always();
  q.mm(kMounting, "working_pitch_diameter_mm", "working pitch diameter of the pinion", "d_w",
       "its reference diameter at every centre distance",
       [](const V& v) { return Value(v.pinion.reference_diameter); })
      .always();
  q.add(Type::number, Unit::m_per_s, kMounting, "pitch_line_velocity_m_per_s",
        "pitch line velocity", "v_t", "speed of the rack; with `speed_rpm` only",
        [](const V& v) { return Value(v.travel_per_turn * *v.speed_rpm / 60.0 / kMmPerM); })
      .when([](const V& v) { return v.speed_rpm.has_value(); });
}

void say_contact(Quantities<V>& q) {
  q.pure(kContact, "contact_ratio", "total contact ratio", "ε_γ", "ε_α + ε_β", [](const V& v) {
     return Value(v.transverse_contact_ratio() + v.overlap_ratio);
   }).always();
  q.pure(kContact, "transverse_contact_ratio", "transverse contact ratio", "ε_α",
         "tip form circle of the pinion to the tip line of the rack [T2.38]",
         [](const V& v) { return Value(v.transverse_contact_ratio()); })
      .always();
  q.pure(kContact, "contact_ratio_true", "effective total contact ratio", "",
         "the path clipped to the usable flanks [T2.39]",
         [](const V& v) { return Value(v.true_contact_ratio() + v.overlap_ratio); })
      .always();
  q.pure(kContact, "overlap_ratio", "overlap ratio", "ε_β", "over the common face", [](const V& v) {
     return Value(v.overlap_ratio);
   }).always();
  q.pure(kContact, "approach_contact_ratio", "approach contact ratio", "",
         "before the pitch point, the pinion driving",
         [](const V& v) { return Value(v.approach / v.base_pitch); })
      .always();
  q.pure(kContact, "recess_contact_ratio", "recess contact ratio", "",
         "after the pitch point, the pinion driving",
         [](const V& v) { return Value(v.recess / v.base_pitch); })
      .always();
  q.record(
       kContact, "specific_sliding",
       "[at A, at E]: how far the flanks slide for each mm that the contact runs over the flank "
       "[T2.41]; null for the pinion at and beyond its base tangent point",
       []() -> const QuantityTable& { return two_gears().table(); },
       [](const V& v) {
         const auto a = v.specific_sliding(-v.approach), e = v.specific_sliding(v.recess);
         return Value(
             two_gears().of({Value(std::array{a[0], e[0]}), Value(std::array{a[1], e[1]})}));
       })
      .doors(kJson);
  for (const bool start : {true, false}) {
    q.pure(
         kContact, start ? "specific_sliding_at_A" : "specific_sliding_at_E",
         start ? "specific sliding at A" : "specific sliding at E", "ζ", "of pinion and rack",
         [start](const V& v) { return Value(v.specific_sliding(start ? -v.approach : v.recess)); })
        .per_gear()
        .doors(kPeople);
  }
}

void say(Quantities<V>& q) {
  q.groups({kMounting, kContact, kBacklash, kClearances});
  say_mounting(q);
  say_contact(q);
  q.record(
       kBacklash, "backlash", "of the flanks as cut at this centre distance [T2.37]",
       []() -> const QuantityTable& { return rack_backlash_quantities().table(); },
       [](const V& v) { return Value(rack_backlash_quantities().of(v)); })
      .always();
  q.mm(kClearances, "tip_clearance_mm", "tip clearance", "c",
       "tip of the pinion to the root of the rack, then the other [T2.40]",
       [](const V& v) { return Value(v.tip_clearance); })
      .per_gear()
      .always();
  q.mm(kClearances, "contact_root_diameter_mm", "active root diameter of the pinion", "d_Nf",
       "where contact starts; null past the base tangent point",
       [](const V& v) { return Value(v.contact_root_diameter); });
  q.mm(kClearances, "form_clearance_mm", "form clearance at the root of the pinion", "c_F",
       "(d_Nf − d_Ff)/2; null past the base tangent point and without a d_Ff",
       [](const V& v) { return Value(v.form_clearance); });
}

}  // namespace

const Quantities<RackGeometry>& rack_quantities() {
  using R = RackGeometry;
  static const Quantities<R> kAll("rack", [](Quantities<R>& q) {
    q.word("", "form", "form of the part", "gear 2 is a rack",
           [](const R&) { return Value("rack"); })
        .always()
        .one_of({"rack"})
        .doors(kJson);
    q.whole("", "teeth", "number of teeth", "z", "null: as long as it is needed",
            [](const R& r) { return r.bar.teeth ? Value(*r.bar.teeth) : Value(); });
    q.mm("", "normal_module_mm", "normal module", "m_n", "that of the pinion", [](const R& r) {
       return Value(r.normal_module);
     }).always();
    q.deg("", "helix_angle_deg", "helix angle", "β",
          "of the teeth against the pinion axis, of the hand opposite to the pinion's",
          [](const R& r) { return Value(r.helix_angle.deg()); })
        .always();
    q.mm("", "face_width_mm", "face width", "b", "that of the pinion if none is given",
         [](const R& r) { return Value(r.face_width); })
        .always();
    q.mm("", "normal_pitch_mm", "normal pitch", "p_n", "π m_n", [](const R& r) {
       return Value(r.normal_pitch);
     }).always();
    q.mm("", "transverse_pitch_mm", "transverse pitch", "p_t", "along the travel, π m_n/cos β",
         [](const R& r) { return Value(r.transverse_pitch); })
        .always();
    q.mm("", "length_mm", "length", "",
         "n p_t, with half a space at both ends; null without `teeth`",
         [](const R& r) { return Value(r.length()); });
    q.mm("", "height_mm", "height", "", "from the back to the datum line; null if not given",
         [](const R& r) { return Value(r.bar.height); });
    q.mm("", "addendum_mm", "addendum", "h_a", "above the datum line", [](const R& r) {
       return Value(r.addendum);
     }).always();
    q.mm("", "dedendum_mm", "dedendum", "h_f", "below the datum line", [](const R& r) {
       return Value(r.dedendum);
     }).always();
    q.mm("", "reference_tooth_thickness_normal_mm", "normal tooth thickness", "s_n",
         "at the datum line, thickness allowance included",
         [](const R& r) { return Value(r.thickness); })
        .always();
  });
  return kAll;
}

const Quantities<RackPair>& rack_pair_quantities() {
  static const Quantities<V> kAll("rack_pair", say);
  return kAll;
}

}  // namespace gearwright
