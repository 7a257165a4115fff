// Findings without a warning: clearances that are too small, and the position of the contact.
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
