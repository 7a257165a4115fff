// What gears with few teeth have beyond other gears: the points F, C and J, and circular fillets.
// Symbols: root_picture.hpp.
#pragma once

#include <string>
#include <vector>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The table; empty when no gear has any of it.
std::string few_teeth_table(const std::vector<const Gear*>& gears);

}  // namespace gearwright
