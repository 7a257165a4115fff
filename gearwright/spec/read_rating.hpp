// Reads [rating] and [gearN.material]. Internal to spec/: throws SpecError.
#pragma once

#include <string>

#include "gearwright/catalogue/material_keys.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

RatingTable read_rating(const Json& node);
MaterialInput read_material(const Json& node, const std::string& path);

}  // namespace gearwright
