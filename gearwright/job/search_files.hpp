// The files of a search, each whole or not there at all.
//
//   search.parquet   every feasible design, in the order of the trials
//   best.csv         the best of them, best first          search.json    the result
//   report.html      the best in a table that sorts, their regions, the front
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// Gives the designs in pieces, in the order of the trials; false: no more.
using DesignSource = std::function<bool(std::vector<DesignRow>& rows)>;

/// Writes them all and returns their names.   Throws  IoError
std::vector<std::filesystem::path> write_search_files(const JobSpec& spec, const Search& search,
                                                      const SearchRun& run,
                                                      const std::filesystem::path& folder,
                                                      const DesignSource& designs);

}  // namespace gearwright
