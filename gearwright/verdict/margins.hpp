// Findings other than warnings: clearances and backlash that are too small, the position of the
// contact, and safety factors that are too low.
// Internal to verdict/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Findings for clearances that are not negative but below their margins.
std::vector<Finding> margin_findings(const Pair& pair);

/// A finding if there is no backlash.
std::vector<Finding> backlash_findings(const StatedBacklash& j);

/// Findings for contact at edges, and for a contact pattern that lies near the end of the face.
std::vector<Finding> contact_findings(const PatternPlace& place);

/// A sentence with the changes that raise all safety factors to their required values, for example
/// "6 mm more face width, or the steel 17CrNiMo6 would be sufficient." If no single change is
/// sufficient, the sentence states the greatest permissible torque.
std::string rating_remedy(const JudgedRating& rating);

/// One finding for each safety factor below its requirement: red if it is below 1, otherwise amber.
std::vector<Finding> rating_findings(const JudgedRating& rating);

}  // namespace gearwright::detail
