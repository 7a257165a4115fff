// The verb measure, and a gear under another rack's name: what a workshop asks of a gear.
// Internal to job/ and the program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/measure_quantities.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// What is measured of each gear: with the tools of [gearN.measure], else with the usual ones. What a
/// gear does not have, where nobody asked for it, is none and a warning in the job: `no_chord`,
/// `no_span`, `no_balls`, `no_pins`; a contact that is off the usable flank is one too.
///
/// Errors    `gearN.measure.…`: what was asked for and cannot be measured
Result<std::vector<GearMeasures>> measure_gears(SolvedJob& job);

/// The same as records for the page; what was asked for and cannot be measured is left out.
std::vector<ValueRecord> measure_records(const SolvedJob& job);

/// Of each gear the numbers that differ at the lower and at the upper end of its tolerances, or
/// nothing; empty without tolerances.
std::vector<std::vector<ValueRecord>> measure_end_records(const SolvedJob& job);

/// job_record with `measure` in each of `gears`, and the interval that tolerances give it.
Json measures_record(const SolvedJob& job, const std::vector<GearMeasures>& measures);

std::string measure_listing(const SolvedJob& job, const std::vector<GearMeasures>& measures);

/// The rack that --as-rack names: "module,angle", either of them empty.
struct RackQuestion {
  std::optional<double> normal_module;  ///< mm
  std::optional<Angle> normal_pressure_angle;
};

/// Reads "3,20", ",17.5" or "3,"; nothing when it is none of these.
std::optional<RackQuestion> parse_rack_question(const std::string& text);

/// The gear, teeth as cut, as that rack describes it.
///
/// Errors    `--as-rack`: no such rack has this gear; the message names the module that belongs to
///           the angle, or the greatest angle
Result<ReferenceInput<double>> gear_as_rack(const Gear& gear, const RackQuestion& question);

/// {normal_module_mm, normal_pressure_angle_deg, helix_angle_deg, profile_shift,
/// reference_diameter_mm}
Json rack_json(const ReferenceInput<double>& rack);
std::string rack_listing(const std::vector<ReferenceInput<double>>& racks);

}  // namespace gearwright
