// The part of the report about a rack and its pinion: the mesh in section and the quantities of
// both.
#pragma once

#include <string>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

/// Returns the section of the page. `shape` is the name of the pinion's definition
/// (gear_shape.hpp). If the rack has no outline, a paragraph gives the reason in place of the
/// picture.
std::string rack_section(const RackPair& pair, const std::string& shape, UnitSystem units);

}  // namespace gearwright
