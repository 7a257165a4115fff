// Reads the inputs for rating the designs of a search: [rating] and the materials, if [search]
// requires safety.
//
// Internal to spec/: throws SpecError.
#pragma once

#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// True if the search needs a rating: for a safety, or for mass if [rating] is given.
bool wants_rating(const SearchProblem& problem, const RatingTable& rating);

/// Completes the problem with densities of the materials, and with the inputs of a rating if one is
/// needed. If the problem is incomplete, only the missing inputs of a rating are collected.
void read_search_rating(const Json& tree, JobSpec& spec);

}  // namespace gearwright
