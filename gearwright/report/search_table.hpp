// The designs of a search as a sortable table.
#pragma once

#include <string>

#include "gearwright/design/search.hpp"

namespace gearwright {

/// The first `rows` designs; a row has the id "design-1", … . Columns that have no meaning for this
/// search (helix of spur gears, a front of one objective) are omitted.
std::string design_table(const SearchProblem& problem, const SearchAnswer& answer,
                         std::size_t rows);

/// The meaning of the columns, folded.
std::string design_table_key(const SearchProblem& problem, const SearchAnswer& answer,
                             std::size_t rows);

/// Turns the headings of the table into buttons; without it the table is static.
/// The file report/page/sort_script.js.
std::string_view sort_script();

}  // namespace gearwright
