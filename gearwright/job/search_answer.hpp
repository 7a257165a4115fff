// What a search prints: its JSON, its table for people, and a design as the spec of a pair.
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

/// The whole result as text, one design a line: the array may be long.
std::string search_json_text(const Search& search, const SearchRun& run);

/// The same for a run that made no result yet, or was stopped.
Json unfinished_json(const SearchRun& run);

/// Counts, the best designs, and what would help when there are none.
std::string search_listing(const Search& search, const SearchRun& run,
                           std::size_t most = kListedDesigns);

/// What all designs keep: "every design runs without interference, form clearance >= 0.02 modules, …"
std::string margin_line(const SearchLimits& limits);

/// "rated by ISO 6336:2006, 300 N m on gear 1, face width 10 modules, S_H >= 1.1"; empty: not rated.
std::string rating_line(const SearchProblem& problem);
/// How designs are drawn, with the limits that hold for them by default; empty: they are not.
std::string drawing_line(const SearchProblem& problem);

/// "through contact_ratio_min = 1.17 instead of 1.2", one line for each change.
std::vector<std::string> change_lines(const SearchRun& run);

/// "the limit …: 2698", in the order of the limits; without those that ruled none out.
std::vector<std::string> rejected_lines(const SearchCounts& counts);

/// The page about it.
std::string search_page(const JobSpec& spec, const Search& search, const SearchRun& run);

/// A design as a spec that the other verbs take.
Json pair_spec(const JobSpec& spec, const Search& search, const DesignRow& row);

}  // namespace gearwright
