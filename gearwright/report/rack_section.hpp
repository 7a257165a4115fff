// The section of the report about a rack and its pinion: a picture of the mesh, and the quantities
// of both.
#pragma once

#include <string>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

/// Returns the section in HTML. `shape` is the name of the SVG definition of the pinion
/// (gear_shape.hpp). If the rack has no outline, a paragraph with the reason replaces the picture.
std::string rack_section(const RackPair& pair, const std::string& shape, UnitSystem units);

}  // namespace gearwright
