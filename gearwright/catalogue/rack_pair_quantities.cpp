#include "gearwright/catalogue/gear_quantities.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/pair_parts.hpp"
#include "gearwright/inspection/rack_pin.hpp"

namespace gearwright {

namespace {

const Quantities<RackPair>& rack_backlash_quantities() {
  return define("rack_pair.backlash", [](Quantities<RackPair>& q) {
    q.term("normal_base_mm", "along the common normal", &RackPair::base_backlash);
    q.term("normal_mm", "j_bn/cos α_n", &RackPair::normal_backlash);
    q.term("circumferential_mm", "for the pinion at the reference circle, and along the rack",
           [](const RackPair& v) {
             const double j = v.circumferential_backlash();
             return std::array{j, j};
           })
        .per_gear();
    q.number("rotation_deg", "angular backlash of the pinion", "j_φ",
             "angular backlash of the pinion with the rack held", [](const RackPair& v) {
               return Angle::radians(2 * v.circumferential_backlash() / v.pinion.reference_diameter)
                   .deg();
             });
  });
}

std::optional<double> usable_travel(const RackPair& v) {
  const auto length = v.rack.length();
  if (!length || !(v.true_contact_ratio() > 0.0)) return std::nullopt;
  const double cos_alpha = std::cos(v.pinion.reference().transverse_pressure_angle);
  return std::max(0.0, *length - 2 * std::max(-v.contact_start(), v.recess) * cos_alpha);
}

void add_rack_mounting(Quantities<RackPair>& q) {
  q.under(kMounting);
  q.word("kind", "kind of pair", "for a pinion and a rack",
         [](const RackPair&) { return "rack_and_pinion"; })
      .one_of({"rack_and_pinion"})
      .doors(kJson);
  q.term("gear_ratio", "null, because a rack does not turn", [](const RackPair&) {
     return Value();
   }).doors(kJson);
  q.term("center_distance_mm",
         "distance from the pinion axis to the datum line of the rack [T2.36]",
         &RackPair::center_distance);
  q.number("mounting_distance_mm", "mounting distance", "",
           "distance from the pinion axis to the back of the rack", &RackPair::mounting_distance);
  q.term("backlash_free_center_distance_mm", "for the teeth as cut, including allowances [T2.36]",
         &RackPair::backlash_free_center_distance);
  q.number("travel_mm_per_turn", "travel per turn of the pinion", "", "π m_t z",
           &RackPair::travel_per_turn)
      .unit(Unit::mm);
  q.number("usable_travel_mm", "usable travel", "",
           "travel over which the whole path of contact of both flanks lies on the rack. It is n "
           "p_t − 2 max(g_f, g_a) cos α_t, where n is the number of teeth, and g_f and g_a are the "
           "lengths of the paths of approach and of recess. The value is 0 if the rack is too "
           "short, and null without contact or without `teeth` and `length_mm`",
           usable_travel);
  q.term("working_normal_pressure_angle_deg",
         "equal to the pressure angle of the basic rack at every mounting distance",
         [](const RackPair& v) { return v.pinion.spec.normal_pressure_angle; });
  q.term("working_transverse_pressure_angle_deg",
         "equal to the transverse pressure angle α_t of the pinion at every mounting distance",
         [](const RackPair& v) {
           return Angle::radians(v.pinion.reference().transverse_pressure_angle);
         });
  q.number("working_pitch_diameter_mm", "working pitch diameter of the pinion", "d_w",
           "equal to the reference diameter of the pinion at every mounting distance",
           [](const RackPair& v) { return v.pinion.reference_diameter; });
  q.term("pitch_line_velocity_m_per_s", "equal to the speed of the rack; only with `speed_rpm`",
         [](const RackPair& v) { return v.travel_per_turn * *v.speed_rpm / 60.0 / kMmPerM; })
      .when([](const RackPair& v) { return v.speed_rpm.has_value(); });
}

void add_rack_contact(Quantities<RackPair>& q) {
  q.under(kContact);
  q.term("contact_ratio", "ε_α + ε_β",
         [](const RackPair& v) { return v.transverse_contact_ratio() + v.overlap_ratio; });
  q.term("transverse_contact_ratio",
         "from the tip form circle of the pinion to the tip line of the rack [T2.38]",
         &RackPair::transverse_contact_ratio);
  q.term("contact_ratio_true",
         "for the part of the path on the usable flanks [T2.39]; 0 if no part of the path remains",
         [](const RackPair& v) {
           const double e = v.true_contact_ratio();
           return e > 0.0 ? e + v.overlap_ratio : 0.0;
         });
  q.term("transverse_contact_ratio_true", "for the part of the path on the usable flanks",
         &RackPair::true_contact_ratio)
      .doors(kPeople);
  q.term("overlap_ratio", "over the common face", &RackPair::overlap_ratio);
  q.term("approach_contact_ratio", "contact ratio before the pitch point, with the pinion driving",
         [](const RackPair& v) { return v.approach_and_recess()[0]; });
  q.term("recess_contact_ratio", "contact ratio after the pitch point, with the pinion driving",
         [](const RackPair& v) { return v.approach_and_recess()[1]; });
  add_sliding(
      q,
      "sliding distance [at A, at E] per mm that the contact travels on the flank [T2.41]; if the "
      "pinion is undercut, A is the start of its usable flank; null for the pinion at and beyond "
      "the base tangent point",
      [](const RackPair& v) {
        const auto a = v.specific_sliding(v.contact_start()), e = v.specific_sliding(v.recess);
        return SlidingAtEnds{{{a[0], e[0]}, {a[1], e[1]}}};
      });
  add_efficiency(
      q, +[](const RackPair& v) { return v.efficiency ? &*v.efficiency : nullptr; });
}

void add_rack_pair(Quantities<RackPair>& q) {
  q.groups({kMounting, kContact, kBacklash, kClearances});
  add_rack_mounting(q);
  add_rack_contact(q);
  q.under(kBacklash);
  q.record<rack_backlash_quantities>(
      "backlash", "backlash of the flanks as cut, at this centre distance [T2.37]");
  q.under(kClearances);
  q.term("tip_clearance_mm",
         "for the pinion, from its tip to the root of the rack; for the rack, from its tip to the "
         "root of the pinion [T2.40]",
         &RackPair::tip_clearance)
      .per_gear();
  q.number("contact_root_diameter_mm", "active root diameter of the pinion", "d_Nf",
           "diameter at which contact starts; null if contact starts beyond the base tangent point",
           &RackPair::contact_root_diameter);
  q.number("form_clearance_mm", "form clearance at the root of the pinion", "c_F",
           "(d_Nf − d_Ff)/2; null if d_Nf or d_Ff is null", &RackPair::form_clearance);
}

std::optional<double> of_pin(const RackGeometry& rack, double RackPin::*member) {
  const auto pin = usual_pin(rack);
  return pin ? std::optional((*pin).*member) : std::nullopt;
}

}  // namespace

const Quantities<RackGeometry>& rack_quantities() {
  using R = RackGeometry;
  return define("rack", [](Quantities<R>& q) {
    q.word("form", "form of the part", "`rack`, because gear 2 is a rack",
           [](const R&) { return "rack"; })
        .one_of({"rack"})
        .doors(kJson);
    q.term("teeth",
           "number of teeth of the rack; null for a rack of unlimited length; if the length is "
           "given, the number of whole teeth that fit into this length",
           [](const R& r) { return r.bar.teeth; });
    q.term("normal_module_mm", "normal module of the pinion", &R::normal_module);
    q.term("helix_angle_deg",
           "angle of the teeth to the pinion axis; the hand is opposite to the hand of the pinion",
           &R::helix_angle);
    q.term("face_width_mm", "as given, or the face width of the pinion", &R::face_width);
    q.number("normal_pitch_mm", "normal pitch", "p_n", "π m_n", &R::normal_pitch);
    q.number("transverse_pitch_mm", "transverse pitch", "p_t",
             "in the direction of travel, π m_n/cos β", &R::transverse_pitch);
    q.number(
        "length_mm", "length", "",
        "length n p_t of n teeth, with half a tooth space at each end; null without `teeth` and "
        "`length_mm`",
        &R::length);
    q.number("height_mm", "height", "", "height from the back of the rack to the datum line",
             &R::height);
    q.number("addendum_mm", "addendum", "h_a", "height above the datum line", &R::addendum);
    q.number("dedendum_mm", "dedendum", "h_f", "depth below the datum line", &R::dedendum);
    q.term("reference_tooth_thickness_normal_mm",
           "at the datum line, including the thickness allowance", &R::thickness);
    q.number(
        "pin_diameter_mm", "diameter of the pin", "D_M",
        "the size of DIN 3977 nearest to the size that touches the flanks at the datum line; only "
        "sizes with which the rack can be measured are considered, and the value is null if there "
        "is no such size. If a spec in inch gives the normal diametral pitch P_nd, the diameter is "
        "1.728/P_nd, unless the rack cannot be measured with this pin",
        [](const R& r) { return of_pin(r, &RackPin::diameter); });
    q.number("over_pin_mm", "dimension over one pin", "M",
             "from the back of the rack over a pin in a tooth space [T10.38]; null without "
             "`pin_diameter_mm`",
             [](const R& r) { return of_pin(r, &RackPin::dimension); });
  });
}

const Quantities<RackPair>& rack_pair_quantities() { return define<add_rack_pair>("rack_pair"); }

}  // namespace gearwright
