// The tables of the report: each gear as on its drawing, the pair, its path, what gets in the way.
#pragma once

#include <string>
#include <vector>

#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Gears side by side: what was given, then what follows. Digits: html_text.hpp.
std::string gear_table(const std::vector<const Gear*>& gears);

/// Centre distances, working angles, contact ratios, backlash, clearances, sliding.
std::string pair_table(const Pair& pair);

/// A … E: distance from the pitch point, radii of curvature, sliding.
std::string path_table(const Pair& pair);

/// Interference by name and amount, or the sentence that none was found.
std::string interference_table(const Pair& pair);

}  // namespace gearwright
