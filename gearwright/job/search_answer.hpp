// Makes the outputs of a search, which are the JSON, the table for users, and a design as the spec
// of a pair. Internal to job/ and the programs.
#pragma once

#include <string>

#include "gearwright/job/search_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// The number of designs in the table for users.
inline constexpr std::size_t kListedDesigns = 20;

/// Returns one design as JSON with the keys of search.designs[i].
Json design_row_json(const Search& search, const DesignRow& row, bool with_edges = true);

Json search_json(const Search& search, const SearchRun& run, UnitSystem units);
/// Returns the text of search_json(). For mm, the text has one design per line.
std::string search_json_text(const Search& search, const SearchRun& run,
                             UnitSystem units = UnitSystem::mm);

Json unfinished_json(const SearchRun& run);

/// Lists the counts and the best designs in these units. If there are no designs, lists changes
/// that would give a design.
std::string search_listing(const Search& search, const SearchRun& run, UnitSystem units);

/// Describes the rating, for example "rated by ISO 6336:2006, 300 N m on gear 1, face width 10
/// modules, S_H ≥ 1.1". The text is empty if the designs are not rated.
std::string rating_line(const SearchProblem& problem);
/// Describes the drawings of designs and their default limits. The text is empty if no drawings are
/// checked.
std::string drawing_line(const SearchProblem& problem);

/// Returns one line for each change, for example "search.contact_ratio_min = 1.17 instead of 1.2".
std::vector<std::string> change_lines(const SearchRun& run, UnitSystem units);

std::string search_page(const JobSpec& spec, const Search& search, const SearchRun& run);

/// Copies the accuracy grade of the rating to the table of the gear, so that the drawing of the
/// gear has tolerances. Does nothing if the rating has no grade, if the edition of ISO 1328-1 that
/// the rating uses does not contain this grade, or if the table already has a grade. `which` is 0
/// for gear 1 and 1 for gear 2.
void add_grade(Json& gear, const RatingInput& rating, std::size_t which);

/// Returns a design as a spec for the other verbs.
Json pair_spec(const JobSpec& spec, const Search& search, const DesignRow& row);

}  // namespace gearwright
