// A search whose finished chunks stay in a folder: it can be stopped, resumed and shared.
//
// Internal to job/. It needs the store, which is not in every build: search_campaign_without.cpp.
#pragma once

#include <optional>

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// The reason why this build cannot keep a folder of a search; none if it can.
std::optional<Error> refuse_folder();

/// The reason why this search must not write files into the folder: it contains those of a finished
/// search of another spec. None if there is no such search.
std::optional<Error> refuse_other_search(const std::filesystem::path& folder, const JobSpec& spec);

/// Runs the missing chunks of the search in options.out, and makes its files when none is missing.
///
/// Throws    IoError
/// Errors    an existing campaign, or a finished search of another spec; --resume without a
///           campaign or for another spec
Result<SearchRun> run_campaign(const JobSpec& spec, const Search& search, std::int64_t chunk,
                               const SearchOptions& options);

}  // namespace gearwright
