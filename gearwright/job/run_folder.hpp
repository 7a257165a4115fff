// The folder of `run`: files of an earlier run that this run does not write are removed, and no
// other files.
//
// The list of a run's files is in the folder, with the size and the checksum of each, so that files
// which the user has since changed or replaced are kept.
#pragma once

#include <filesystem>
#include <vector>

#include "gearwright/job/files.hpp"

namespace gearwright {

inline constexpr const char* kRunList = ".gearwright_files";

/// Writes the files and their list; then removes the files of the former list that are not among
/// them and are unchanged.   Throws  IoError
void write_run(const std::filesystem::path& folder, const std::vector<JobFile>& files);

}  // namespace gearwright
