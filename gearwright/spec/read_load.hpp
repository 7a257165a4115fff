// Reads [load] and [gearN.material]. Internal to spec/: throws SpecError.
#pragma once

#include <string>

#include "gearwright/catalogue/load_keys.hpp"
#include "gearwright/catalogue/material_keys.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

LoadInput read_load(const Json& node);
MaterialInput read_material(const Json& node, const std::string& path);

}  // namespace gearwright
