// Computes the results of the verb `measure`, and describes a gear by another rack.
// Internal to job/ and the programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// Returns the measurements of each gear with the tools of [gearN.measure], or else with the usual
/// tools. If a measurement that was not requested is impossible, it is absent, and the job gets the
/// warning `no_chord`, `no_span` or `no_balls`. A contact outside the usable flank also causes a
/// warning.
///
/// Errors    `gearN.measure.…` for a requested measurement that is impossible
Result<std::vector<GearMeasures>> measure_gears(SolvedJob& job);

/// Returns the diameter of balls and pins in North American practice, mm (ANSI/AGMA 2002-B88, the
/// sizes of Van Keuren). It is 1.728 m_n (1.728/P in inch) for an external gear and for a rack, and
/// 1.68 m_n for an internal gear. P is the normal diametral pitch. Returns none if the spec is not
/// in inch, or if it gives P neither for this gear nor for gear 1.
std::optional<double> pin_of_diametral_pitch(const JobSpec& spec, int which, bool internal,
                                             double normal_module);

/// Returns the measurements of each gear as a record. If a requested measurement of a gear is
/// impossible, its record is empty.
std::vector<ValueRecord> measure_records(const SolvedJob& job);

/// Returns two records for each gear, with the measurements at the lower and at the upper end of
/// its tolerances. They show only the numbers that differ. If a requested measurement of a gear is
/// impossible, the gear has no records. Without tolerances, the list is empty.
std::vector<std::vector<ValueRecord>> measure_end_records(const SolvedJob& job);

/// Returns the record of job_record(), in which each of `gears` has an additional member `measure`.
/// The record includes the ranges of the measurements within tolerances.
Json measures_record(const SolvedJob& job, const std::vector<GearMeasures>& measures);

std::string measure_listing(const SolvedJob& job, const std::vector<GearMeasures>& measures);

/// Reads the rack that the user gives with --as-rack: "3,20", ",17.5" or "3,". Returns none for
/// other texts.
std::optional<WantedRack> parse_wanted_rack(const std::string& text);

/// Errors    `--as-rack` in place of the fields of as_rack()
Result<ReferenceInput<double>> gear_as_rack(const Gear& gear, const WantedRack& wanted);

/// {normal_module_mm, normal_pressure_angle_deg, helix_angle_deg, profile_shift,
/// reference_diameter_mm}
Json rack_json(const ReferenceInput<double>& rack);
std::string rack_listing(const std::vector<ReferenceInput<double>>& racks, UnitSystem units);

}  // namespace gearwright
