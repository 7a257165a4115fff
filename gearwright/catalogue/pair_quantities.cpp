#include "gearwright/catalogue/gear_quantities.hpp"

#include <cmath>
#include <numbers>

#include "gearwright/base/overloaded.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/pair_parts.hpp"
#include "gearwright/pair/drive.hpp"

namespace gearwright {

namespace {

Value degrees(const std::array<double, 2>& rad) { return std::array{deg(rad[0]), deg(rad[1])}; }

template <class Kind>
const Kind* as(const Pair& v) {
  return v.as<Kind>();
}
template <class Kind>
bool is(const Pair& v) {
  return v.as<Kind>() != nullptr;
}
bool double_helical(const Pair& v) { return v.gear(1).gap.has_value(); }
// Returns an optional part of one kind of pair, or null if the pair has no such part.
template <class Part, class Kind, std::optional<Part> Kind::*part>
const Part* part_of(const Pair& v) {
  const Kind* p = as<Kind>(v);
  return p && p->*part ? &*(p->*part) : nullptr;
}

// Returns a getter with one function for each kind of pair. Without a function, the value is null.
template <class... Of>
auto by_kind(Of... of) {
  return [get = Overloaded{of..., [](const MountedGears&) { return Value(); }}](const Pair& v) {
    return v.visit(get);
  };
}

bool flanks_meet(const Pair& v) { return v.contact_ratio() > 0.0; }

// Returns one angle for each gear in its mesh with the common rack, degrees.
Value of_sides(const InvolutePair& p, double RackSide<double>::*angle) {
  const auto& sides = p.mesh.rack.sides;
  return degrees({sides[0].*angle, sides[1].*angle});
}

std::array<double, 2> working_pitch_diameter(const Pair& v) {
  return v.visit([](const auto& p) { return p.working_pitch_diameter(); });
}

bool has_speed(const Pair& v) { return v.mounted().speed_rpm.has_value(); }

// Returns v_t = π d_w n/60 in m/s, with d_w in mm and n in 1/min. Gear 2 rotates at n_1/|u|.
// Source: ISO 6336-1.
std::array<double, 2> pitch_line_velocity(const Pair& v) {
  const auto d = working_pitch_diameter(v);
  const double turns_1 = v.mounted().speed_rpm.value() / 60.0;
  const double turns_2 = turns_1 / std::abs(v.gear_ratio());
  return {std::numbers::pi * d[0] * turns_1 / kMmPerM, std::numbers::pi * d[1] * turns_2 / kMmPerM};
}

void add_mounting(Quantities<Pair>& q) {
  q.under(kMounting);
  auto of_involutes = q.part(as<InvolutePair>);
  q.word("kind", "kind of pair", "position of the axes",
         [](const Pair& v) { return to_string(v.kind()); })
      .one_of({"parallel_external", "parallel_internal", "crossed"})
      .doors(kJson);
  q.term("gear_ratio", "z2/z1, negative for internal pairs", &Pair::gear_ratio);
  q.term("shaft_angle_deg", "0 on parallel axes", &Pair::shaft_angle).shown(is<CrossedPair>);
  q.term("center_distance_mm", "as mounted", &Pair::center_distance);
  q.number("reference_center_distance_mm", "reference centre distance", "a_d",
           "computed from the reference diameters",
           [](const Pair& v) { return v.mounted().reference_center_distance; });
  of_involutes
      .term("backlash_free_center_distance_mm",
            "for the teeth as cut, including allowances [T2.20], and for crossed axes at the given "
            "shaft angle [T4.11]; null if no centre distance is free of backlash",
            &InvolutePair::backlash_free_center_distance)
      .expected();
  of_involutes.number("extended_center_distance_mm", "extended centre distance", "",
                      "a_d + m_n (x1 + x2), for internal pairs a_d − m_n (x1 + x2) [T2.18]",
                      &InvolutePair::extended_center_distance);
  q.term(
       "working_normal_pressure_angle_deg",
       "for circular arcs the normal angle of the racks at the contact",
       by_kind([](const InvolutePair& p) { return Value(deg(p.mesh.rack.normal_pressure_angle)); },
               [](const ArcPair& p) {
                 return p.contacts.empty() ? Value() : Value(p.first_contact().at.theta.deg());
               }))
      .shown(is<InvolutePair>);
  q.term("working_transverse_pressure_angle_deg", "per gear",
         by_kind(
             [](const InvolutePair& p) { return of_sides(p, &RackSide<double>::transverse_angle); },
             [](const ArcPair& p) {
               return p.contacts.empty()
                          ? Value()
                          : degrees({working_transverse(p, 0), working_transverse(p, 1)});
             }))
      .per_gear()
      .shown(is<InvolutePair>);
  q.number(
       "working_helix_angle_deg", "working helix angle", "β_w", "per gear",
       by_kind([](const InvolutePair& p) { return of_sides(p, &RackSide<double>::helix_angle); },
               [](const ArcPair& p) {
                 return degrees({working_helix(p, 0), working_helix(p, 1)});
               }))
      .per_gear();
  q.number("working_pitch_diameter_mm", "working pitch diameter", "d_w", "per gear",
           working_pitch_diameter)
      .per_gear();
  q.term("pitch_line_velocity_m_per_s",
         "per gear, on the working pitch cylinder; equal for both gears on parallel axes; only "
         "with `speed_rpm`",
         pitch_line_velocity)
      .per_gear()
      .when(has_speed);
  q.number("mesh_frequency_hz", "mesh frequency", "f_z", "z_1 n_1/60; only with `speed_rpm`",
           [](const Pair& v) {
             return v.mounted().gears[0].spec.teeth * v.mounted().speed_rpm.value() / 60.0;
           })
      .when(has_speed);
  of_involutes
      .number("pitch_plane_distance_mm", "distance of the pitch planes", "X",
              "from the centre distance as mounted, including any backlash; 0 on parallel axes",
              [](const InvolutePair& p) { return p.mesh.pitch_plane_distance; })
      .shown(is<CrossedPair>);
}

void add_crossed(Quantities<Pair>& all) {
  auto q = all.part(as<CrossedPair>);
  all.under(kFace);
  q.number("min_face_width_mm", "minimum face width for one flank", "f", "per gear [T4.21]",
           [](const CrossedPair& p) { return p.face_widths.one_flank; })
      .per_gear()
      .shown(flanks_meet);
  q.number("min_face_width_both_flanks_mm", "minimum face width for both flanks", "f'",
           "per gear, symmetrical about the centre line [T4.21]",
           [](const CrossedPair& p) { return p.face_widths.both_flanks; })
      .per_gear()
      .shown(flanks_meet);
  q.record<two_gears_mm>(
       "face_interval_mm",
       "axial positions [at A, at E] of the contact of the leading flanks, measured from the "
       "middle of the face [T4.20]",
       [](const CrossedPair& p) {
         return two_gears_mm().of({p.face_widths.interval[0], p.face_widths.interval[1]});
       })
      .doors(kJson)
      .when(is<InvolutePair>);
  q.number("needed_lead_crowning_um", "minimum lead crowning", "C_β",
           "for each gear, the least lead crowning that keeps the flanks clear of each other "
           "beside the line of action if only this gear is crowned [T4.36]; null if no amount of "
           "crowning on this gear alone is sufficient; given only with an internal gear",
           needed_crowning_um)
      .per_gear()
      .when([](const Pair& v) { return v.mounted().crossed_inside(); });
  all.under(kContact);
  q.number("line_offset_mm", "offset of the line of action", "z_L",
           "distance from the centre line to the leading line of action, along the teeth of the "
           "rack [T4.18]; the trailing line is at −z_L",
           [](const CrossedPair& p) { return p.mesh.line_offset; })
      .doors(kJson)
      .when(is<InvolutePair>);
  all.under("Minimum centre distance, free of backlash");
  q.record<place_quantities>("minimum_center_distance",
                             "position of the gears with the minimum centre distance for the teeth "
                             "as cut [T4.15]; null if the teeth are too thin",
                             &CrossedPair::min_distance);
  all.under("Backlash-free positions with a contact ratio of at least 1");
  q.record<places_quantities>("contact_ratio_range",
                              "range of positions with AE ≥ p_bn [T4.23]; null with an internal "
                              "gear, or if there is no such position",
                              &CrossedPair::contact_ratio_range);
}

void add_contact(Quantities<Pair>& q) {
  q.under(kContact);
  auto of_involutes = q.part(as<InvolutePair>);
  auto of_crossed = q.part(as<CrossedPair>);
  q.term("contact_ratio",
         "ε_α + ε_β; for crossed axes, AE/p_bn; for circular arcs, ε_β times the number of contact "
         "points per tooth; 0 if the teeth do not touch",
         &Pair::contact_ratio)
      .shown([](const Pair& v) { return !is<CrossedPair>(v); });
  // A pair on crossed axes has only one contact ratio. It is not a sum of a transverse contact
  // ratio and an overlap ratio.
  of_crossed
      .number("contact_ratio_crossed", "contact ratio", "ε", "AE/p_bn", &CrossedPair::contact_ratio)
      .doors(kPeople);
  of_crossed
      .number("contact_ratio_crossed_true", "effective contact ratio", "",
              "for the part of the path on the usable flanks and faces",
              &CrossedPair::contact_ratio_true)
      .doors(kPeople);
  q.term("transverse_contact_ratio",
         "for the path between the tip form circles of the two gears; null on crossed axes",
         by_kind([](const ParallelPair& p) { return Value(p.transverse_contact_ratio()); },
                 [](const ArcPair&) { return Value(0.0); }))
      .shown(is<InvolutePair>);
  q.term("contact_ratio_true",
         "for the part of the path on the usable flanks [T2.19] and, for crossed axes, on the "
         "faces; 0 if no part of the path remains",
         by_kind([](const InvolutePair& p) { return Value(p.contact_ratio_true()); },
                 [](const ArcPair& p) {
                   return p.contacts.empty() ? Value() : Value(p.contact_ratio_true());
                 }))
      .shown(is<ParallelPair>);
  q.part(as<ParallelPair>)
      .term("transverse_contact_ratio_true", "for the part of the path on the usable flanks",
            [](const ParallelPair& p) { return p.mesh.true_ratio; })
      .doors(kPeople);
  q.term("overlap_ratio", "null on crossed axes",
         by_kind([](const ParallelPair& p) { return Value(p.mesh.overlap_ratio); },
                 [](const ArcPair& p) { return Value(p.overlap_ratio); }));
  q.under(kFace);
  q.part(as<ArcPair>)
      .number("face_width_for_contact_mm", "minimum face width for continuous contact", "b",
              "smallest common face width at which a contact point exists at all times; for "
              "double-helical gears, the width of one half; only for circular arcs",
              &ArcPair::face_for_contact)
      .when()
      .shown([](const Pair& v) { return !double_helical(v); });
  q.part(as<ArcPair>)
      .number("whole_face_width_for_contact_mm", "minimum face width for continuous contact", "b",
              "for double-helical gears, including both halves and the gap",
              [](const ArcPair& p) { return p.whole_face(p.face_for_contact); })
      .when([](const Pair& v) { return is<ArcPair>(v) && double_helical(v); });
  q.under(kContact);
  q.record<line_quantities>("line_of_action",
                            "line of action or, for circular arcs, path of the contact point over "
                            "the common face; null without contact",
                            line_of)
      .shown(is<InvolutePair>);
  of_involutes
      .number(
          "base_tangent_distance_mm", "distance of the base tangent points", "N",
          "in the transverse section [T2.14]; on crossed axes, distance L along the common normal "
          "[T4.19]",
          [](const InvolutePair& p) { return p.mesh.base_tangent_distance / p.mesh.line_cosine; })
      .doors(kJson)
      .when();
  of_involutes.record<path_quantities>("path", "points of the path of contact").doors(kJson).when();
  q.record<collision_quantities>(
       "overlap",
       "overlaps of the bodies if the gears are in the middle of the backlash, the deepest first "
       "[T2.34]. On crossed axes, these are overlaps of tips and roots [T4.33] and, with an "
       "internal gear, also of tip corners and flanks. The list is null if it was not computed "
       "(circular arcs of unequal lead, internal gear without a given cutter)",
       [](const Pair& v) -> const auto& { return v.mounted().overlap; })
      .list({0})
      .doors(kJson);
  q.record<collision_quantities>("beyond_flank",
                                 "contacts of a root or a tip beyond the flank, without overlap",
                                 [](const Pair& v) { return v.mounted().beyond_flank; })
      .doors(kJson);
  q.record<interference_quantities>("interference",
                                    "causes of an overlap; if `overlap` was not computed, all "
                                    "interferences of circles and corners",
                                    interference_of)
      .doors(kJson);
}

void add_clearances(Quantities<Pair>& q) {
  q.under(kClearances);
  q.term("tip_clearance_mm", "per gear, from its tip to the root of the mating gear",
         [](const Pair& v) { return v.mounted().tip_clearance; })
      .per_gear();
  auto of_involutes = q.part(as<InvolutePair>);
  of_involutes
      .number("contact_root_diameter_mm", "active root diameter", "d_Nf",
              "per gear, diameter at which contact starts; null if contact starts beyond the base "
              "tangent point",
              &InvolutePair::contact_root_diameter)
      .per_gear()
      .when()
      .expected();
  of_involutes
      .number("form_clearance_mm", "form clearance at the root", "c_F",
              "per gear, (d_Nf − d_Ff)/2 [T2.25]; null if d_Nf or d_Ff is null",
              &InvolutePair::form_clearance)
      .per_gear()
      .when()
      .expected();
  q.number(
       "fillet_clearance_mm", "clearance of root fillet to mating tip corner", "",
       "per gear, least distance of the fillet from the tip corner of the mating gear [T2.26]; "
       "null on crossed axes, or if no corner reaches the fillet",
       by_kind([](const ParallelPair& p) { return Value(p.fillet_clearance); },
               [](const CrossedPair&) { return Value(std::array<std::optional<double>, 2>{}); }))
      .per_gear()
      .when(is<InvolutePair>)
      .expected(is<ParallelPair>);
  of_involutes
      .number("tip_shortening_mm", "tip alteration for full tip clearance", "k m_n",
              "alteration with which the tips have the clearance of the racks [T2.21], usually "
              "negative or 0; the tips have it only with `shorten_tips`",
              &InvolutePair::tip_shortening)
      .when();
}

void add_sliding(Quantities<Pair>& q) {
  q.under(kContact);
  auto of_involutes = q.part(as<InvolutePair>);
  add_sliding(
      of_involutes,
      "sliding distance [at A, at E] per mm that the contact travels on the flank. If a flank is "
      "undercut, A or E is the end of the path of `contact_ratio_true`. On parallel axes [T2.22], "
      "the value is negative where the mating gear drags the flank, and null at a base tangent "
      "point and beyond it. On crossed axes [T4.25], it is the ratio of the magnitudes of the "
      "velocities",
      [](const InvolutePair& p) {
        const auto &a = p.sliding_A, &e = p.sliding_E;
        return SlidingAtEnds{{{a.zeta_1, e.zeta_1}, {a.zeta_2, e.zeta_2}}};
      });
}

void add_parallel(Quantities<Pair>& all) {
  auto q = all.part(as<ParallelPair>);
  all.under(kFace);
  q.record<needed_face_quantities>(
       "needed_face_width_mm",
       "face widths for total contact ratios of 1 and 1.2, and for an overlap ratio of 1 [T6.14]; "
       "for double-helical gears, the widths of one half, and also the widths that include both "
       "halves and the gap; null on crossed axes")
      .when(is<InvolutePair>);
  all.under(kContact);
  q.term("approach_contact_ratio",
         "contact ratio before the pitch point, with gear 1 driving; null on crossed axes",
         [](const ParallelPair& p) { return approach_and_recess(p)[0]; })
      .when(is<InvolutePair>);
  q.term("recess_contact_ratio",
         "contact ratio after the pitch point, with gear 1 driving; null on crossed axes",
         [](const ParallelPair& p) { return approach_and_recess(p)[1]; })
      .when(is<InvolutePair>);
  q.number("axial_force_ratio", "axial force divided by tangential force", "F_z/F_t",
           "per gear, along +z, if gear 1 drives in its sense of rotation [T6.15]; for "
           "double-helical gears, the value of a single half, because the forces of the two halves "
           "balance each other; null on crossed axes",
           axial_force)
      .per_gear()
      .when(is<InvolutePair>)
      .shown([](const Pair& v) { return v.gear(1).spec.helix_angle.rad() != 0.0; });
  all.under(kBacklash);
  q.number("backlash_per_center_distance", "circumferential backlash per centre distance", "",
           "[T6.16]; negative for internal pairs; null on crossed axes", backlash_per_distance)
      .when(is<InvolutePair>);
}

void add_friction(Quantities<Pair>& q) {
  q.under(kContact);
  auto of_involutes = q.part(as<InvolutePair>);
  of_involutes
      .record<sliding_velocity_quantities>(
          "sliding_velocity_mm_per_rad",
          "speed of the contact along flank 1 minus the speed along flank 2, per radian of gear 1 "
          "[T4.24]")
      .doors(kJson)
      .when();
  add_efficiency(q, part_of<Efficiency, InvolutePair, &InvolutePair::efficiency>);
}

void add_pair(Quantities<Pair>& q) {
  q.groups({kMounting, kContact, kBacklash, kClearances, kFace});
  add_mounting(q);
  add_crossed(q);
  add_contact(q);
  add_clearances(q);
  add_sliding(q);
  add_parallel(q);
  add_friction(q);
  q.under(kBacklash);
  q.record<backlash_quantities>(
      "backlash", "backlash of the flanks as cut, at this centre distance", backlash_of);
  q.under(kMargins);
  q.part(part_of<InternalMargins, ParallelPair, &ParallelPair::margins>)
      .record<internal_quantities>("internal", "margins of internal pairs; absent for other pairs")
      .when();
  q.under("Point of contact");
  q.part(as<ArcPair>)
      .record<arc_contact_quantities>(
          "arc_contacts",
          "points of contact, only for circular arcs; empty for gears of unequal lead",
          arc_contacts_of)
      .when();
}

}  // namespace

const Quantities<Pair>& pair_quantities() { return define<add_pair>("pair"); }

}  // namespace gearwright
