#include "gearwright/catalogue/pair_quantities.hpp"

#include <cmath>
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

// Getters for data of an involute pair, on crossed or on parallel axes only: null for other pairs.
template <class F>
auto involute(F get) {
  return [get](const V& v) { return v.involute() ? Value(get(*v.involute())) : Value(); };
}
template <class F>
auto crossed(F get) {
  return [get](const V& v) { return v.crossed() ? Value(get(*v.involute())) : Value(); };
}
template <class F>
auto parallel(F get) {
  return [get](const V& v) { return is_parallel(v) ? Value(get(*v.involute())) : Value(); };
}

// The table of a sub-catalogue, and its record of optional data.
template <const auto& (*quantities)()>
const QuantityTable& table_of() {
  return quantities().table();
}
template <class S>
Value record_of(const Quantities<S>& quantities, const std::optional<S>& subject) {
  return subject ? Value(quantities.of(*subject)) : Value();
}
Value each_gear(const Value& gear_1, const Value& gear_2) {
  return two_gears().of({gear_1, gear_2});
}

Value kind(const V& v) {
  if (v.crossed()) return "crossed";
  return v.kind() == PairKind::parallel_external ? "parallel_external" : "parallel_internal";
}

// The helix angle on the working pitch cylinder, because tan β grows with the radius.
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
  q.word(kMounting, "kind", "kind of pair", "how the axes lie", kind)
      .always()
      .one_of({"parallel_external", "parallel_internal", "crossed"})
      .doors(kJson);
  q.pure(kMounting, "gear_ratio", "gear ratio", "u", "z2/z1, negative for internal pairs",
         [](const V& v) { return Value(v.gear_ratio()); })
      .always();
  q.deg(kMounting, "shaft_angle_deg", "shaft angle", "Σ", "0 on parallel axes",
        [](const V& v) { return Value(v.shaft_angle().deg()); })
      .always()
      .shown(is_crossed);
  q.mm(kMounting, "center_distance_mm", "centre distance", "a", "as mounted", [](const V& v) {
     return Value(v.center_distance());
   }).always();
  q.mm(kMounting, "reference_center_distance_mm", "reference centre distance", "a_d",
       "from the reference diameters",
       [](const V& v) { return Value(v.mounted().reference_center_distance); })
      .always();
  q.mm(kMounting, "backlash_free_center_distance_mm", "backlash-free centre distance", "",
       "of the teeth as cut, allowances included [T2.20]; crossed: at this Σ [T4.11]; null: there "
       "is none",
       involute([](const InvolutePair& p) { return p.backlash_free_center_distance; }))
      .expected(is_involute);
  q.mm(kMounting, "extended_center_distance_mm", "extended centre distance", "",
       "the reference one and both profile shifts [T2.18]",
       involute([](const InvolutePair& p) { return p.extended_center_distance; }));
  q.deg(kMounting, "working_normal_pressure_angle_deg", "working normal pressure angle", "α_wn",
        "of circular arcs the racks' normal angle at the contact",
        [](const V& v) -> Value {
          if (v.involute()) return deg(v.involute()->mesh.rack.normal_pressure_angle);
          if (v.arcs()->contacts.empty()) return {};
          return v.arcs()->first_contact().at.theta.deg();
        })
      .shown(is_involute);
  q.deg(kMounting, "working_transverse_pressure_angle_deg", "working transverse pressure angle",
        "α_wt", "per gear",
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
  q.deg(kMounting, "working_helix_angle_deg", "working helix angle", "β_w", "per gear",
        [](const V& v) {
          if (!v.involute())
            return degrees({working_helix(*v.arcs(), 0), working_helix(*v.arcs(), 1)});
          const auto& sides = v.involute()->mesh.rack.sides;
          return degrees({sides[0].helix_angle, sides[1].helix_angle});
        })
      .per_gear();
  q.mm(kMounting, "working_pitch_diameter_mm", "working pitch diameter", "d_w", "per gear",
       [](const V& v) { return Value(working_pitch_diameter(v)); })
      .per_gear();
  q.add(
       Type::number, Unit::m_per_s, kMounting, "pitch_line_velocity_m_per_s", "pitch line velocity",
       "v_t",
       "per gear, on the working pitch cylinder; with `speed_rpm` only. On parallel axes it is one",
       [](const V& v) { return Value(pitch_line_velocity(v)); })
      .per_gear()
      .when([](const V& v) { return v.mounted().speed_rpm.has_value(); });
  q.mm(kMounting, "pitch_plane_distance_mm", "distance of the pitch planes", "X",
       "as mounted, backlash or not; 0 on parallel axes",
       involute([](const InvolutePair& p) { return p.mesh.pitch_plane_distance; }))
      .shown(is_crossed);
}

// Null on parallel axes.
void say_crossed(Quantities<V>& q) {
  q.mm(kFace, "min_face_width_mm", "minimum face width, one flank", "f", "per gear [T4.21]",
       crossed([](const InvolutePair& p) { return p.face_widths->one_flank; }))
      .per_gear()
      .shown([](const V& v) { return v.crossed() && v.involute()->flanks_meet(); });
  q.mm(kFace, "min_face_width_both_flanks_mm", "minimum face width, both flanks", "f'",
       "per gear, about the centre line [T4.21]",
       crossed([](const InvolutePair& p) { return p.face_widths->both_flanks; }))
      .per_gear()
      .shown([](const V& v) { return v.crossed() && v.involute()->flanks_meet(); });
  q.record(kFace, "face_interval_mm",
           "[at A, at E]: where on the face the leading flanks touch, from its middle [T4.20]",
           table_of<two_gears>, crossed([](const InvolutePair& p) {
             return each_gear(p.face_widths->interval[0], p.face_widths->interval[1]);
           }))
      .doors(kJson)
      .when(is_involute);
  q.mm(kContact, "line_offset_mm", "offset of the line of action", "z_L",
       "distance of the leading line of action from the centre line along the teeth of the rack "
       "[T4.18]; the trailing line is at −z_L",
       crossed([](const InvolutePair& p) { return p.mesh.line_offset; }))
      .doors(kJson)
      .when(is_involute);
  q.record(
      "Minimum centre distance, free of backlash", "minimum_center_distance",
      "of the teeth as cut [T4.15]; null: the teeth are too thin", table_of<place_quantities>,
      crossed([](const InvolutePair& p) { return record_of(place_quantities(), p.min_distance); }));
  q.record("Contact ratio of 1 and more, free of backlash", "contact_ratio_range",
           "where AE ≥ p_bn [T4.23]; null: nowhere", table_of<places_quantities>,
           crossed([](const InvolutePair& p) {
             return record_of(places_quantities(), p.contact_ratio_range);
           }));
}

void say_contact(Quantities<V>& q) {
  q.pure(kContact, "contact_ratio", "total contact ratio", "ε_γ",
         "ε_α + ε_β, crossed AE/p_bn; 0 when the teeth do not meet; of circular arcs ε_β times the "
         "points of contact per tooth",
         [](const V& v) { return Value(v.contact_ratio()); })
      .always()
      .shown([](const V& v) { return !v.crossed(); });
  // Crossed axes have a single contact ratio, because there is no transverse one to which an
  // overlap is added.
  q.pure(kContact, "contact_ratio_crossed", "contact ratio", "ε", "AE/p_bn",
         crossed([](const InvolutePair& p) { return p.contact_ratio(); }))
      .doors(kPeople);
  q.pure(kContact, "contact_ratio_crossed_true", "effective contact ratio", "",
         "the path clipped to the usable flanks and faces",
         crossed([](const InvolutePair& p) { return p.contact_ratio_true(); }))
      .doors(kPeople);
  q.pure(kContact, "transverse_contact_ratio", "transverse contact ratio", "ε_α",
         "tip form circle to tip form circle; null on crossed axes",
         [](const V& v) {
           return v.involute() ? Value(v.involute()->transverse_contact_ratio()) : Value(0.0);
         })
      .shown(is_involute);
  q.pure(kContact, "contact_ratio_true", "effective total contact ratio", "",
         "the path clipped to the usable flanks [T2.19], of crossed pairs to the faces too; 0 when "
         "nothing is left of it",
         [](const V& v) -> Value {
           if (v.involute()) return v.involute()->contact_ratio_true();
           return v.arcs()->contacts.empty() ? Value() : Value(v.arcs()->contact_ratio);
         })
      .shown(is_parallel);
  q.pure(kContact, "transverse_contact_ratio_true", "effective transverse contact ratio", "",
         "the path clipped to the usable flanks",
         parallel([](const InvolutePair& p) { return p.mesh.true_ratio; }))
      .doors(kPeople);
  q.pure(kContact, "overlap_ratio", "overlap ratio", "ε_β", "null on crossed axes",
         [](const V& v) -> Value {
           if (v.arcs()) return v.arcs()->overlap_ratio;
           return v.crossed() ? Value() : Value(v.involute()->mesh.overlap_ratio);
         });
  q.mm(kFace, "face_width_for_contact_mm", "minimum face width for continuous contact", "b",
       "circular arcs only: the smallest common face width with a contact point at all times",
       [](const V& v) { return Value(v.arcs()->face_for_contact); })
      .when(is_arcs);
  q.record(kContact, "line_of_action",
           "for circular arcs, the path of the contact point over the common face; null without "
           "contact",
           table_of<line_quantities>,
           [](const V& v) { return record_of(line_quantities(), line_of(v)); })
      .shown(is_involute);
  q.mm(kContact, "base_tangent_distance_mm", "distance of the base tangent points", "N",
       "in the transverse section [T2.14]; crossed: L, along the common normal [T4.19]",
       involute([](const InvolutePair& p) {
         return p.mesh.base_tangent_distance /
                (p.crossed() ? std::cos(p.input.gears[0].helix_angle) : 1.0);
       }))
      .doors(kJson)
      .when(is_involute);
  q.record("", "path", "points of the path of contact", table_of<path_quantities>,
           involute([](const InvolutePair& p) { return path_quantities().of(p); }))
      .doors(kJson)
      .when(is_involute);
  q.record("", "overlap",
           "overlap of the bodies in the middle of the backlash, deepest first [T2.34], on crossed "
           "axes of tips and roots [T4.33]; null: not computed (circular arcs of unequal lead, an "
           "internal gear whose cutter is not known)",
           table_of<collision_quantities>,
           [](const V& v) {
             const auto& overlap = v.mounted().overlap;
             return overlap ? Value(collision_quantities().each(*overlap)) : Value();
           })
      .list({0})
      .doors(kJson);
  q.record("", "beyond_flank", "contact on a root or a tip beyond the flank, without overlap",
           table_of<collision_quantities>,
           [](const V& v) { return Value(collision_quantities().each(v.mounted().beyond_flank)); })
      .always()
      .list({0})
      .doors(kJson);
  q.record("", "interference",
           "what explains an overlap; if overlap is not computed, all findings of circles and "
           "corners",
           table_of<interference_quantities>,
           [](const V& v) { return Value(interference_quantities().each(interference_of(v))); })
      .always()
      .list({0})
      .doors(kJson);
}

void say_clearances(Quantities<V>& q) {
  q.mm(kClearances, "tip_clearance_mm", "tip clearance", "c",
       "tip of gear 1 to root of gear 2, then the other",
       [](const V& v) { return Value(v.mounted().tip_clearance); })
      .per_gear();
  q.mm(kClearances, "contact_root_diameter_mm", "active root diameter", "d_Nf",
       "per gear, where contact starts; null past the base tangent point",
       involute([](const InvolutePair& p) { return p.contact_root_diameter; }))
      .per_gear()
      .when(is_involute)
      .expected(is_involute);
  q.mm(kClearances, "form_clearance_mm", "form clearance at the root", "c_F",
       "per gear, (d_Nf − d_Ff)/2 [T2.25]; null past the base tangent point and without a d_Ff",
       involute([](const InvolutePair& p) { return p.form_clearance; }))
      .per_gear()
      .when(is_involute)
      .expected(is_involute);
  q.mm(kClearances, "fillet_clearance_mm", "fillet clearance to the mating tip corner", "",
       "per gear, least distance [T2.26]; null on crossed axes and "
       "where no corner gets that deep",
       involute([](const InvolutePair& p) { return p.fillet_clearance; }))
      .per_gear()
      .when(is_involute)
      .expected(is_parallel);
  q.mm(kClearances, "tip_shortening_mm", "tip alteration", "k m_n",
       "that would keep the racks' clearance [T2.21], ≤ 0 as a rule",
       involute([](const InvolutePair& p) { return p.tip_shortening; }))
      .when(is_involute);
}

void say_sliding(Quantities<V>& q) {
  q.record(kContact, "specific_sliding",
           "[at A, at E]: sliding distance per mm of contact travel on the flank. Parallel axes "
           "[T2.22]: < 0 where the mating gear drags the flank, null at and beyond a base tangent "
           "point; crossed [T4.25]: of whole velocities, ≥ 0",
           table_of<two_gears>, involute([](const InvolutePair& p) {
             return each_gear(std::array{p.sliding_A.zeta_1, p.sliding_E.zeta_1},
                              std::array{p.sliding_A.zeta_2, p.sliding_E.zeta_2});
           }))
      .doors(kJson);
  q.pure(kContact, "specific_sliding_at_A", "specific sliding at A", "ζ", "per gear",
         involute([](const InvolutePair& p) {
           return std::array{p.sliding_A.zeta_1, p.sliding_A.zeta_2};
         }))
      .per_gear()
      .doors(kPeople)
      .expected(is_involute);
  q.pure(kContact, "specific_sliding_at_E", "specific sliding at E", "ζ", "per gear",
         involute([](const InvolutePair& p) {
           return std::array{p.sliding_E.zeta_1, p.sliding_E.zeta_2};
         }))
      .per_gear()
      .doors(kPeople)
      .expected(is_involute);
  q.record(kFace, "needed_face_width_mm",
           "the face for a total contact ratio of 1 and 1.2, and for an overlap of 1 [T6.14]; null "
           "on crossed axes",
           table_of<needed_face_quantities>,
           parallel([](const InvolutePair& p) { return needed_face_quantities().of(p); }))
      .when(is_involute);
  q.pure(kContact, "approach_contact_ratio", "approach contact ratio", "",
         "before the pitch point, gear 1 driving; null on crossed axes",
         parallel([](const InvolutePair& p) { return approach_and_recess(p)[0]; }))
      .when(is_involute);
  q.pure(kContact, "recess_contact_ratio", "recess contact ratio", "",
         "after the pitch point, gear 1 driving; null on crossed axes",
         parallel([](const InvolutePair& p) { return approach_and_recess(p)[1]; }))
      .when(is_involute);
  q.pure(kContact, "axial_force_ratio", "axial over tangential force", "F_z/F_t",
         "per gear, along +z, while gear 1 drives in its sense [T6.15]; null on crossed axes",
         parallel([](const InvolutePair& p) { return axial_force(p); }))
      .per_gear()
      .when(is_involute)
      .shown([](const V& v) { return v.involute()->input.gears[0].helix_angle != 0.0; });
  q.pure(kBacklash, "backlash_per_center_distance",
         "circumferential backlash per mm of centre "
         "distance",
         "", "[T6.16]; null on crossed axes",
         parallel([](const InvolutePair& p) { return backlash_per_distance(p); }))
      .when(is_involute);
  q.record(kContact, "sliding_velocity_mm_per_rad",
           "speed of the contact over flank 1 less that over flank 2, per radian of gear 1 [T4.24]",
           table_of<sliding_velocity_quantities>,
           involute([](const InvolutePair& p) { return sliding_velocity_quantities().of(p); }))
      .doors(kJson)
      .when(is_involute);
  q.record(
       kContact, "efficiency",
       "by friction of the flanks alone [T4.27]; tooth pairs in contact at one time carry equal "
       "parts of a constant normal force. Null without `friction_coefficient`, and with "
       "`contact_ratio_true` below 1",
       table_of<efficiency_quantities>, involute([](const InvolutePair& p) {
         return record_of(efficiency_quantities(), p.efficiency);
       }))
      .doors(kJson);
  q.add(Type::number, Unit::percent, kContact, "efficiency_driving",
        "efficiency, this gear driving", "η", "per gear",
        [](const V& v) -> Value {
          if (!v.involute() || !v.involute()->efficiency) return {};
          const Efficiency& e = *v.involute()->efficiency;
          return std::array{e.gear1_drives, e.gear2_drives};
        })
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
  q.record(kBacklash, "backlash", "of the flanks as cut at this centre distance",
           table_of<backlash_quantities>,
           [](const V& v) { return record_of(backlash_quantities(), backlash_of(v)); });
  q.record(kMargins, "internal", "internal pairs only", table_of<internal_quantities>,
           involute([](const InvolutePair& p) { return internal_quantities().of(p); }))
      .when([](const V& v) { return v.kind() == PairKind::parallel_internal; });
  q.record("Point of contact", "arc_contacts",
           "circular arcs only: the points of contact; empty for gears of unequal lead",
           table_of<arc_contact_quantities>,
           [](const V& v) { return Value(arc_contact_quantities().each(arc_contacts_of(v))); })
      .list({0})
      .when(is_arcs);
}

}  // namespace

const Quantities<Pair>& pair_quantities() {
  static const Quantities<Pair> kAll("pair", say);
  return kAll;
}

}  // namespace gearwright
