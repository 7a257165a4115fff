// The designs of a search as a table whose columns sort it.
#pragma once

#include <string>

#include "gearwright/design/search.hpp"

namespace gearwright {

/// The first `rows` designs; a row has the id "design-1", … . Columns that say nothing about this
/// search (helix of spur gears, a front of one objective) are left out.
std::string design_table(const SearchProblem& problem, const SearchAnswer& answer,
                         std::size_t rows);

/// What the columns mean, folded.
std::string design_table_key(const SearchProblem& problem, const SearchAnswer& answer,
                             std::size_t rows);

/// Makes the headings of the table buttons; without it the table stands as it is.
/// The file report/page/sort_script.js.
std::string_view sort_script();

}  // namespace gearwright
