// Writes a pair or a drive as a REXS file, with gears, flanks, tools, shafts, stages and the load.
//
// The version is 1.7. Version 2.0 has nearly the same names. Internal to job/ and the programs.
#pragma once

#include <filesystem>

#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/files.hpp"

namespace gearwright {

/// Laws      (1) reading the file gives a pair with the same numbers within 1e-9
/// Errors    `gearN` for a single gear, a rack, crossed axes, gears that are not cut by straight
///           racks or pinion cutters, and double-helical gears
Result<JobFile> make_rexs(const SolvedJob& job, const std::filesystem::path& path);

/// Errors    a drive without geometry or with a rack; the errors of make_rexs() for a pair, if a
///           gear has properties that REXS cannot contain
Result<JobFile> make_rexs(const DriveJob& job, const std::filesystem::path& path);

}  // namespace gearwright
