// Writes a pair or a drive as a REXS file, with gears, flanks, tools, shafts, stages and the load.
//
// The version is 1.7. Version 2.0 has nearly the same names. Internal to job/ and the programs.
#pragma once

#include <filesystem>

#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/files.hpp"

namespace gearwright {

/// Laws      (1) reading the file gives a pair with the same numbers within 1e-9
/// Errors    `gear2` for a single gear; `gear2.form` for a rack; `pair.shaft_angle` for crossed
///           axes; `gear1.double_helical` for double-helical gears; `gearN` for circular-arc teeth
///           or circular fillets
Result<JobFile> make_rexs(const SolvedJob& job, const std::filesystem::path& path);

/// Errors    the name of a gear that is a rack or double-helical, that has no module or no teeth
///           that fit the drive, or that has circular-arc teeth or circular fillets
Result<JobFile> make_rexs(const DriveJob& job, const std::filesystem::path& path);

}  // namespace gearwright
