// Designs as a sortable table, and the table of a search.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright {

struct TableColumn {
  std::string head;                      ///< HTML
  std::string unit, meaning;             ///< plain text
  std::string_view first = "ascending";  ///< the order of the first click
};
struct TableCell {
  std::string html;
  std::optional<double> key;  ///< by which the column is sorted; rows without one come last
};
struct TableRow {
  std::string attributes;  ///< of the element, with a space in front
  std::vector<TableCell> cells;
};

/// A table with a column of ranks before the given columns. `rows` are in the order of their ranks.
std::string sortable_table(const std::vector<TableColumn>& columns,
                           const std::vector<TableRow>& rows);
/// The meaning of the columns, folded.
std::string column_key(const std::vector<TableColumn>& columns);

/// The first `rows` designs. The ids of the rows are "design-1", … . Columns that have no meaning
/// for this search (helix of spur gears, front of a single objective) are omitted.
std::string design_table(const SearchProblem& problem, const SearchAnswer& answer,
                         std::size_t rows);

/// The meaning of the columns, folded.
std::string design_table_key(const SearchProblem& problem, const SearchAnswer& answer,
                             std::size_t rows);

/// Makes the headings of the table buttons that sort it. Without this script the table is static.
/// The file is report/page/sort_script.js.
std::string_view sort_script();

}  // namespace gearwright
