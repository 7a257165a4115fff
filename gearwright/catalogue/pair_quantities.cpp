#include "gearwright/catalogue/pair_quantities.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/pair_parts.hpp"
#include "gearwright/pair/drive.hpp"

namespace gearwright {

namespace {

using V = Pair;

double deg(double rad) { return Angle::radians(rad).deg(); }
Value degrees(const std::array<double, 2>& rad) { return std::array{deg(rad[0]), deg(rad[1])}; }

bool is_involute(const V& v) { return v.involute() != nullptr; }
bool is_arcs(const V& v) { return v.arcs() != nullptr; }
bool is_parallel(const V& v) { return v.involute() && !v.crossed(); }
bool is_crossed(const V& v) { return v.crossed(); }

// Getters of what an involute pair has, of what one has on crossed or on
// parallel axes: null for the others.
template <class F>
auto of_involute(F get) {
  return
      [get](const V& v) { return v.involute() ? Value(std::invoke(get, *v.involute())) : Value(); };
}
template <class F>
auto crossed(F get) {
  return
      [get](const V& v) { return v.crossed() ? Value(std::invoke(get, *v.involute())) : Value(); };
}
template <class F>
auto parallel(F get) {
  return [get](const V& v) {
    return is_parallel(v) ? Value(std::invoke(get, *v.involute())) : Value();
  };
}

// The record of two gears.
Value each_gear(const Value& gear_1, const Value& gear_2) {
  return two_gears().of({gear_1, gear_2});
}

Value kind(const V& v) {
  if (v.crossed()) return "crossed";
  return v.kind() == PairKind::parallel_external ? "parallel_external" : "parallel_internal";
}

// The helix angle on the working pitch cylinder: tan β grows with the radius.
double working_helix(const ArcPair& p, std::size_t i) {
  const Gear& g = p.gears[i];
  return std::atan(std::tan(g.spec.helix_angle.rad()) * p.working_pitch_diameter()[i] /
                   g.reference_diameter);
}

// The transverse angle of the rack's normal angle at the first contact.
double working_transverse(const ArcPair& p, std::size_t i) {
  return std::atan(std::tan(p.first_contact().at.theta.rad()) /
                   std::cos(p.gears[i].spec.helix_angle.rad()));
}

std::array<double, 2> working_pitch_diameter(const V& v) {
  if (v.arcs()) return v.arcs()->working_pitch_diameter();
  const auto& sides = v.involute()->mesh.rack.sides;
  return {2 * sides[0].pitch_radius, 2 * sides[1].pitch_radius};
}

// v_t = π d_w n/60 in m/s of d_w in mm and n in 1/min; gear 2 turns at n_1/|u|. ISO 6336-1.
std::array<double, 2> pitch_line_velocity(const V& v) {
  const auto d = working_pitch_diameter(v);
  const double turns_1 = v.mounted().speed_rpm.value() / 60.0;
  const double turns_2 = turns_1 / std::abs(v.gear_ratio());
  return {std::numbers::pi * d[0] * turns_1 / kMmPerM, std::numbers::pi * d[1] * turns_2 / kMmPerM};
}

void say_mounting(Quantities<V>& q) {
  q.under(kMounting);
  q.word("kind", "kind of pair", "how the axes lie", kind)
      .always()
      .one_of({"parallel_external", "parallel_internal", "crossed"})
      .doors(kJson);
  q.term("gear_ratio", "z2/z1, negative for internal pairs", &V::gear_ratio).always();
  q.term("shaft_angle_deg", "0 on parallel axes", &V::shaft_angle).always().shown(is_crossed);
  q.term("center_distance_mm", "as mounted", &V::center_distance).always();
  q.number("reference_center_distance_mm", "reference centre distance", "a_d",
           "from the reference diameters",
           [](const V& v) { return v.mounted().reference_center_distance; })
      .always();
  q.term(
       "backlash_free_center_distance_mm",
       "of the teeth as cut, allowances included [T2.20]; crossed: at this Σ [T4.11]; null: there "
       "is none",
       of_involute(&InvolutePair::backlash_free_center_distance))
      .expected(is_involute);
  q.number("extended_center_distance_mm", "extended centre distance", "",
           "the reference one and both profile shifts [T2.18]",
           of_involute(&InvolutePair::extended_center_distance));
  q.term("working_normal_pressure_angle_deg",
         "of circular arcs the racks' normal angle at the contact",
         [](const V& v) -> Value {
           if (v.involute()) return deg(v.involute()->mesh.rack.normal_pressure_angle);
           if (v.arcs()->contacts.empty()) return {};
           return v.arcs()->first_contact().at.theta.deg();
         })
      .shown(is_involute);
  q.term("working_transverse_pressure_angle_deg", "per gear",
         [](const V& v) -> Value {
           if (v.involute()) {
             const auto& sides = v.involute()->mesh.rack.sides;
             return degrees({sides[0].transverse_angle, sides[1].transverse_angle});
           }
           if (v.arcs()->contacts.empty()) return {};
           return degrees({working_transverse(*v.arcs(), 0), working_transverse(*v.arcs(), 1)});
         })
      .per_gear()
      .shown(is_involute);
  q.number("working_helix_angle_deg", "working helix angle", "β_w", "per gear", [](const V& v) {
     if (!v.involute()) return degrees({working_helix(*v.arcs(), 0), working_helix(*v.arcs(), 1)});
     const auto& sides = v.involute()->mesh.rack.sides;
     return degrees({sides[0].helix_angle, sides[1].helix_angle});
   }).per_gear();
  q.number("working_pitch_diameter_mm", "working pitch diameter", "d_w", "per gear",
           [](const V& v) { return working_pitch_diameter(v); })
      .per_gear();
  q.term(
       "pitch_line_velocity_m_per_s",
       "per gear, on the working pitch cylinder; with `speed_rpm` only. On parallel axes it is one",
       [](const V& v) { return pitch_line_velocity(v); })
      .per_gear()
      .when([](const V& v) { return v.mounted().speed_rpm.has_value(); });
  q.number("pitch_plane_distance_mm", "distance of the pitch planes", "X",
           "as mounted, backlash or not; 0 on parallel axes",
           of_involute([](const InvolutePair& p) { return p.mesh.pitch_plane_distance; }))
      .shown(is_crossed);
}

// Null on parallel axes.
void say_crossed(Quantities<V>& q) {
  q.under(kFace);
  q.number("min_face_width_mm", "minimum face width, one flank", "f", "per gear [T4.21]",
           crossed([](const InvolutePair& p) { return p.face_widths->one_flank; }))
      .per_gear()
      .shown([](const V& v) { return v.crossed() && v.involute()->flanks_meet(); });
  q.number("min_face_width_both_flanks_mm", "minimum face width, both flanks", "f'",
           "per gear, about the centre line [T4.21]",
           crossed([](const InvolutePair& p) { return p.face_widths->both_flanks; }))
      .per_gear()
      .shown([](const V& v) { return v.crossed() && v.involute()->flanks_meet(); });
  q.record<two_gears>(
       "face_interval_mm",
       "[at A, at E]: where on the face the leading flanks touch, from its middle [T4.20]",
       crossed([](const InvolutePair& p) {
         return each_gear(p.face_widths->interval[0], p.face_widths->interval[1]);
       }))
      .doors(kJson)
      .when(is_involute);
  q.under(kContact);
  q.number(
       "line_offset_mm", "offset of the line of action", "z_L",
       "distance of the leading line of action from the centre line along the teeth of the rack "
       "[T4.18]; the trailing line is at −z_L",
       crossed([](const InvolutePair& p) { return p.mesh.line_offset; }))
      .doors(kJson)
      .when(is_involute);
  q.under("Minimum centre distance, free of backlash");
  q.record<place_quantities>("minimum_center_distance",
                             "of the teeth as cut [T4.15]; null: the teeth are too thin",
                             crossed([](const InvolutePair& p) {
                               return record_value(place_quantities(), p.min_distance);
                             }));
  q.under("Contact ratio of 1 and more, free of backlash");
  q.record<places_quantities>("contact_ratio_range", "where AE ≥ p_bn [T4.23]; null: nowhere",
                              crossed([](const InvolutePair& p) {
                                return record_value(places_quantities(), p.contact_ratio_range);
                              }));
}

void say_contact(Quantities<V>& q) {
  q.under(kContact);
  q.term("contact_ratio",
         "ε_α + ε_β, crossed AE/p_bn; 0 when the teeth do not meet; of circular arcs ε_β times the "
         "points of contact per tooth",
         &V::contact_ratio)
      .always()
      .shown([](const V& v) { return !v.crossed(); });
  // Crossed axes have one contact ratio: there is no transverse one to add an overlap to.
  q.number("contact_ratio_crossed", "contact ratio", "ε", "AE/p_bn",
           crossed(&InvolutePair::contact_ratio))
      .doors(kPeople);
  q.number("contact_ratio_crossed_true", "effective contact ratio", "",
           "the path clipped to the usable flanks and faces",
           crossed(&InvolutePair::contact_ratio_true))
      .doors(kPeople);
  q.term("transverse_contact_ratio", "tip form circle to tip form circle; null on crossed axes",
         [](const V& v) {
           return v.involute() ? Value(v.involute()->transverse_contact_ratio()) : Value(0.0);
         })
      .shown(is_involute);
  q.term("contact_ratio_true",
         "the path clipped to the usable flanks [T2.19], of crossed pairs to the faces too; 0 when "
         "nothing is left of it",
         [](const V& v) -> Value {
           if (v.involute()) return v.involute()->contact_ratio_true();
           return v.arcs()->contacts.empty() ? Value() : Value(v.arcs()->contact_ratio);
         })
      .shown(is_parallel);
  q.number("transverse_contact_ratio_true", "effective transverse contact ratio", "",
           "the path clipped to the usable flanks",
           parallel([](const InvolutePair& p) { return p.mesh.true_ratio; }))
      .doors(kPeople);
  q.term("overlap_ratio", "null on crossed axes", [](const V& v) -> Value {
    if (v.arcs()) return v.arcs()->overlap_ratio;
    return v.crossed() ? Value() : Value(v.involute()->mesh.overlap_ratio);
  });
  q.under(kFace);
  q.number("face_width_for_contact_mm", "minimum face width for continuous contact", "b",
           "circular arcs only: the smallest common face width with a contact point at all times",
           [](const V& v) { return v.arcs()->face_for_contact; })
      .when(is_arcs);
  q.under(kContact);
  q.record<line_quantities>(
       "line_of_action",
       "for circular arcs, the path of the contact point over the common face; null without "
       "contact",
       [](const V& v) { return record_value(line_quantities(), line_of(v)); })
      .shown(is_involute);
  q.number("base_tangent_distance_mm", "distance of the base tangent points", "N",
           "in the transverse section [T2.14]; crossed: L, along the common normal [T4.19]",
           of_involute([](const InvolutePair& p) {
             return p.mesh.base_tangent_distance /
                    (p.crossed() ? std::cos(p.input.gears[0].helix_angle) : 1.0);
           }))
      .doors(kJson)
      .when(is_involute);
  q.record<path_quantities>(
       "path", "points of the path of contact",
       of_involute([](const InvolutePair& p) { return path_quantities().of(p); }))
      .doors(kJson)
      .when(is_involute);
  q.record<collision_quantities>(
       "overlap",
       "overlap of the bodies in the middle of the backlash, deepest first [T2.34], on crossed "
       "axes of tips and roots [T4.33]; null: not computed (circular arcs of unequal lead, an "
       "internal gear whose cutter is not known)",
       [](const V& v) {
         const auto& overlap = v.mounted().overlap;
         return overlap ? Value(collision_quantities().each(*overlap)) : Value();
       })
      .list({0})
      .doors(kJson);
  q.record<collision_quantities>("beyond_flank",
                                 "contact on a root or a tip beyond the flank, without overlap",
                                 [](const V& v) { return v.mounted().beyond_flank; })
      .always()
      .list({0})
      .doors(kJson);
  q.record<interference_quantities>(
       "interference",
       "what explains an overlap; if overlap is not computed, all findings of circles and "
       "corners",
       [](const V& v) { return interference_of(v); })
      .always()
      .list({0})
      .doors(kJson);
}

void say_clearances(Quantities<V>& q) {
  q.under(kClearances);
  q.term("tip_clearance_mm", "tip of gear 1 to root of gear 2, then the other", [](const V& v) {
     return v.mounted().tip_clearance;
   }).per_gear();
  q.number("contact_root_diameter_mm", "active root diameter", "d_Nf",
           "per gear, where contact starts; null past the base tangent point",
           of_involute(&InvolutePair::contact_root_diameter))
      .per_gear()
      .when(is_involute)
      .expected(is_involute);
  q.number("form_clearance_mm", "form clearance at the root", "c_F",
           "per gear, (d_Nf − d_Ff)/2 [T2.25]; null past the base tangent point and without a d_Ff",
           of_involute(&InvolutePair::form_clearance))
      .per_gear()
      .when(is_involute)
      .expected(is_involute);
  q.number("fillet_clearance_mm", "fillet clearance to the mating tip corner", "",
           "per gear, least distance [T2.26]; null on crossed axes and "
           "where no corner gets that deep",
           of_involute(&InvolutePair::fillet_clearance))
      .per_gear()
      .when(is_involute)
      .expected(is_parallel);
  q.number("tip_shortening_mm", "tip alteration", "k m_n",
           "that would keep the racks' clearance [T2.21], ≤ 0 as a rule",
           of_involute(&InvolutePair::tip_shortening))
      .when(is_involute);
}

void say_sliding(Quantities<V>& q) {
  q.under(kContact);
  add_sliding(
      q,
      "[at A, at E]: sliding distance per mm of contact travel on the flank. Parallel axes "
      "[T2.22]: < 0 where the mating gear drags the flank, null at and beyond a base tangent "
      "point; crossed [T4.25]: of whole velocities, ≥ 0",
      [](const V& v) -> std::optional<SlidingAtEnds> {
        if (!v.involute()) return std::nullopt;
        const auto &a = v.involute()->sliding_A, &e = v.involute()->sliding_E;
        return SlidingAtEnds{{{a.zeta_1, e.zeta_1}, {a.zeta_2, e.zeta_2}}};
      });
  q.under(kFace);
  q.record<needed_face_quantities>(
       "needed_face_width_mm",
       "the face for a total contact ratio of 1 and 1.2, and for an overlap of 1 [T6.14]; null "
       "on crossed axes",
       parallel([](const InvolutePair& p) { return needed_face_quantities().of(p); }))
      .when(is_involute);
  q.under(kContact);
  q.term("approach_contact_ratio", "before the pitch point, gear 1 driving; null on crossed axes",
         parallel([](const InvolutePair& p) { return approach_and_recess(p)[0]; }))
      .when(is_involute);
  q.term("recess_contact_ratio", "after the pitch point, gear 1 driving; null on crossed axes",
         parallel([](const InvolutePair& p) { return approach_and_recess(p)[1]; }))
      .when(is_involute);
  q.number("axial_force_ratio", "axial over tangential force", "F_z/F_t",
           "per gear, along +z, while gear 1 drives in its sense [T6.15]; null on crossed axes",
           parallel([](const InvolutePair& p) { return axial_force(p); }))
      .per_gear()
      .when(is_involute)
      .shown([](const V& v) { return v.involute()->input.gears[0].helix_angle != 0.0; });
  q.under(kBacklash);
  q.number("backlash_per_center_distance",
           "circumferential backlash per mm of centre "
           "distance",
           "", "[T6.16]; null on crossed axes",
           parallel([](const InvolutePair& p) { return backlash_per_distance(p); }))
      .when(is_involute);
  q.under(kContact);
  q.record<sliding_velocity_quantities>(
       "sliding_velocity_mm_per_rad",
       "speed of the contact over flank 1 less that over flank 2, per radian of gear 1 [T4.24]",
       of_involute([](const InvolutePair& p) { return sliding_velocity_quantities().of(p); }))
      .doors(kJson)
      .when(is_involute);
  q.record<efficiency_quantities>(
       "efficiency",
       "by friction of the flanks alone [T4.27]; tooth pairs in contact at one time carry equal "
       "parts of a constant normal force. Null without `friction_coefficient`, and with "
       "`contact_ratio_true` below 1",
       of_involute([](const InvolutePair& p) {
         return record_value(efficiency_quantities(), p.efficiency);
       }))
      .doors(kJson);
  q.number("efficiency_driving", "efficiency, this gear driving", "η", "per gear",
           [](const V& v) -> Value {
             if (!v.involute() || !v.involute()->efficiency) return {};
             const Efficiency& e = *v.involute()->efficiency;
             return std::array{e.gear1_drives, e.gear2_drives};
           })
      .unit(Unit::percent)
      .per_gear()
      .otherwise("self-locking")
      .doors(kPeople);
}

void say(Quantities<V>& q) {
  q.groups({kMounting, kContact, kBacklash, kClearances, kFace});
  say_mounting(q);
  say_crossed(q);
  say_contact(q);
  say_clearances(q);
  say_sliding(q);
  q.under(kBacklash);
  q.record<backlash_quantities>(
      "backlash", "of the flanks as cut at this centre distance",
      [](const V& v) { return record_value(backlash_quantities(), backlash_of(v)); });
  q.under(kMargins);
  q.record<internal_quantities>(
       "internal", "internal pairs only",
       of_involute([](const InvolutePair& p) { return internal_quantities().of(p); }))
      .when([](const V& v) { return v.kind() == PairKind::parallel_internal; });
  q.under("Point of contact");
  q.record<arc_contact_quantities>(
       "arc_contacts", "circular arcs only: the points of contact; empty for gears of unequal lead",
       [](const V& v) { return arc_contacts_of(v); })
      .list({0})
      .when(is_arcs);
}

}  // namespace

const Quantities<Pair>& pair_quantities() {
  static const Quantities<Pair> kAll("pair", say);
  return kAll;
}

}  // namespace gearwright
