// A search that saves its finished chunks in a folder, so that it can be stopped, resumed and
// shared.
//
// Internal to job/. A build without the store uses search_campaign_without.cpp.
#pragma once

#include <optional>

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// The reason why this build cannot save a search in a folder, or nothing if it can.
std::optional<Error> refuse_folder();

/// The reason why this search must not write files into the folder, which contains the finished
/// search of another spec. Nothing is returned if there is no such search.
std::optional<Error> refuse_other_search(const std::filesystem::path& folder, const JobSpec& spec);

/// Runs the missing chunks of the search in options.out. If no chunk is missing, the files are
/// made.
///
/// Throws    IoError
/// Errors    an existing campaign, or a finished search of another spec; --resume without a
///           campaign or for another spec
Result<SearchRun> run_campaign(const JobSpec& spec, const Search& search, std::int64_t chunk,
                               const SearchOptions& options);

}  // namespace gearwright
