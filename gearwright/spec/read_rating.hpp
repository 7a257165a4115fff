// Reads [rating] and [gearN.material]. Internal to spec/: throws SpecError.
#pragma once

#include <string>

#include "gearwright/catalogue/material_keys.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// Without a torque where no load was given: missing_for_rating() says so, with what else is.
RatingTable read_rating(const Json& node);
MaterialInput read_material(const Json& node, const std::string& path);

}  // namespace gearwright
