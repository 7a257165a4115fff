// What a strength rating says to the verdict: safeties that fall short, and what would help.
//
// Internal to verdict/.
#pragma once

#include <vector>

#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Red where a safety is below 1, amber where it is below the wanted one.
std::vector<Finding> rating_findings(const JudgedRating& rating);

}  // namespace gearwright::detail
