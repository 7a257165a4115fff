#include "gearwright/verdict/meaning.hpp"

#include <array>

namespace gearwright {

namespace {

struct Row {
  const char* code;
  Severity severity;
  const char* reason = "";
  const char* advice = "";
};

constexpr Severity kProblem = Severity::problem;
constexpr Severity kCaution = Severity::caution;
constexpr Severity kNote = Severity::note;

// The pair loses contact under its errors. The same code with a gear's number means an undercut
// flank, where the mating tip touches nothing.
constexpr Row kContactLostByPair{"contact_lost", kProblem, "contact is lost at some positions"};

constexpr auto kRows = std::to_array<Row>({
    // There is no such gear.
    {"through_axis", kProblem, "the cutter passes the axis"},
    {"severed", kProblem, "the teeth are cut off at their roots"},
    {"no_body", kProblem, "a bore leaves its gear no body"},
    {"no_flank", kProblem, "a gear has no usable flank"},
    // The gears do not run.
    {"no_contact", kProblem, "the teeth do not touch"},
    {"jam", kProblem, "the gears jam"},
    {"negative_backlash", kProblem, "the teeth are too thick for this centre distance"},
    {"contact_ratio", kProblem, "contact is not continuous"},
    {"load_unfinished", kProblem, "under load some positions have no answer"},
    {"interference", kProblem, "the flanks cut into each other"},
    {"contact_off_flank", kProblem, "the teeth touch off their flanks"},
    {"root", kProblem, "a tip cuts into the mating gear’s root"},
    {"base_tangent", kProblem, "a tip reaches where the mating gear has no involute"},
    {"form_circle", kProblem, "a tip reaches below the mating gear’s usable flank"},
    {"tip_to_fillet", kProblem, "a tip corner cuts into a root fillet"},
    {"trochoid", kProblem, "the tips strike each other"},
    {"overlap", kProblem, "the teeth overlap"},
    {"root_safety", kCaution, "the safety against root breakage is too small"},
    {"flank_safety", kCaution, "the safety against pitting is too small"},
    // They run, but not as they should.
    {"contact_lost", kCaution, "contact is lost where undercut has taken the flank"},
    {"beyond_flank", kCaution, "teeth meet beyond their flanks, where the ratio is not constant"},
    {"contact_below_form", kCaution, "a tip works into a root fillet"},
    {"fillet_contact", kCaution, "a tip meets a root fillet"},
    {"edge_carries", kCaution, "an edge carries"},
    {"edge_contact", kCaution, "an edge touches"},
    {"no_tip_clearance", kCaution, "a tip runs on the mating root"},
    {"beyond_hertz", kCaution, "the contact is beyond what Hertz’ formulas describe"},
    {"nearly_parallel", kCaution, "the axes cross at a small angle"},
    {"face_width", kCaution, "a face is too narrow for the line of action"},
    {"undercut", kCaution, "undercut"},
    {"pointed", kCaution, "pointed teeth"},
    {"thin_tip", kCaution, "a thin tip"},
    {"tip_below_base", kCaution, "a tip inside its base circle"},
    {"trimming", kCaution, "the pinion cannot be put in radially"},
    {"tip_margin", kCaution, "a small tip clearance"},
    {"form_margin", kCaution, "a small form clearance"},
    {"fillet_margin", kCaution, "a tip corner close to a root fillet"},
    {"contact_place", kCaution, "the contact lies near the end of the face"},
    {"thickened_for_backlash", kCaution, "teeth thickened for the backlash"},
    // The numbers of the answer, or of the spec, deserve a look.
    {"no_outline", kCaution, "a gear without an outline"},
    {"no_corrections", kCaution, "no corrections"},
    {"ellipse_beyond_flank", kCaution, "a contact ellipse beyond the flank"},
    {"rating_root_fillet", kCaution, "a root that the standard does not describe"},
    {"contact_search_unfinished", kCaution, "positions without an exact contact point",
     "Choose other positions."},
    {"correction_at_bound", kCaution, "a correction at its bound", "Align the housing better."},
    {"rack_not_used", kCaution, "numbers of a rack that have no effect",
     "Leave these numbers of the rack out."},
    {"default_shaft_angle", kCaution, "a shaft angle that was not given",
     "Give the shaft angle, or give both gears one helix angle, of opposite hand."},
    {"pressure_angle", kCaution, "a pressure angle that does not fit",
     "Leave it out, or write the angle at which the flanks touch."},
    {"unequal_lead", kCaution, "unequal leads", "The verb contact computes where the teeth touch."},
    // Good to know.
    {"not_read", kNote, "", "Leave it out."},
    {"tip_bulge", kNote},
    {"fillets_not_asked", kNote},
    {"transverse_contact_ratio", kNote},
    {"self_locking", kNote},
    {"full_radius_root", kNote},
    {"tip_cut_by_rack", kNote},
    {"default_face_width", kNote},
    {"default_cutter", kNote},
    {"inherited", kNote},
    {"profile_shifts_chosen", kNote},
    {"tip_fillet_cut_off", kNote},
    {"no_chord", kNote},
    {"no_span", kNote},
    {"no_balls", kNote},
    {"span_off_flank", kNote},
    {"span_off_face", kNote},
    {"ball_off_flank", kNote},
    {"pin_off_flank", kNote},
    {"tolerances_out_of_range", kNote},
    {"held_at_half_the_root", kNote},
    {"held_at_rim_as_drawn", kNote},
    {"no_load", kNote},
    {"stiffness_differs", kNote},
});

Meaning of_row(const Row& row, int rank) { return {row.severity, row.reason, row.advice, rank}; }

}  // namespace

Meaning meaning_of(std::string_view code, int gear) {
  if (gear == 0 && code == kContactLostByPair.code) return of_row(kContactLostByPair, 0);
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (code == kRows[i].code) return of_row(kRows[i], static_cast<int>(i));
  }
  return {kCaution, "", "", static_cast<int>(kRows.size())};
}

}  // namespace gearwright
