// Reads the inputs of a search that are outside its own table. If [search] requires safety, these
// are the inputs for rating the designs, from [rating] and the materials. For a search that checks
// its designs as drawings, they are the tolerances, the verdict on the drawings, and default limits
// that exclude impractical designs.
//
// Internal to spec/. The functions throw SpecError.
#pragma once

#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// True if the search needs a rating, either for a safety or, if [rating] is given, for the mass.
bool wants_rating(const SearchProblem& problem, const RatingTable& rating);

/// Adds the densities of the materials to the problem, and the inputs of a rating if one is needed.
/// If the problem is incomplete, only the missing inputs of a rating are collected.
void read_search_rating(const Json& tree, JobSpec& spec);

/// Checks the name of a series of thickness allowances, the key `thickness_series`. "none" becomes
/// an empty name.
void check_series(const TableReader& t, std::string& series);

/// The default series of thickness allowances for a search.
inline constexpr const char* kUsualSeries = "cd25";

/// Sets the check of drawings if the search has a rating, face widths or allowances, unless designs
/// with interference are also listed. `search` is the table. Its rating must have been read before.
void read_search_drawing(const Json& search, SearchProblem& problem);

}  // namespace gearwright
