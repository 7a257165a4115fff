#include "gearwright/catalogue/pair_quantities.hpp"

#include <cmath>
#include <numbers>

#include "gearwright/base/overloaded.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/pair_parts.hpp"
#include "gearwright/pair/drive.hpp"

namespace gearwright {

namespace {

using V = Pair;

double deg(double rad) { return Angle::radians(rad).deg(); }
Value degrees(const std::array<double, 2>& rad) { return std::array{deg(rad[0]), deg(rad[1])}; }

// The pair as a kind, or as what several kinds have.
template <class Kind>
const Kind* as(const V& v) {
  return v.as<Kind>();
}
template <class Kind>
bool is(const V& v) {
  return v.as<Kind>() != nullptr;
}
const InternalMargins* margins_of(const V& v) {
  const ParallelPair* p = v.parallel();
  return p && p->margins ? &*p->margins : nullptr;
}
const Efficiency* efficiency_of(const V& v) {
  const InvolutePair* p = v.involute();
  return p && p->efficiency ? &*p->efficiency : nullptr;
}

// A getter with one function for each kind.
template <class... Of>
auto by_kind(Of... of) {
  return [get = Overloaded{of...}](const V& v) { return v.visit(get); };
}

// The table of a sub-catalogue, and its record of something that may not be there.
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

bool flanks_meet(const V& v) {
  const InvolutePair* p = v.involute();
  return p && p->flanks_meet();
}

// The number of each gear of its side of the rack, rad.
Value of_sides(const InvolutePair& p, double RackSide<double>::*angle) {
  const auto& sides = p.mesh.rack.sides;
  return degrees({sides[0].*angle, sides[1].*angle});
}

std::array<double, 2> working_pitch_diameter(const V& v) {
  return v.visit([](const auto& p) { return p.working_pitch_diameter(); });
}

// v_t = π d_w n/60 in m/s of d_w in mm and n in 1/min; gear 2 turns at n_1/|u|. ISO 6336-1.
std::array<double, 2> pitch_line_velocity(const V& v) {
  const auto d = working_pitch_diameter(v);
  const double turns_1 = v.mounted().speed_rpm.value() / 60.0;
  const double turns_2 = turns_1 / std::abs(v.gear_ratio());
  return {std::numbers::pi * d[0] * turns_1 / kMmPerM, std::numbers::pi * d[1] * turns_2 / kMmPerM};
}

void say_mounting(Quantities<V>& q) {
  auto of_involutes = q.part(as<InvolutePair>);
  q.word(kMounting, "kind", "kind of pair", "how the axes lie",
         [](const V& v) { return Value(to_string(v.kind())); })
      .always()
      .one_of({"parallel_external", "parallel_internal", "crossed"})
      .doors(kJson);
  q.pure(kMounting, "gear_ratio", "gear ratio", "u", "z2/z1, negative for internal pairs",
         [](const V& v) { return Value(v.gear_ratio()); })
      .always();
  q.deg(kMounting, "shaft_angle_deg", "shaft angle", "Σ", "0 on parallel axes",
        [](const V& v) { return Value(v.shaft_angle().deg()); })
      .always()
      .shown(is<CrossedPair>);
  q.mm(kMounting, "center_distance_mm", "centre distance", "a", "as mounted", [](const V& v) {
     return Value(v.center_distance());
   }).always();
  q.mm(kMounting, "reference_center_distance_mm", "reference centre distance", "a_d",
       "from the reference diameters",
       [](const V& v) { return Value(v.mounted().reference_center_distance); })
      .always();
  of_involutes
      .mm(kMounting, "backlash_free_center_distance_mm", "backlash-free centre distance", "",
          "of the teeth as cut, allowances included [T2.20]; crossed: at this Σ [T4.11]; null: "
          "there is none",
          [](const InvolutePair& p) { return Value(p.backlash_free_center_distance); })
      .expected(is<InvolutePair>);
  of_involutes.mm(kMounting, "extended_center_distance_mm", "extended centre distance", "",
                  "the reference one and both profile shifts [T2.18]",
                  [](const InvolutePair& p) { return Value(p.extended_center_distance); });
  q.deg(kMounting, "working_normal_pressure_angle_deg", "working normal pressure angle", "α_wn",
        "of circular arcs the racks' normal angle at the contact",
        by_kind([](const InvolutePair& p) { return Value(deg(p.mesh.rack.normal_pressure_angle)); },
                [](const ArcPair& p) {
                  return p.contacts.empty() ? Value() : Value(p.first_contact().at.theta.deg());
                }))
      .shown(is<InvolutePair>);
  q.deg(kMounting, "working_transverse_pressure_angle_deg", "working transverse pressure angle",
        "α_wt", "per gear",
        by_kind(
            [](const InvolutePair& p) { return of_sides(p, &RackSide<double>::transverse_angle); },
            [](const ArcPair& p) {
              return p.contacts.empty()
                         ? Value()
                         : degrees({working_transverse(p, 0), working_transverse(p, 1)});
            }))
      .per_gear()
      .shown(is<InvolutePair>);
  q.deg(kMounting, "working_helix_angle_deg", "working helix angle", "β_w", "per gear",
        by_kind([](const InvolutePair& p) { return of_sides(p, &RackSide<double>::helix_angle); },
                [](const ArcPair& p) {
                  return degrees({working_helix(p, 0), working_helix(p, 1)});
                }))
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
  of_involutes
      .mm(kMounting, "pitch_plane_distance_mm", "distance of the pitch planes", "X",
          "as mounted, backlash or not; 0 on parallel axes",
          [](const InvolutePair& p) { return Value(p.mesh.pitch_plane_distance); })
      .shown(is<CrossedPair>);
}

// Null on parallel axes.
void say_crossed(Quantities<V>& all) {
  auto q = all.part(as<CrossedPair>);
  q.mm(kFace, "min_face_width_mm", "minimum face width, one flank", "f", "per gear [T4.21]",
       [](const CrossedPair& p) { return Value(p.face_widths.one_flank); })
      .per_gear()
      .shown(flanks_meet);
  q.mm(kFace, "min_face_width_both_flanks_mm", "minimum face width, both flanks", "f'",
       "per gear, about the centre line [T4.21]",
       [](const CrossedPair& p) { return Value(p.face_widths.both_flanks); })
      .per_gear()
      .shown(flanks_meet);
  q.record(kFace, "face_interval_mm",
           "[at A, at E]: where on the face the leading flanks touch, from its middle [T4.20]",
           table_of<two_gears>,
           [](const CrossedPair& p) {
             return each_gear(p.face_widths.interval[0], p.face_widths.interval[1]);
           })
      .doors(kJson)
      .when(is<InvolutePair>);
  q.mm(kContact, "line_offset_mm", "offset of the line of action", "z_L",
       "distance of the leading line of action from the centre line along the teeth of the rack "
       "[T4.18]; the trailing line is at −z_L",
       [](const CrossedPair& p) { return Value(p.mesh.line_offset); })
      .doors(kJson)
      .when(is<InvolutePair>);
  q.record("Minimum centre distance, free of backlash", "minimum_center_distance",
           "of the teeth as cut [T4.15]; null: the teeth are too thin", table_of<place_quantities>,
           [](const CrossedPair& p) { return record_of(place_quantities(), p.min_distance); });
  q.record(
      "Contact ratio of 1 and more, free of backlash", "contact_ratio_range",
      "where AE ≥ p_bn [T4.23]; null: nowhere", table_of<places_quantities>,
      [](const CrossedPair& p) { return record_of(places_quantities(), p.contact_ratio_range); });
}

void say_contact(Quantities<V>& q) {
  auto of_involutes = q.part(as<InvolutePair>);
  auto of_crossed = q.part(as<CrossedPair>);
  q.pure(kContact, "contact_ratio", "total contact ratio", "ε_γ",
         "ε_α + ε_β, crossed AE/p_bn; 0 when the teeth do not meet; of circular arcs ε_β times the "
         "points of contact per tooth",
         [](const V& v) { return Value(v.contact_ratio()); })
      .always()
      .shown([](const V& v) { return !is<CrossedPair>(v); });
  // Crossed axes have one contact ratio: there is no transverse one to add an overlap to.
  of_crossed
      .pure(kContact, "contact_ratio_crossed", "contact ratio", "ε", "AE/p_bn",
            [](const CrossedPair& p) { return Value(p.contact_ratio()); })
      .doors(kPeople);
  of_crossed
      .pure(kContact, "contact_ratio_crossed_true", "effective contact ratio", "",
            "the path clipped to the usable flanks and faces",
            [](const CrossedPair& p) { return Value(p.contact_ratio_true()); })
      .doors(kPeople);
  q.pure(kContact, "transverse_contact_ratio", "transverse contact ratio", "ε_α",
         "tip form circle to tip form circle; null on crossed axes",
         by_kind([](const ParallelPair& p) { return Value(p.transverse_contact_ratio()); },
                 [](const CrossedPair&) { return Value(); },
                 [](const ArcPair&) { return Value(0.0); }))
      .shown(is<InvolutePair>);
  q.pure(kContact, "contact_ratio_true", "effective total contact ratio", "",
         "the path clipped to the usable flanks [T2.19], of crossed pairs to the faces too; 0 when "
         "nothing is left of it",
         by_kind([](const InvolutePair& p) { return Value(p.contact_ratio_true()); },
                 [](const ArcPair& p) {
                   return p.contacts.empty() ? Value() : Value(p.contact_ratio_true());
                 }))
      .shown(is<ParallelPair>);
  q.part(as<ParallelPair>)
      .pure(kContact, "transverse_contact_ratio_true", "effective transverse contact ratio", "",
            "the path clipped to the usable flanks",
            [](const ParallelPair& p) { return Value(p.mesh.true_ratio); })
      .doors(kPeople);
  q.pure(kContact, "overlap_ratio", "overlap ratio", "ε_β", "null on crossed axes",
         by_kind([](const ParallelPair& p) { return Value(p.mesh.overlap_ratio); },
                 [](const CrossedPair&) { return Value(); },
                 [](const ArcPair& p) { return Value(p.overlap_ratio); }));
  q.part(as<ArcPair>)
      .mm(kFace, "face_width_for_contact_mm", "minimum face width for continuous contact", "b",
          "circular arcs only: the smallest common face width with a contact point at all times",
          [](const ArcPair& p) { return Value(p.face_for_contact); })
      .when(is<ArcPair>);
  q.record(kContact, "line_of_action",
           "for circular arcs, the path of the contact point over the common face; null without "
           "contact",
           table_of<line_quantities>,
           [](const V& v) { return record_of(line_quantities(), line_of(v)); })
      .shown(is<InvolutePair>);
  of_involutes
      .mm(kContact, "base_tangent_distance_mm", "distance of the base tangent points", "N",
          "in the transverse section [T2.14]; crossed: L, along the common normal [T4.19]",
          [](const InvolutePair& p) {
            return Value(p.mesh.base_tangent_distance / p.mesh.line_cosine);
          })
      .doors(kJson)
      .when(is<InvolutePair>);
  of_involutes
      .record("", "path", "points of the path of contact", table_of<path_quantities>,
              [](const InvolutePair& p) { return path_quantities().of(p); })
      .doors(kJson)
      .when(is<InvolutePair>);
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
  auto of_involutes = q.part(as<InvolutePair>);
  of_involutes
      .mm(kClearances, "contact_root_diameter_mm", "active root diameter", "d_Nf",
          "per gear, where contact starts; null past the base tangent point",
          [](const InvolutePair& p) { return Value(p.contact_root_diameter); })
      .per_gear()
      .when(is<InvolutePair>)
      .expected(is<InvolutePair>);
  of_involutes
      .mm(kClearances, "form_clearance_mm", "form clearance at the root", "c_F",
          "per gear, (d_Nf − d_Ff)/2 [T2.25]; null past the base tangent point and without a d_Ff",
          [](const InvolutePair& p) { return Value(p.form_clearance); })
      .per_gear()
      .when(is<InvolutePair>)
      .expected(is<InvolutePair>);
  q.part(as<ParallelPair>)
      .mm(kClearances, "fillet_clearance_mm", "fillet clearance to the mating tip corner", "",
          "per gear, least distance [T2.26]; null on crossed axes and "
          "where no corner gets that deep",
          [](const ParallelPair& p) { return Value(p.fillet_clearance); })
      .per_gear()
      .when(is<InvolutePair>)
      .expected(is<ParallelPair>);
  of_involutes
      .mm(kClearances, "tip_shortening_mm", "tip alteration", "k m_n",
          "that would keep the racks' clearance [T2.21], ≤ 0 as a rule",
          [](const InvolutePair& p) { return Value(p.tip_shortening); })
      .when(is<InvolutePair>);
}

void say_sliding(Quantities<V>& all) {
  auto q = all.part(as<InvolutePair>);
  q.record(kContact, "specific_sliding",
           "[at A, at E]: sliding distance per mm of contact travel on the flank. Parallel axes "
           "[T2.22]: < 0 where the mating gear drags the flank, null at and beyond a base tangent "
           "point; crossed [T4.25]: of whole velocities, ≥ 0",
           table_of<two_gears>,
           [](const InvolutePair& p) {
             return each_gear(std::array{p.sliding_A.zeta_1, p.sliding_E.zeta_1},
                              std::array{p.sliding_A.zeta_2, p.sliding_E.zeta_2});
           })
      .doors(kJson);
  q.pure(kContact, "specific_sliding_at_A", "specific sliding at A", "ζ", "per gear",
         [](const InvolutePair& p) {
           return Value(std::array{p.sliding_A.zeta_1, p.sliding_A.zeta_2});
         })
      .per_gear()
      .doors(kPeople)
      .expected(is<InvolutePair>);
  q.pure(kContact, "specific_sliding_at_E", "specific sliding at E", "ζ", "per gear",
         [](const InvolutePair& p) {
           return Value(std::array{p.sliding_E.zeta_1, p.sliding_E.zeta_2});
         })
      .per_gear()
      .doors(kPeople)
      .expected(is<InvolutePair>);
}

// Null on crossed axes.
void say_parallel(Quantities<V>& all) {
  auto q = all.part(as<ParallelPair>);
  q.record(kFace, "needed_face_width_mm",
           "the face for a total contact ratio of 1 and 1.2, and for an overlap of 1 [T6.14]; null "
           "on crossed axes",
           table_of<needed_face_quantities>,
           [](const ParallelPair& p) { return needed_face_quantities().of(p); })
      .when(is<InvolutePair>);
  q.pure(kContact, "approach_contact_ratio", "approach contact ratio", "",
         "before the pitch point, gear 1 driving; null on crossed axes",
         [](const ParallelPair& p) { return Value(approach_and_recess(p)[0]); })
      .when(is<InvolutePair>);
  q.pure(kContact, "recess_contact_ratio", "recess contact ratio", "",
         "after the pitch point, gear 1 driving; null on crossed axes",
         [](const ParallelPair& p) { return Value(approach_and_recess(p)[1]); })
      .when(is<InvolutePair>);
  q.pure(kContact, "axial_force_ratio", "axial over tangential force", "F_z/F_t",
         "per gear, along +z, while gear 1 drives in its sense [T6.15]; null on crossed axes",
         [](const ParallelPair& p) { return Value(axial_force(p)); })
      .per_gear()
      .when(is<InvolutePair>)
      .shown([](const V& v) { return v.gear(1).spec.helix_angle.rad() != 0.0; });
  q.pure(kBacklash, "backlash_per_center_distance",
         "circumferential backlash per mm of centre "
         "distance",
         "", "[T6.16]; null on crossed axes",
         [](const ParallelPair& p) { return Value(backlash_per_distance(p)); })
      .when(is<InvolutePair>);
}

void say_friction(Quantities<V>& q) {
  q.part(as<InvolutePair>)
      .record(kContact, "sliding_velocity_mm_per_rad",
              "speed of the contact over flank 1 less that over flank 2, per radian of gear 1 "
              "[T4.24]",
              table_of<sliding_velocity_quantities>,
              [](const InvolutePair& p) { return sliding_velocity_quantities().of(p); })
      .doors(kJson)
      .when(is<InvolutePair>);
  auto of_efficiency = q.part(efficiency_of);
  of_efficiency
      .record(
          kContact, "efficiency",
          "by friction of the flanks alone [T4.27]; tooth pairs in contact at one time carry equal "
          "parts of a constant normal force. Null without `friction_coefficient`, and with "
          "`contact_ratio_true` below 1",
          table_of<efficiency_quantities>,
          [](const Efficiency& e) { return efficiency_quantities().of(e); })
      .doors(kJson);
  of_efficiency
      .number(Unit::percent, kContact, "efficiency_driving", "efficiency, this gear driving", "η",
              "per gear",
              [](const Efficiency& e) {
                return Value(std::array{e.gear1_drives, e.gear2_drives});
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
  say_parallel(q);
  say_friction(q);
  q.record(kBacklash, "backlash", "of the flanks as cut at this centre distance",
           table_of<backlash_quantities>,
           [](const V& v) { return record_of(backlash_quantities(), backlash_of(v)); });
  q.part(margins_of)
      .record(kMargins, "internal", "internal pairs only", table_of<internal_quantities>,
              [](const InternalMargins& m) { return internal_quantities().of(m); })
      .when([](const V& v) { return margins_of(v) != nullptr; });
  q.part(as<ArcPair>)
      .record("Point of contact", "arc_contacts",
              "circular arcs only: the points of contact; empty for gears of unequal lead",
              table_of<arc_contact_quantities>,
              [](const ArcPair& p) { return arc_contact_quantities().each(arc_contacts_of(p)); })
      .list({0})
      .when(is<ArcPair>);
}

}  // namespace

const Quantities<Pair>& pair_quantities() {
  static const Quantities<Pair> kAll("pair", say);
  return kAll;
}

}  // namespace gearwright
