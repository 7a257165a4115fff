// Reads [scatter]: toleranced numbers as a list of two or a table, and the groups of inputs.
//
// Internal to spec/: throws SpecError, as the readers of single values do.
#pragma once

#include "gearwright/catalogue/scatter_keys.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

ScatterInput read_scatter(const Json& table);

}  // namespace gearwright
