// The folder of `run`: what a former run wrote there and this one does not goes, nothing else.
//
// The list of a run's files lies in the folder, with the size and the checksum that each had, so
// that a file which somebody has changed or put in its place since is somebody's own.
#pragma once

#include <filesystem>
#include <vector>

#include "gearwright/job/files.hpp"

namespace gearwright {

inline constexpr const char* kRunList = ".gearwright_files";

/// Writes the files and their list; then removes those of the former list that are none of them and
/// are as they were written.   Throws  IoError
void write_run(const std::filesystem::path& folder, const std::vector<JobFile>& files);

}  // namespace gearwright
