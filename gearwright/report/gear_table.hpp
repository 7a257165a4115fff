// The table of the gears' data: as on the drawing, what follows from it, and how they were cut.
#pragma once

#include <string>
#include <vector>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// Gears side by side: what was given, then what follows. Digits: html_text.hpp.
std::string gear_table(const std::vector<const Gear*>& gears);

}  // namespace gearwright
