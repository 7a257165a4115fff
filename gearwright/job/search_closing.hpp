// What is left when all trials of a search are done: what would help where nothing is feasible, and
// the regions of the designs that are listed.
//
// Internal to job/ and apps. Both say whether to go on: they stop where the options say so.
#pragma once

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// Nothing is feasible: what would help.
bool look_for_changes(const Search& search, const SearchOptions& options, SearchRun& run);

/// The regions of the designs that are listed.
bool complete_regions(const Search& search, const SearchOptions& options, SearchRun& run);

}  // namespace gearwright
