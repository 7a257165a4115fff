// Rejects searches that are too large before they begin. Candidates are counted in closed form, the
// speed is measured for half a second, and the points of a grid are estimated.
//
// Internal to job/.
#pragma once

#include <optional>

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// The reason why the search must not begin, or nothing if it may begin.
std::optional<Error> refuse_large(const Search& search, const SearchOptions& options);

/// The error for a spec without a search.
Error no_search();
/// The error for a search without candidates.
Error no_tooth_numbers();

/// Determines when regions are computed: at once if the ranking or a table of all designs needs
/// them, otherwise at the end and only for the listed designs.
RegionDetail detail_of(const SearchProblem& problem, bool files);

}  // namespace gearwright
