// Defines warnings, which are facts about gears and pairs that are not errors.
//
// Every warning, finding of a verdict and entry of `interference` has a code. One table
// (warning.cpp) has a row for each code, with its name in results, its severity and its sentences.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace gearwright {

enum class Severity {
  note,     ///< information only, for example about a default that was used
  caution,  ///< the gears run, but the user should check this
  problem,  ///< the gears cannot be made or do not run as specified
};
/// The codes of gears and pairs, the worst first, and then further codes. Findings of equal
/// severity are reported in this order.
enum class WarningCode {
  contact_lost,  ///< at some positions no tooth pair touches
  // The gear does not exist.
  through_axis,
  severed,
  no_body,
  no_flank,
  // The gears do not run.
  no_contact,
  jam,
  negative_backlash,
  contact_ratio,
  load_unfinished,
  interference,
  contact_off_flank,
  root,
  base_tangent,
  form_circle,
  tip_to_fillet,
  trochoid,
  overlap,
  root_safety,
  flank_safety,
  spectrum_safety,
  // The gears run, but not as intended.
  samples_jam,
  samples_lose_contact,
  samples_touch_edges,
  contact_lost_to_undercut,  ///< a gear loses contact where undercut has removed the flank
  beyond_flank,
  saddle_gap,
  contact_below_form,
  fillet_contact,
  edge_carries,
  edge_contact,
  no_tip_clearance,
  beyond_hertz,
  nearly_parallel,
  face_width,
  undercut,
  pointed,
  thin_tip,
  tip_below_base,
  trimming,
  tip_margin,
  form_margin,
  fillet_margin,
  contact_place,
  thickened_for_backlash,
  hob_run_out,          ///< only for double-helical gears
  stagger_without_gap,  ///< only for double-helical gears
  // The user should check numbers of the result or of the spec.
  no_outline,
  no_corrections,
  no_strength,
  ellipse_beyond_flank,
  rating_root_fillet,
  contact_search_unfinished,
  correction_at_bound,
  rack_not_used,
  default_shaft_angle,
  pressure_angle,
  unequal_lead,
  rating_contact_ratio,
  rating_helix_angle,
  rating_pressure_angle,
  rating_stiffness,
  rating_resonance,
  rating_mounting,
  rating_notch,
  thin_rim,
  rating_plastic,
  // Information only.
  not_read,
  rating_crowning,
  tip_bulge,
  fillets_not_asked,
  transverse_contact_ratio,
  self_locking,
  full_radius_root,
  tip_cut_by_rack,
  default_face_width,
  default_rack_body,
  default_cutter,
  inherited,
  profile_shifts_chosen,
  tip_fillet_cut_off,
  no_chord,
  no_span,
  no_balls,
  span_off_flank,
  span_off_face,
  ball_off_flank,
  pin_off_flank,
  tolerances_out_of_range,
  held_at_half_the_root,
  held_at_rim_as_drawn,
  no_load,
  stiffness_differs,
  designs_cut,
  edges_left_out,
  changes_left_out,
  // Warnings about whole drives, the worst first.
  not_coaxial,
  planets_collide,
  cannot_drive,
  unequal_spacing,
  redundant_meshes,
  power_against_input,
  // Information about the backlash of a pair or a mesh.
  no_backlash,
  little_backlash,
  // A load of the rating that differs from a computed load.
  mesh_load_factor,
  // A rack that is not given.
  default_rack,
  // A shaft of a drive that would pass through a gear.
  shaft_through_gear,
  // The accuracy grade of the rating differs from the grade of the drawing.
  rating_quality,
  tolerance_editions,
  // The safety factors of a load spectrum.
  spectrum_rated,
  // A torque that [load] does not contain.
  torque_of_rating,
  // A gear of a drive that meshes in several planes and is too narrow for this.
  partial_face,
  count  ///< the number of codes, not a code
};

inline constexpr std::size_t kWarningCodes = static_cast<std::size_t>(WarningCode::count);

struct WarningMeaning {
  WarningCode code;
  const char* text;  ///< the name of the code in all results, such as "undercut"
  Severity severity;
  const char* sentence;       ///< the condition for the warning, used in documents
  const char* reason = "";    ///< a clause for headlines, such as "the gears jam"; empty for a note
  const char* advice = "";    ///< a change of the spec, if the remedy is not a number
  bool gear_unnamed = false;  ///< true if the message does not name the gear
};

const WarningMeaning& meaning_of(WarningCode code);
const std::array<WarningMeaning, kWarningCodes>& warning_meanings();
inline const char* to_string(WarningCode code) { return meaning_of(code).text; }

/// A fact about a gear or a pair that the user should know and that is not an error.
struct Warning {
  WarningCode code;
  std::string message;  ///< one or more sentences for the user
  int gear = 0;         ///< 1, 2, or 0 for the pair

  bool operator==(const Warning&) const = default;
};
inline Severity severity_of(const Warning& warning) { return meaning_of(warning.code).severity; }

/// True if a gear, a pair or a job has a warning with this code.
template <class Warned>
bool warns(const Warned& of, WarningCode code) {
  return std::any_of(of.warnings.begin(), of.warnings.end(),
                     [&](const Warning& w) { return w.code == code; });
}

}  // namespace gearwright
