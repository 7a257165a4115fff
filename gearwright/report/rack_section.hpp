// The section of the report about a rack and its pinion: a picture of the mesh, and the quantities
// of both.
#pragma once

#include <array>
#include <string>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

/// Returns the section in HTML. `shapes` are the names of the SVG definitions of pinion and rack, of which the
/// page contains that of the pinion. If the rack has no outline, a paragraph with the reason replaces the
/// picture.
std::string rack_section(const RackPair& pair, const std::array<std::string, 2>& shapes,
                         UnitSystem units);

}  // namespace gearwright
