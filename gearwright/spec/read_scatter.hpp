// Reads [scatter]: the groups of inputs and the toleranced numbers, each a list of two numbers or a
// table.
//
// Internal to spec/. The functions throw SpecError, like the readers of single values.
#pragma once

#include "gearwright/catalogue/scatter_keys.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

ScatterInput read_scatter(const Json& table);

}  // namespace gearwright
