// Insufficient safety factors of a strength rating, and changes that would be sufficient.
//
// Internal to verdict/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// "6 mm more face width, or 17CrNiMo6 would hold.": changes that were rated and are sufficient.
std::string rating_remedy(const JudgedRating& rating);

/// A finding for each insufficient safety: red if it is below 1, amber if it is below the required safety.
std::vector<Finding> rating_findings(const JudgedRating& rating);

}  // namespace gearwright::detail
