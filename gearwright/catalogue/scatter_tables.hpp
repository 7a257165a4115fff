// The tables of a scatter for users. The terminal and the report show them in this order.
#pragma once

#include <string_view>
#include <vector>

#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/catalogue/text_table.hpp"
#include "gearwright/catalogue/unit_system.hpp"

namespace gearwright {

std::vector<TextTable> scatter_tables(const ScatterView& view, UnitSystem units);

}  // namespace gearwright
