// A pair or a drive as a REXS file: gears, flanks, tools, shafts, stages and the load.
//
// The version is 1.7, whose names version 2.0 keeps with few exceptions. Internal to job/ and the
// program.
#pragma once

#include <filesystem>

#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/files.hpp"

namespace gearwright {

/// Laws      (1) the pair of the file, read again, has the numbers of the pair within 1e-9
/// Errors    `gearN` of a single gear, a rack, crossed axes, gears that are not cut by straight racks or
///           pinion cutters, and double-helical gears
Result<JobFile> make_rexs(const SolvedJob& job, const std::filesystem::path& path);

/// Errors    a drive without geometry or with a rack; as above for its gears
Result<JobFile> make_rexs(const DriveJob& job, const std::filesystem::path& path);

}  // namespace gearwright
