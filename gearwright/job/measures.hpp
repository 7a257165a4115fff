// The verb measure, and a gear in terms of another rack. Internal to job/ and the program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/measure_quantities.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// The measurements of each gear, with the tools of [gearN.measure], otherwise with the usual ones.
/// A measurement that a gear does not have and that was not requested is none, with a warning in
/// the job: `no_chord`, `no_span`, `no_balls`, `no_pins`; a contact off the usable flank also
/// produces a warning.
///
/// Errors    `gearN.measure.…`: a requested measurement that is impossible
Result<std::vector<GearMeasures>> measure_gears(SolvedJob& job);

/// The measurements as records for the page; impossible ones are omitted.
std::vector<ValueRecord> measure_records(const SolvedJob& job);

/// For each gear the numbers that differ at the lower and at the upper end of its tolerances, or
/// nothing; empty without tolerances.
std::vector<std::vector<ValueRecord>> measure_end_records(const SolvedJob& job);

/// job_record with `measure` in each of `gears`, and its range within tolerances.
Json measures_record(const SolvedJob& job, const std::vector<GearMeasures>& measures);

std::string measure_listing(const SolvedJob& job, const std::vector<GearMeasures>& measures);

/// The rack of --as-rack: "module,angle", either of them empty.
struct RackQuestion {
  std::optional<double> normal_module;  ///< mm
  std::optional<Angle> normal_pressure_angle;
};

/// Reads "3,20", ",17.5" or "3,"; none for other texts.
std::optional<RackQuestion> parse_rack_question(const std::string& text);

/// The gear, with the teeth as cut, in terms of that rack.
///
/// Errors    `--as-rack` if no such rack describes this gear; the message names the module for the
///           angle, or the greatest angle
Result<ReferenceInput<double>> gear_as_rack(const Gear& gear, const RackQuestion& question);

/// {normal_module_mm, normal_pressure_angle_deg, helix_angle_deg, profile_shift,
/// reference_diameter_mm}
Json rack_json(const ReferenceInput<double>& rack);
std::string rack_listing(const std::vector<ReferenceInput<double>>& racks);

}  // namespace gearwright
