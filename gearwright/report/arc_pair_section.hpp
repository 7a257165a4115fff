// The part of the page about a pair of circular-arc gears: its numbers, and each contact in the
// transverse section through it.
#pragma once

#include <array>
#include <string>

#include "gearwright/pair/arc_pair.hpp"

namespace gearwright {

/// The section of the page; `shapes` are the names of the gears' definitions (gear_shape.hpp).
std::string arc_pair_section(const ArcPair& pair, const std::array<std::string, 2>& shapes);

/// Where the gears are turned to in the section through a contact, rad counter-clockwise: the
/// angles of their x axes.
std::array<double, 2> angles_at_contact(const ArcPair& pair, const ArcPairContact& contact);

}  // namespace gearwright
