// Findings other than warnings: clearances that are too small, and the position of the contact.
// Internal to verdict/.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Findings for clearances that are not negative but below their margins.
std::vector<Finding> margin_findings(const Pair& pair);

/// Findings for contact at edges, and for a contact pattern away from the middle of the face.
std::vector<Finding> contact_findings(const ContactResult& contact,
                                      const std::array<double, 2>& face_widths);

// Findings for safety factors that are too low, and changes that would raise them sufficiently.

/// Changes that the rating confirms as sufficient: "6 mm more face width, or 17CrNiMo6 would be
/// sufficient."
std::string rating_remedy(const JudgedRating& rating);

/// One finding for each safety factor below its requirement: red if it is below 1, otherwise amber.
std::vector<Finding> rating_findings(const JudgedRating& rating);

}  // namespace gearwright::detail
