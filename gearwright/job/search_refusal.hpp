// Searches that are too large, told apart before they begin: candidates are counted in closed form,
// what they would take is measured for half a second, points of a grid are estimated.
//
// Internal to job/.
#pragma once

#include <optional>

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// Why the search is not begun; none: it is.
std::optional<Error> refuse_large(const Search& search, const SearchOptions& options);

/// That a spec describes no search.
Error no_search();
/// Why a search of no candidates is not begun.
Error no_tooth_numbers();

/// Regions are computed for what is ranked by them or goes into a table of all designs; else for
/// what is listed, at the end.
RegionDetail detail_of(const SearchProblem& problem, bool files);

}  // namespace gearwright
