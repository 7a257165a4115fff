// What a search rates its designs by: [rating] and the materials, where [search] asks for safety.
//
// Internal to spec/: throws SpecError.
#pragma once

#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// The search asks for a rating: by a safety, or by mass beside a [rating].
bool wants_rating(const SearchProblem& problem, const RatingTable& rating);

/// Completes the problem: densities of the materials, and what a rating needs where one is wanted.
/// Without a problem, in which something is missing, only what a rating would lack.
void read_search_rating(const Json& tree, JobSpec& spec);

}  // namespace gearwright
