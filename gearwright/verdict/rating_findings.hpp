// Findings for safety factors that are too low, and changes that would raise them sufficiently.
//
// Internal to verdict/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// A sentence with the changes that raise all safety factors to their required values: "6 mm more
/// face width, or 17CrNiMo6 would be sufficient." If no single change is sufficient, the sentence
/// states the greatest permissible torque.
std::string rating_remedy(const JudgedRating& rating);

/// One finding for each safety factor below its requirement: red if it is below 1, otherwise amber.
std::vector<Finding> rating_findings(const JudgedRating& rating);

}  // namespace gearwright::detail
