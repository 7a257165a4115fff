// The work after all trials of a search: finding changes that would help if nothing is feasible,
// and computing the regions of the listed designs.
//
// Internal to job/ and apps. Both functions return false if the options request a stop.
#pragma once

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// Computes changes that would make designs feasible, unless there are feasible designs.
bool look_for_changes(const Search& search, const SearchOptions& options, SearchRun& run);

/// Computes the regions of the listed designs.
bool complete_regions(const Search& search, const SearchOptions& options, SearchRun& run);

}  // namespace gearwright
