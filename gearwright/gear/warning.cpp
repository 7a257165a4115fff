#include "gearwright/gear/warning.hpp"

namespace gearwright {

namespace {

using C = WarningCode;
constexpr Severity kProblem = Severity::problem;
constexpr Severity kCaution = Severity::caution;
constexpr Severity kNote = Severity::note;
constexpr bool kGearUnnamed = true;

constexpr std::array<WarningMeaning, kWarningCodes> kRows{{
    {C::contact_lost, "contact_lost", kProblem,
     "at some positions, no tooth pair touches (verbs `contact`, `load` and `compensate`)",
     "contact is lost at some positions"},
    {C::through_axis, "through_axis", kProblem,
     "the cutter passes through the axis of the gear, so the gear has no outline",
     "the cutter passes through the axis"},
    {C::severed, "severed", kProblem,
     "the root fillets of both sides meet below the tip, so the gear has no outline",
     "the teeth are cut off at their roots"},
    {C::no_body, "no_body", kProblem,
     "the bore or its keyway reaches the roots (or the groove of a double-helical gear), or the "
     "rim of an internal gear does not enclose its roots",
     "a bore leaves no gear body"},
    {C::no_flank, "no_flank", kProblem, "no usable involute is left between root fillet and tip",
     "a gear has no usable flank"},
    {C::no_contact, "no_contact", kProblem,
     "the teeth do not touch, or they touch only outside the usable flanks or (on crossed axes) "
     "outside the faces. On crossed axes, the level is amber if the computed contact is never lost",
     "the flanks have no conjugate contact"},
    {C::jam, "jam", kProblem,
     "both flanks of a tooth space, or root fillets and flanks, are in contact at the same time "
     "(verb `contact`); the message gives the angle by which gear 2 would have to yield",
     "the gears jam"},
    {C::negative_backlash, "negative_backlash", kProblem,
     "the teeth are too thick for the centre distance",
     "the teeth are too thick for this centre distance"},
    {C::contact_ratio, "contact_ratio", kProblem,
     "ε_γ (on crossed axes, AE/p_bn) is below 1 for the part of the path on the usable flanks",
     "contact is not continuous"},
    {C::load_unfinished, "load_unfinished", kProblem,
     "at some positions the forces do not converge (verbs `load` and `compensate`); these "
     "positions have no results",
     "some positions under load have no result"},
    {C::interference, "interference", kProblem,
     "circular-arc flanks cut into each other at the contact; there is also an entry in "
     "`interference`",
     "the flanks cut into each other"},
    {C::contact_off_flank, "contact_off_flank", kProblem,
     "the contact of circular-arc teeth lies outside the usable flanks at this centre distance",
     "the teeth touch outside their usable flanks"},
    {C::root, "root", kProblem, "a tip reaches below the mating gear's root circle",
     "a tip cuts into the mating gear’s root"},
    {C::base_tangent, "base_tangent", kProblem,
     "the mating gear's tip passes the base tangent point",
     "a tip reaches a place where the mating gear has no involute"},
    {C::form_circle, "form_circle", kProblem, "the mating gear's tip touches below d_Ff [T2.25]",
     "a tip reaches below the mating gear’s usable flank"},
    {C::tip_to_fillet, "tip_to_fillet", kProblem,
     "the mating gear's tip corner cuts into the root fillet [T2.26]",
     "a tip corner cuts into a root fillet"},
    {C::trochoid, "trochoid", kProblem,
     "the tip of the pinion collides with the tip of the internal gear on entry or exit [T2.27]",
     "the tips collide"},
    {C::overlap, "overlap", kProblem,
     "the outlines overlap, and no other code explains the overlap", "the teeth overlap"},
    {C::root_safety, "root_safety", kCaution,
     "a safety factor against root breakage is below the required value; if it is below 1, the "
     "level is red",
     "the safety against root breakage is too small"},
    {C::flank_safety, "flank_safety", kCaution,
     "a safety factor against pitting is below the required value; if it is below 1, the level is "
     "red",
     "the safety against pitting is too small"},
    {C::spectrum_safety, "spectrum_safety", kCaution,
     "a safety factor under the load spectrum is below the required value; if it is below 1, the "
     "level is red",
     "a safety under the load spectrum is too small"},
    {C::samples_jam, "samples_jam", kCaution,
     "the gears jam in some samples (verb `scatter`); the message gives the least play of all "
     "samples",
     "the gears jam at some deviations within the tolerances",
     "Give thickness allowances, a series of DIN 3967 or narrower tolerances."},
    {C::samples_lose_contact, "samples_lose_contact", kCaution,
     "at some positions of some samples, no tooth pair touches (verb `scatter`)",
     "contact is lost at some deviations within the tolerances"},
    {C::samples_touch_edges, "samples_touch_edges", kCaution,
     "an edge touches in more than 5 % of the samples (verb `scatter`)",
     "edges touch at many deviations within the tolerances",
     "Give crowning or end relief (computed by [scatter.robust]), or give narrower tolerances."},
    {C::contact_lost_to_undercut, "contact_lost_to_undercut", kCaution,
     "the tip of the mating gear passes a part of the flank that undercut has removed; the teeth "
     "do not collide, but contact ends earlier",
     "contact is lost where undercut has removed the flank"},
    {C::beyond_flank, "beyond_flank", kCaution,
     "other parts of the teeth touch before the flanks do; they are listed in the entry "
     "beyond_flank of the result",
     "teeth meet beyond their flanks, where the transmission ratio is not constant"},
    {C::saddle_gap, "saddle_gap", kCaution,
     "with an internal gear on crossed axes, the flanks overlap beside the line of action, so that "
     "edges touch; the message gives the lead crowning that prevents the overlap [T4.36]",
     "the flanks overlap beside the line of action"},
    {C::contact_below_form, "contact_below_form", kCaution,
     "on a gear without undercut, the mating gear's tip passes the end of the usable flank and "
     "enters the root fillet (verb `contact`)",
     "a tip enters a root fillet"},
    {C::fillet_contact, "fillet_contact", kCaution,
     "under the errors, a tip meets the root fillet of the mating gear before the flanks meet "
     "(verb `contact`); the message gives the amount, the position and the flanks (working or "
     "non-working)",
     "a tip meets a root fillet"},
    {C::edge_carries, "edge_carries", kCaution,
     "an edge of a tooth carries load (verbs `load` and `compensate`); the pressure there is a "
     "lower bound, and the root stress depends on the number of slices",
     "an edge carries load",
     "Give more tip relief and lead crowning; for spur and single-helical gears on parallel axes, "
     "the command `gearwright propose` computes these modifications and shows their effect."},
    {C::edge_contact, "edge_contact", kCaution,
     "an edge is in contact; the message gives the share of the rotation with edge contact",
     "an edge touches"},
    {C::no_tip_clearance, "no_tip_clearance", kCaution,
     "a tip has no clearance to the mating gear's root, because one gear has cut the other",
     "a tip without clearance to the root of the mating gear"},
    {C::beyond_hertz, "beyond_hertz", kCaution,
     "the half width of the contact is more than a tenth of the radius of relative curvature (verb "
     "`load`)",
     "the contact is outside the range of Hertz’ formulas"},
    {C::nearly_parallel, "nearly_parallel", kCaution,
     "the axes cross at less than 1°; the message gives the helix angle that parallel axes need",
     "the axes cross at a small angle"},
    {C::face_width, "face_width", kCaution,
     "on crossed axes, the lines of action run beyond the face; the message gives the required "
     "face width f′",
     "a face is too narrow for the line of action"},
    {C::undercut, "undercut", kCaution,
     "the profile shift x_E is less than the minimum that avoids undercut", "undercut", "",
     kGearUnnamed},
    {C::pointed, "pointed", kCaution,
     "the flanks of the gear, or of its own cutter (`cut_by`), meet before the tip diameter",
     "pointed teeth", "", kGearUnnamed},
    {C::thin_tip, "thin_tip", kCaution, "the tip thickness s_an is less than 0.2 m_n", "a thin tip",
     "", kGearUnnamed},
    {C::tip_below_base, "tip_below_base", kCaution,
     "d_a of an internal gear is less than d_b, so the involute does not reach the tip",
     "a tip inside the base circle", "", kGearUnnamed},
    {C::trimming, "trimming", kCaution,
     "the pinion of an internal pair can be mounted only axially [T2.28], although the mounted "
     "gears do not collide; or, in radial infeed, the cutter of an internal gear (`cut_by`) "
     "removes the tips [T6.18]",
     "trimming interference in radial assembly or infeed", "", kGearUnnamed},
    {C::tip_margin, "tip_margin", kCaution, "the tip clearance is less than 0.1 modules",
     "a small tip clearance"},
    {C::form_margin, "form_margin", kCaution,
     "the form clearance at the root is less than 0.01 modules", "a small form clearance"},
    {C::fillet_margin, "fillet_margin", kCaution,
     "the clearance of the mating gear's tip corner to the root fillet is less than 0.0001 modules",
     "a tip corner close to a root fillet"},
    {C::contact_place, "contact_place", kCaution,
     "under the errors, the distance of the contact from the middle of the face is more than 0.7 "
     "of half the face width",
     "the contact lies near the end of the face"},
    {C::thickened_for_backlash, "thickened_for_backlash", kCaution,
     "the centre distance leaves more backlash than given, so the teeth are made thicker than "
     "their profile shifts require",
     "teeth thickened for the backlash"},
    {C::hob_run_out, "hob_run_out", kCaution,
     "the gap between the halves of a double-helical gear is too narrow for the run-out of the hob "
     "[T2.43]",
     "a gap too narrow for the hob"},
    {C::stagger_without_gap, "stagger_without_gap", kCaution,
     "the halves of a double-helical gear are staggered, and no gap separates them, so files of "
     "the gear cannot be written",
     "staggered halves without a gap"},
    {C::no_outline, "no_outline", kCaution,
     "no CAD files are written for a gear without an outline (teeth cut off, cutter through the "
     "axis, internal gear that no default cutter can generate)",
     "a gear without an outline", "", kGearUnnamed},
    {C::no_corrections, "no_corrections", kCaution,
     "corrections cannot be computed for this spec (verb `run`); the message gives the reason",
     "no corrections"},
    {C::no_strength, "no_strength", kCaution,
     "the strength cannot be computed, because the rating needs the load along the teeth (verb "
     "`run`); the message gives the reason",
     "no strength"},
    {C::ellipse_beyond_flank, "ellipse_beyond_flank", kCaution,
     "the contact ellipse extends beyond an end of the flank, and the pressure there is a lower "
     "bound (verb `load`)",
     "a contact ellipse beyond the flank"},
    {C::rating_root_fillet, "rating_root_fillet", kCaution,
     "the standard does not cover a circular root fillet, so Y_F and Y_S are computed for the root "
     "that the rack would cut",
     "a root that the standard does not describe", "", kGearUnnamed},
    {C::contact_search_unfinished, "contact_search_unfinished", kCaution,
     "some searches for a contact point did not converge (verb `contact`)",
     "positions without an exact contact point", "Choose other positions."},
    {C::correction_at_bound, "correction_at_bound", kCaution,
     "a correction is at the end of the searched range (verb `compensate`)",
     "a correction at its bound", "Align the axes more accurately."},
    {C::rack_not_used, "rack_not_used", kCaution,
     "some dimensions of the rack have no effect on an internal gear",
     "dimensions of a rack that have no effect", "Leave out these dimensions of the rack.",
     kGearUnnamed},
    {C::default_shaft_angle, "default_shaft_angle", kCaution,
     "the axes cross at the angle of the minimum centre distance, because no shaft angle is given",
     "a default shaft angle", "Give the shaft angle, or equal helix angles of opposite hand."},
    {C::pressure_angle, "pressure_angle", kCaution,
     "circular-arc flanks touch at a pressure angle that differs from the angle of the rack",
     "a pressure angle that does not match the rack",
     "Leave out the pressure angle, or write the angle at which the flanks touch.", kGearUnnamed},
    {C::unequal_lead, "unequal_lead", kCaution,
     "the leads of circular-arc gears do not match, so their contacts are not computed",
     "unequal leads", "The command `gearwright contact` computes where the teeth touch."},
    {C::rating_contact_ratio, "rating_contact_ratio", kCaution,
     "the transverse contact ratio is outside 1 to 2.5, the range of ISO 6336",
     "a contact ratio that the standard does not cover"},
    {C::rating_helix_angle, "rating_helix_angle", kCaution,
     "the helix angle is greater than 30°, the limit of the range for which ISO 6336 is confirmed",
     "a helix angle that the standard does not cover"},
    {C::rating_pressure_angle, "rating_pressure_angle", kCaution,
     "the normal pressure angle is outside the range of 15° to 25° for which ISO 6336 is confirmed",
     "a pressure angle that the standard does not cover"},
    {C::rating_stiffness, "rating_stiffness", kCaution,
     "the profile shifts are outside the range of the formula for the tooth stiffness c'",
     "profile shifts outside the range of the formula for the tooth stiffness"},
    {C::rating_resonance, "rating_resonance", kCaution,
     "the pinion runs in the main resonance of the mesh, N_S < N ≤ 1.15",
     "a speed in the main resonance"},
    {C::rating_mounting, "rating_mounting", kCaution,
     "the offset s of the pinion is greater than the standard allows for this arrangement of the "
     "bearings",
     "an offset that the standard does not cover"},
    {C::rating_notch, "rating_notch", kCaution,
     "the notch parameter q_s is outside 1 to 8, the range of Y_S",
     "a root fillet outside the range of the stress correction factor", "", kGearUnnamed},
    {C::thin_rim, "thin_rim", kCaution,
     "the rim under the teeth is thinner than the limit of the rim thickness factor Y_B of ISO "
     "6336-3, which is half the tooth height, or 1.75 m_n for an internal gear; the rim extends "
     "from the roots to the bore, or to the outside of an internal gear",
     "a thin rim", "", kGearUnnamed},
    {C::rating_plastic, "rating_plastic", kCaution,
     "VDI 2736 also covers wear, deformation and peak loads of plastic teeth, but the rating does "
     "not",
     "wear and deformation that are not rated"},
    {C::not_read, "not_read", kNote,
     "a part of the spec has no effect in this version or with this verb", "", "Leave it out."},
    {C::rating_crowning, "rating_crowning", kNote,
     "the face load factor is computed without crowning, helix slope and end relief"},
    {C::tip_bulge, "tip_bulge", kNote,
     "the tip projects beyond the involute, because the flank of the cutter was too short; "
     "mating gears other than the cutter can collide with the projection; the message gives the "
     "tip diameter that removes the projection"},
    {C::fillets_not_asked, "fillets_not_asked", kNote,
     "if the lead of the cutter is changed, the check for contact of tips with root fillets is not "
     "available for circular fillets and for roots cut by a pinion cutter (verb `contact`)"},
    {C::transverse_contact_ratio, "transverse_contact_ratio", kNote,
     "ε_α is below 1 for the part of the path on the usable flanks, and the overlap compensates "
     "for this; the message gives the least face width"},
    {C::self_locking, "self_locking", kNote,
     "with this friction, the gear named in the message cannot be the driving gear; in a drive, "
     "the output cannot be the driving member"},
    {C::full_radius_root, "full_radius_root", kNote,
     "the root radius of a named rack does not fit; the full radius is used"},
    {C::tip_cut_by_rack, "tip_cut_by_rack", kNote,
     "the tooth ends at the bottom land of the cutter, below the tip diameter of the blank; or no "
     "tip diameter is given, and the root of a cutter that is not the mating gear determines the "
     "tip"},
    {C::default_face_width, "default_face_width", kNote,
     "b is 10 m_n, because no face width is given"},
    {C::default_rack_body, "default_rack_body", kNote,
     "the height or the number of teeth of a rack is not given, or its whole teeth are shorter "
     "than the given length; the message gives the value that pictures and files use"},
    {C::default_cutter, "default_cutter", kNote,
     "an internal gear has no `cut_by`, so a default cutter generates its fillets; the message "
     "gives the number of teeth of the cutter"},
    {C::inherited, "inherited", kNote,
     "gear 2 has no material or quality in the spec, so the value of gear 1 is used"},
    {C::profile_shifts_chosen, "profile_shifts_chosen", kNote,
     "absent profile shifts are computed from the centre distance; the message gives these shifts"},
    {C::tip_fillet_cut_off, "tip_fillet_cut_off", kNote,
     "the blank ends the tooth before its circular tip fillet begins"},
    {C::no_chord, "no_chord", kNote,
     "there is no usable flank that a calliper can span, and no diameter is given (verb "
     "`measure`)"},
    {C::no_span, "no_span", kNote,
     "no span touches the usable flank, and no number of teeth is given (verb `measure`)"},
    {C::no_balls, "no_balls", kNote,
     "no ball diameter is given, and no ball of any size touches the usable flanks (verb "
     "`measure`)"},
    {C::span_off_flank, "span_off_flank", kNote,
     "the contacts of the given span are not on the usable flank (verb `measure`)"},
    {C::span_off_face, "span_off_face", kNote,
     "the face is too narrow for both anvils, or the anvils rest on less of the flank than "
     "measuring practice requires [T10.36] (verb `measure`)"},
    {C::ball_off_flank, "ball_off_flank", kNote,
     "the contacts of the given balls are not on the usable flank (verb `measure`)"},
    {C::pin_off_flank, "pin_off_flank", kNote,
     "the contacts of the given pins are not on the usable flank or, for two pins that may tilt, "
     "not on the face (verb `measure`)"},
    {C::tolerances_out_of_range, "tolerances_out_of_range", kNote,
     "the size of the gear is outside the range of ISO 1328-1 (verb `measure`)"},
    {C::held_at_half_the_root, "held_at_half_the_root", kNote,
     "a gear has no bore, so the verb `load` holds its body at half the root diameter"},
    {C::held_at_rim_as_drawn, "held_at_rim_as_drawn", kNote,
     "the outside diameter of the rim of an internal gear is not given, so the verb `load` holds "
     "the gear at the default diameter, which its CAD files also have"},
    {C::no_load, "no_load", kNote,
     "an analysis under load cannot be computed for these gears (verb `run` or verb `search`); the "
     "message gives the reason"},
    {C::stiffness_differs, "stiffness_differs", kNote,
     "the mesh stiffness differs from c_γα of ISO 6336-1 (verb `load`); the message gives the "
     "reasons"},
    {C::designs_cut, "designs_cut", kNote,
     "there are more designs than the list of the verb `search` contains"},
    {C::edges_left_out, "edges_left_out", kNote,
     "the borders of the regions are omitted if there are more than 10 000 designs (verb "
     "`search`)"},
    {C::changes_left_out, "changes_left_out", kNote,
     "the search for a change of the limits that would help was incomplete or omitted (verb "
     "`search`); the message gives the reason"},
    {C::not_coaxial, "not_coaxial", kProblem,
     "no profile shift brings all meshes of a planet to the same centre distance, there is no "
     "possible place for an idler, both gears of a mesh have the same axis, or a closed loop of "
     "gears does not fit together (verb `drive`)",
     "the gears do not fit on common axes"},
    {C::planets_collide, "planets_collide", kProblem,
     "the tip circles of neighbouring planets overlap, or there are fewer possible positions than "
     "planets (verb `drive`)",
     "neighbouring planets collide"},
    {C::cannot_drive, "cannot_drive", kProblem,
     "with this friction, the input of the drive cannot drive its output (verb `drive`)",
     "the input cannot drive the output",
     "Exchange `input` and `output`, or give a smaller `friction_coefficient`."},
    {C::unequal_spacing, "unequal_spacing", kCaution,
     "the planets are unequally spaced (verb `drive`)", "the planets are unequally spaced"},
    {C::redundant_meshes, "redundant_meshes", kCaution,
     "the torques in a closed loop of meshes depend on compliance, so they are not computed (verb "
     "`drive`)",
     "the torques in a closed loop of meshes depend on compliance"},
    {C::power_against_input, "power_against_input", kNote,
     "in a drive with several inputs, the given speeds and torques let power flow out through an "
     "input or in through the output (verb `drive`)"},
    {C::no_backlash, "no_backlash", kNote,
     "the teeth have no backlash at this centre distance; textbook gears are computed in this way, "
     "but manufactured gears need backlash",
     "", "Give thickness allowances or a series of DIN 3967."},
    {C::little_backlash, "little_backlash", kNote,
     "the backlash is less than a quarter of the backlash that ISO/TR 10064-2 recommends, so the "
     "deviations of manufactured gears may take it",
     "", "Give thickness allowances or a series of DIN 3967."},
    {C::mesh_load_factor, "mesh_load_factor", kCaution,
     "in a drive with [load], K_γ of the planets under load is greater than K_γ of the rating or, "
     "without a rating, is at least 2, or a planet carries no load at any position",
     "the planets share the load unevenly"},
    {C::default_rack, "default_rack", kNote,
     "the pressure angle is 14.5° and the rack is not given; the message names the standard rack "
     "of this pressure angle"},
    {C::shaft_through_gear, "shaft_through_gear", kNote,
     "the axis of a shaft is within the tip circle of a gear on another shaft, so the shaft must "
     "end before this gear (verb `drive`)"},
    {C::rating_quality, "rating_quality", kCaution,
     "`quality` of [rating] differs from the accuracy grade of a gear on the drawing",
     "a rating with an accuracy grade that differs from the drawing",
     "Leave out `rating.quality`; the rating then uses the grades of the gears."},
    {C::tolerance_editions, "tolerance_editions", kNote,
     "the rating and the drawing use the tolerances of different editions of ISO 1328-1 (verb "
     "`run`)"},
    {C::spectrum_rated, "spectrum_rated", kNote,
     "the message gives the safety factors under the load spectrum, and the torque and K_A to "
     "which the other results of the rating apply"},
    {C::torque_of_rating, "torque_of_rating", kNote,
     "[load] gives no torque, so the verb `load` uses the nominal torque of [rating]"},
    {C::partial_face, "partial_face", kCaution,
     "a gear of a drive meshes with gears in several planes and is too narrow to cover their "
     "faces; the message gives the least face width (verb `drive`)",
     "a gear that meshes in several planes is too narrow"},
}};

constexpr bool each_has_its_row() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (kRows[i].code != static_cast<WarningCode>(i)) return false;
  }
  return true;
}
static_assert(each_has_its_row());

}  // namespace

const WarningMeaning& meaning_of(WarningCode code) { return kRows[static_cast<std::size_t>(code)]; }

const std::array<WarningMeaning, kWarningCodes>& warning_meanings() { return kRows; }

}  // namespace gearwright
