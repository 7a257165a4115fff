// The designs of a search for drives. Each candidate is computed as by the verb `drive`, in the
// order of the candidates. It is rated if the search requires safeties, and listed if its verdict
// is green. Internal to job/.
#pragma once

#include <string>

#include "gearwright/catalogue/drive_search_quantities.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// The numbers of teeth of a candidate, "sun 19, planet 17, ring 56", for a train with different
/// modules of its stages with these modules, "19:58 (m 1.5), 20:66 (m 2.5)".
std::string teeth_text(const DriveCandidate& c);

/// A candidate as a spec for the verb `drive`, from the keys that all candidates share and the
/// numbers of the candidate.
Json drive_spec(const JobSpec& spec, const DriveSearchProblem& problem, const DriveCandidate& c);

/// True if the designs of the search are rated.
bool rates_drives(const JobSpec& spec, const DriveSearchProblem& problem);

/// The candidates that the result lists: the `top` best by the first objective and, if there are
/// several objectives, up to `top` more from the Pareto front. The next candidate replaces a
/// candidate without a green verdict, until kMostComputedDrives candidates of the same module have
/// been computed. Trains are left out if, by the estimate of design/train_strength.hpp, they cannot
/// have the required safeties, or if the sliding of one stage exceeds the limit. If each stage may
/// have its own module, it gets the least one with which it has the required safeties.
///
/// Law       a search over a list of modules finds a drive if a search with one of these modules
///           alone finds a drive
/// Errors    a module, or the load or a material of a rating, is missing or wrong
Result<DriveDesigns> drive_designs(const JobSpec& spec, const DriveSearchProblem& problem,
                                   const DriveSearchResult& result, std::size_t top, int threads);

/// Greatest number of candidates of each module that are computed.
inline constexpr std::size_t kMostComputedDrives = 20000;

}  // namespace gearwright
