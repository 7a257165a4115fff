// Findings that no warning says: clearances that are too small to trust, and where the teeth touch.
// Internal to verdict/.
#pragma once

#include <vector>

#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Clearances ≥ 0 below their margins.
std::vector<Finding> margin_findings(const Pair& pair);

/// Edges that touch, and a pattern off the middle of the face.
std::vector<Finding> contact_findings(const ContactResult& contact, const Pair& pair);

}  // namespace gearwright::detail
