// Writes sortable tables of designs, in particular the table of a search.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/design/design_row.hpp"
#include "gearwright/design/search.hpp"
#include "gearwright/design/search_problem.hpp"

namespace gearwright {

struct TableColumn {
  std::string head;                      ///< HTML
  std::string unit, meaning;             ///< plain text
  std::string_view first = "ascending";  ///< order of the rows after a first click on the heading
};
struct TableCell {
  std::string html;
  std::optional<double> key;  ///< value by which the column is sorted; cells without a value come
                              ///< last
};
struct TableRow {
  std::string attributes;  ///< HTML attributes of the row, with a space in front
  std::vector<TableCell> cells;
};

/// Writes a table with a column of ranks before the given columns. `rows` are in the order of rank.
std::string sortable_table(const std::vector<TableColumn>& columns,
                           const std::vector<TableRow>& rows);
/// Writes the headings of the columns with their meanings, in a folded section.
std::string column_key(const std::vector<TableColumn>& columns);

/// Writes a table of the first `rows` designs. Its rows have the ids "design-1", "design-2" and so
/// on. Columns that have no meaning for this search are omitted, such as the helix angle of spur
/// gears or the front of a single objective.
std::string design_table(const SearchProblem& problem, const SearchAnswer& answer, std::size_t rows,
                         UnitSystem units);

/// Writes the headings of the columns of design_table() with their meanings, in a folded section.
std::string design_table_key(const SearchProblem& problem, const SearchAnswer& answer,
                             std::size_t rows, UnitSystem units);

/// Returns the script report/page/sort_script.js, which turns the column headings into buttons that
/// sort the table. Without the script, the table is static.
std::string_view sort_script();

/// Returns the reason for rejecting a trial, such as "centre distance out of reach".
std::string_view words_of(Limit limit);

/// A reason for rejecting trials, and the number of these trials.
struct RejectedBy {
  std::string words;
  std::int64_t trials;
  bool of_verdict;  ///< true for a finding, whose trials are a part of those of the limit `verdict`
};
/// Returns the limits that reject trials, followed by the findings of the verdict.
std::vector<RejectedBy> rejected_by(const SearchCounts& counts);

/// Words for an objective, to be used on axes and in sentences.
struct ObjectiveWords {
  std::string_view name;    ///< "contact ratio"
  std::string_view symbol;  ///< "ε_α", written as in figure/markup.hpp; may be empty
  std::string_view unit;    ///< may be empty
};
ObjectiveWords words_of(Objective objective);

/// Returns the order of the designs in words. For one objective, this is "by contact ratio". For
/// several objectives, it is "by size; the designs on the Pareto front over size and contact ratio
/// come first".
std::string order_in_words(const SearchProblem& problem);

/// Returns the value of the objective for any design, ranked or not. Returns none for the specific
/// sliding |ζ| if a flank reaches its base tangent point.
std::optional<double> value_of(const SearchProblem& problem, const DesignRow& row,
                               Objective objective);

/// Returns module and tooth numbers, for example "2.5 · 28:54". For a helical pair, returns "2.5 ·
/// 28:54 · 8°" with the helix angle.
std::string design_name(const Trial& trial);

}  // namespace gearwright
