// Reads the inputs of a search beyond its own table: those for rating its designs, from [rating] and
// the materials, if [search] requires safety; and settings of a search whose designs are checked as
// drawings: tolerances, the verdict over the drawings, and default limits that exclude impractical
// designs.
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

/// Drawings are checked if the search has a rating, face widths or allowances, unless designs with
/// interference are listed too. `search`: the table; its rating has been read.
void read_search_drawing(const Json& search, SearchProblem& problem);

}  // namespace gearwright
