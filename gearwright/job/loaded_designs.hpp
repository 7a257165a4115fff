// The transmission error under load of the best designs of a search.
//
// A search that ranks by noise estimates the transmission error of every design. The transmission
// error under load is computed only for the best designs, because it takes seconds for each design.
// It is computed in the same way as by the verb `load` for the spec of the design. If the noise is
// the first objective, these designs are then sorted by it. Internal to job/ and the programs.
//                                              theory: docs/theory/09-design-search.md, 9.8
#pragma once

#include <string>
#include <vector>

#include "gearwright/job/search_job.hpp"

namespace gearwright {

/// Returns the number of designs that a search must keep if it lists `top` designs. This number
/// includes all designs whose transmission error under load is computed, so the order of the listed
/// designs does not depend on `top`.
std::size_t designs_to_keep(const SearchProblem& problem, std::size_t top);

/// Returns the number of designs of the answer whose transmission error under load is computed.
std::size_t designs_to_load(const SearchProblem& problem, const SearchAnswer& answer);

/// Computes the peak-to-peak transmission error under load of one design. If the spec has several
/// torques, the result is the greatest of the values. If the analysis has no result at some
/// position of the pitch, the design has none either, because the remaining positions may not
/// contain the extremes.
LoadedDesign loaded_design(const JobSpec& spec, const Search& search, const DesignRow& row);

/// Stores the results in the first designs of the answer. If the noise is the first objective,
/// these designs are sorted by the results. Designs on the Pareto front stay first, and designs
/// with an estimated noise stay before designs without one. Within each of these groups, designs
/// without a result come last. Only the first `top` designs are kept.
void rank_loaded(const SearchProblem& problem, std::vector<LoadedDesign> loaded, std::size_t top,
                 SearchAnswer& answer);

/// Returns a sentence about the computed designs and their order, for example "The transmission
/// error under load is computed for the first 10 designs, and these designs are ordered by it."
std::string loaded_line(const SearchProblem& problem, const SearchAnswer& answer);

/// Returns a sentence with the reason for each design whose transmission error under load cannot be
/// computed.
std::vector<std::string> load_failures(const SearchAnswer& answer);

/// Computes the transmission error under load of the best designs with the threads of the search,
/// and calls rank_loaded(). Returns false if SearchOptions::stop ended the run.
bool load_designs(const JobSpec& spec, const Search& search, const SearchOptions& options,
                  SearchRun& run);

}  // namespace gearwright
