// The designs of a search as a sortable table.
#pragma once

#include <string>

#include "gearwright/design/search.hpp"

namespace gearwright {

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
