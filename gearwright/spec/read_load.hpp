// Reads [load]. Internal to spec/: throws SpecError.
#pragma once

#include "gearwright/catalogue/load_keys.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

LoadInput read_load(const Json& node);

}  // namespace gearwright
