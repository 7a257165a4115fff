// The verb measure, and a gear under another rack's name: what a workshop asks of a gear.
// Internal to job/ and the program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/measure_quantities.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// The chord at [gearN.measure] chord_diameter_mm; without it at the reference diameter, or in the
/// middle of the usable flank where that does not reach there.
///
/// Errors    `gearN.measure.chord_diameter_mm`
Result<ChordView> chord_measure(const SolvedJob& job, int which);

/// One gear's chord, or nothing.
using MaybeChord = std::optional<ChordView>;

/// chord_measure of every gear; a gear that has no chord where nobody asked for one gets a warning
/// `no_chord` in the job.
///
/// Errors    `gearN.measure.chord_diameter_mm`, when that was given
Result<std::vector<MaybeChord>> chord_measures(SolvedJob& job);

/// job_json with `measure` in each of `gears`.
Json measures_json(const SolvedJob& job, const std::vector<MaybeChord>& measures);

/// {"chordal_thickness": {diameter_mm, chord_mm, height_mm, tip_to_chord_mm, caliper_angle_deg}}
Json measure_json(const MaybeChord& measure);
std::string measure_listing(const std::vector<MaybeChord>& measures);

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
