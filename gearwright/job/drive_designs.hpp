// The designs of a search for drives. The candidates are computed in their order, in the same way
// as by the verb drive, rated if the search requires safeties, and listed if the verdict is green.
// Internal to job/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/drive_search_quantities.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// The numbers of teeth of a candidate, "sun 19, planet 17, ring 56".
std::string teeth_text(const DriveCandidate& c);

/// A candidate as a spec of the verb drive: the common keys of the search, and its own numbers.
Json drive_spec(const JobSpec& spec, const DriveSearchProblem& problem, const DriveCandidate& c);

/// True if the designs of the search are rated.
bool rates_drives(const JobSpec& spec, const DriveSearchProblem& problem);

/// The candidates that the result lists: the `top` best by the first objective and, with several
/// objectives, at most as many more of the Pareto front. Candidates without a green verdict are
/// replaced by the next ones, until kMostComputedDrives have been computed.
///
/// Errors    of a rating: a module, its load or a material is missing or wrong
Result<DriveDesigns> drive_designs(const JobSpec& spec, const DriveSearchProblem& problem,
                                   const DriveSearchResult& result, std::size_t top, int threads);

/// Greatest number of candidates that are computed.
inline constexpr std::size_t kMostComputedDrives = 20000;

}  // namespace gearwright
