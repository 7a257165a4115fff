// The catalogue's quantities as a table of the page.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

/// Adds a group's rows without its heading.
void add_rows(TableBuilder& table, const TextGroup& group);
/// Adds the rows of the groups to a table: a value per column, or one that is common to all. The
/// table has as many columns as there are records, or two beside one record (a pair).
void add_groups(TableBuilder& table, const std::vector<TextGroup>& groups);

}  // namespace gearwright
