// Findings for safety factors that are too low, and changes that would raise them sufficiently.
//
// Internal to verdict/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Changes that the rating confirms as sufficient: "6 mm more face width, or 17CrNiMo6 would be
/// sufficient."
std::string rating_remedy(const JudgedRating& rating);

/// One finding for each safety factor below its requirement: red if it is below 1, otherwise amber.
std::vector<Finding> rating_findings(const JudgedRating& rating);

}  // namespace gearwright::detail
