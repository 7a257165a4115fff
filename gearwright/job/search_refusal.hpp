// Rejects searches that are too large before they begin: candidates are counted in closed form,
// their speed is measured for half a second, and points of a grid are estimated.
//
// Internal to job/.
#pragma once

#include <optional>

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// The reason why the search does not begin; none if it does.
std::optional<Error> refuse_large(const Search& search, const SearchOptions& options);

/// The error that a spec describes no search.
Error no_search();
/// The error of a search without candidates.
Error no_tooth_numbers();

/// Regions are computed immediately if the ranking or a table of all designs needs them, otherwise
/// at the end for the listed designs.
RegionDetail detail_of(const SearchProblem& problem, bool files);

}  // namespace gearwright
