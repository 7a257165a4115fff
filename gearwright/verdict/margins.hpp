// Finds clearances and backlash that are too small, an unfavourable position of the contact, and
// safety factors that are too low.
// Internal to verdict/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Returns findings for clearances that are not negative but below their margins.
std::vector<Finding> margin_findings(const Pair& pair);

std::vector<Finding> backlash_findings(const StatedBacklash& j);

/// Returns findings for contact at edges, and for a contact pattern near the end of the face.
std::vector<Finding> contact_findings(const PatternPlace& place);

/// Returns a sentence with the changes that raise all safety factors to their required values, for
/// example "6 mm more face width, or the steel 17CrNiMo6 would be sufficient." If no single change
/// is sufficient, the text states this and, unless K_Hβ is computed from the load along the teeth,
/// the greatest permissible torque. With a load spectrum, the safety factors are those under the
/// spectrum, and the text has no torque.
std::string rating_remedy(const PairRating& rating);

/// Returns one finding for each safety factor below its required value, under the spectrum or, if
/// there is none, under the single load. The finding is red if the safety factor is below 1, and
/// otherwise amber.
std::vector<Finding> rating_findings(const PairRating& rating);

}  // namespace gearwright::detail
