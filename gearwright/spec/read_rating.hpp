// Reads [rating] and [gearN.material]. Internal to spec/: throws SpecError.
#pragma once

#include <string>

#include "gearwright/catalogue/material_keys.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// Without a torque where no load was given. What was read before something turns out to be missing
/// stays in `rating`.
void read_rating(const Json& node, RatingTable& rating);
MaterialInput read_material(const Json& node, const std::string& path);

}  // namespace gearwright
