// A search whose finished chunks stay in a folder: it can be stopped, resumed and shared.
//
// Internal to job/. What it needs, the store, is not in every build: search_campaign_without.cpp.
#pragma once

#include <optional>

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// Why this build keeps no folder of a search; none: it does.
std::optional<Error> refuse_folder();

/// Why no files of this search may be written into the folder: a finished search of another spec has its
/// own there. None: there is none, or its spec says the same.
std::optional<Error> refuse_other_search(const std::filesystem::path& folder, const JobSpec& spec);

/// Runs what is missing of the search in options.out, and makes its files when nothing is.
///
/// Throws    IoError
/// Errors    a campaign, or a finished search of another spec, that is there already; --resume of none
///           or of another spec
Result<SearchRun> run_campaign(const JobSpec& spec, const Search& search, std::int64_t chunk,
                               const SearchOptions& options);

}  // namespace gearwright
