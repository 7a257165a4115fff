#include "gearwright/verdict/meaning.hpp"

#include <array>

namespace gearwright {

namespace {

struct Entry {
  const char* code;
  Meaning meaning;
};

constexpr Severity kProblem = Severity::problem;
constexpr Severity kCaution = Severity::caution;
constexpr Severity kNote = Severity::note;

constexpr auto kMeanings = std::to_array<Entry>({
    {"through_axis",
     {kProblem, "the cutter passes the axis",
      "More teeth, more profile shift or a smaller dedendum would help.", true}},
    {"severed",
     {kProblem, "the teeth are cut off at their roots",
      "More teeth or more profile shift would help.", true}},
    {"no_body",
     {kProblem, "a bore leaves its gear no body", "A smaller bore, or more teeth, would help.",
      true}},
    {"no_flank",
     {kProblem, "a gear has no usable flank", "More profile shift or a longer tip would help."}},
    {"negative_backlash",
     {kProblem, "the teeth are too thick for this centre distance",
      "Take the backlash-free centre distance or one beyond it, or thinner teeth.", true}},
    {"contact_ratio",
     {kProblem, "contact is not continuous",
      "Longer tips, less profile shift, a smaller centre distance or a wider helical face would "
      "help."}},
    {"contact_lost",
     {kCaution, "", "More profile shift on the undercut gear, or more teeth, would help."}},
    {"no_contact",
     {kProblem, "the teeth do not touch", "A smaller centre distance or longer tips would help."}},
    {"base_tangent",
     {kProblem, "a tip reaches where the mating gear has no involute",
      "Shorten the tip, or shift the gear that it reaches outward.", true}},
    {"form_circle",
     {kProblem, "a tip reaches below the mating gear’s usable flank",
      "Shorten the tip, or shift the gear that it reaches outward.", true}},
    {"tip_to_fillet",
     {kProblem, "a tip corner cuts into a root fillet",
      "Shorten the tip, or shift the gear that it reaches outward."}},
    {"root", {kProblem, "a tip cuts into the mating gear’s root", "Shorten that tip.", true}},
    {"trochoid",
     {kProblem, "the tips strike each other", "Shorten a tip, or take tooth numbers further apart.",
      true}},
    {"overlap", {kProblem, "the teeth overlap", "End the tip where it begins to stand out.", true}},
    {"beyond_flank",
     {kCaution, "", "Shorten the tip that strikes, or shift the gear that it reaches outward.",
      true}},
    {"tip_bulge", {kNote, "", ""}},
    {"jam",
     {kProblem, "the gears jam", "Thinner teeth, a greater centre distance or smaller errors."}},
    {"contact_below_form",
     {kCaution, "", "Shorten the mating gear’s tip or give it a tip relief.", true}},
    {"fillet_contact",
     {kCaution, "", "Shorten that tip, a greater centre distance or smaller errors.", true}},
    {"fillets_not_asked", {kNote, "", ""}},
    {"contact_search_unfinished", {kCaution, "", "Ask for other positions."}},
    {"correction_at_bound", {kCaution, "", "Align the housing better.", false}},
    {"not_read", {kNote, "", "Leave it out."}},
    {"rack_not_used", {kCaution, "", "Leave these numbers of the rack out."}},
    {"tip_below_base", {kCaution, "", "A greater tip diameter would help."}},
    {"no_tip_clearance", {kCaution, "", "Shorten the tip that runs on the root.", true}},
    {"transverse_contact_ratio", {kNote, "", ""}},
    {"undercut", {kCaution, "", "More profile shift avoids it.", true}},
    {"pointed", {kCaution, "", "Less profile shift or a smaller tip diameter would help."}},
    {"thin_tip", {kCaution, "", "Less profile shift or a smaller tip diameter would help."}},
    {"trimming", {kCaution, "", "Assemble the pair along the axis.", true}},
    {"nearly_parallel", {kCaution, "", "Give both gears one helix angle, of opposite hand.", true}},
    {"face_width", {kCaution, "", "A wider face would use the whole line of action.", true}},
    {"self_locking", {kNote, "", ""}},
    {"full_radius_root", {kNote, "", ""}},
    {"tip_cut_by_rack", {kNote, "", ""}},
    {"default_face_width", {kNote, "", ""}},
    {"default_shaft_angle",
     {kCaution, "", "Give the shaft angle, or both gears one helix angle, of opposite hand."}},
    {"default_cutter", {kNote, "", ""}},
    {"tip_fillet_cut_off", {kNote, "", ""}},
    {"no_chord", {kNote, "", ""}},
    {"interference",
     {kProblem, "the flanks cut into each other",
      "A greater difference of the arcs’ radii would help.", true}},
    {"contact_off_flank",
     {kProblem, "the teeth touch off their flanks",
      "A centre distance nearer to the reference one would help.", true}},
    {"pressure_angle", {kCaution, "", "Leave it out, or write the angle at which they touch."}},
    {"unequal_lead", {kCaution, "", "The verb contact says where they touch."}},
    {"no_span", {kNote, "", ""}},
    {"no_balls", {kNote, "", ""}},
    {"span_off_flank", {kNote, "", ""}},
    {"span_off_face", {kNote, "", ""}},
    {"ball_off_flank", {kNote, "", ""}},
    {"pin_off_flank", {kNote, "", ""}},
    {"tolerances_out_of_range", {kNote, "", ""}},
    {"edge_carries", {kCaution, "", "Tip relief takes the load off the edge.", true}},
    {"beyond_hertz", {kCaution, "", "Less torque or a wider face would help."}},
    {"held_at_half_the_root", {kNote, "", ""}},
    {"held_at_rim_as_drawn", {kNote, "", ""}},
    {"no_load", {kNote, "", ""}},
    {"load_unfinished", {kCaution, "", "Ask for other positions."}},
});

}  // namespace

Meaning meaning_of(const Warning& warning) {
  // Of the pair under its errors: no gear is undercut there.
  if (warning.code == "contact_lost" && warning.gear == 0)
    return {kProblem, "contact is lost at some positions",
            "Smaller errors or less relief would help."};
  for (const Entry& entry : kMeanings) {
    if (warning.code == entry.code) return entry.meaning;
  }
  return {kCaution, "", ""};
}

}  // namespace gearwright
