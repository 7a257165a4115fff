// The designs of a search as a sortable table.
#pragma once

#include <string>

#include "gearwright/design/search.hpp"

namespace gearwright {

/// A table of the first `rows` designs. Its rows have the ids "design-1", "design-2" and so on.
/// Columns that have no meaning for this search are omitted, such as the helix angle of spur gears
/// or the front of a single objective.
std::string design_table(const SearchProblem& problem, const SearchAnswer& answer,
                         std::size_t rows);

/// The meaning of the columns, in a folded section.
std::string design_table_key(const SearchProblem& problem, const SearchAnswer& answer,
                             std::size_t rows);

/// The script report/page/sort_script.js, which turns the column headings into buttons that sort
/// the table. Without the script the table is static.
std::string_view sort_script();

}  // namespace gearwright
