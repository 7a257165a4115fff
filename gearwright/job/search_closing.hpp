// The work after all trials of a search: changes that would help if nothing is feasible, and the
// regions of the listed designs.
//
// Internal to job/ and apps. Both return true to continue. They stop if the options request it.
#pragma once

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// Computes changes that would help. To be called if nothing is feasible.
bool look_for_changes(const Search& search, const SearchOptions& options, SearchRun& run);

/// Computes the regions of the listed designs.
bool complete_regions(const Search& search, const SearchOptions& options, SearchRun& run);

}  // namespace gearwright
