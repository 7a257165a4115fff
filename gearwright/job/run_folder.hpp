// The folder of `run`. A run removes the files of an earlier run that it does not write itself, but
// no other files.
//
// The folder contains a list of the files of a run with their sizes and checksums. Files that the
// user has changed or replaced since are kept.
#pragma once

#include <filesystem>
#include <vector>

#include "gearwright/job/files.hpp"

namespace gearwright {

inline constexpr const char* kRunList = ".gearwright_files";

/// Writes the files and their list. Files of the former list that are unchanged and not written
/// again are removed.   Throws  IoError
void write_run(const std::filesystem::path& folder, const std::vector<JobFile>& files);

}  // namespace gearwright
