// Output of a search: its JSON, its table for users, and a design as the spec of a pair.
// Internal to job/ and the program.
#pragma once

#include <string>

#include "gearwright/job/search_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Designs in the table for people.
inline constexpr std::size_t kListedDesigns = 20;

/// One design: the interface's keys of search.designs[i].
Json design_row_json(const Search& search, const DesignRow& row, bool with_edges = true);

/// The whole result as text, one design per line, because the array may be long.
std::string search_json_text(const Search& search, const SearchRun& run);

/// The result of a run that has not finished, or was stopped.
Json unfinished_json(const SearchRun& run);

/// Counts, the best designs, and changes that would help if there are none.
std::string search_listing(const Search& search, const SearchRun& run,
                           std::size_t most = kListedDesigns);

/// Conditions of all designs: "every design runs without interference, form clearance >= 0.02
/// modules, …"
std::string margin_line(const SearchLimits& limits);

/// "rated by ISO 6336:2006, 300 N m on gear 1, face width 10 modules, S_H >= 1.1"; empty if designs
/// are not rated.
std::string rating_line(const SearchProblem& problem);
/// Describes the drawings of designs, with their default limits; empty if designs are not drawn.
std::string drawing_line(const SearchProblem& problem);

/// "through contact_ratio_min = 1.17 instead of 1.2", one line for each change.
std::vector<std::string> change_lines(const SearchRun& run);

/// "the limit …: 2698", in the order of the limits; without those that rejected none.
std::vector<std::string> rejected_lines(const SearchCounts& counts);

/// The page of the search.
std::string search_page(const JobSpec& spec, const Search& search, const SearchRun& run);

/// A design as a spec for the other verbs.
Json pair_spec(const JobSpec& spec, const Search& search, const DesignRow& row);

}  // namespace gearwright
