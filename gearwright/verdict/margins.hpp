// Findings other than warnings: clearances that are too small, and the position of the contact.
// Internal to verdict/.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// Findings for clearances that are not negative but below their margins.
std::vector<Finding> margin_findings(const Pair& pair);

/// A finding if the backlash j_n is 0. `recommended` is the least recommended one; none for a rack.
std::vector<Finding> backlash_findings(double j_n, std::optional<double> recommended);

/// Findings for contact at edges, and for a contact pattern away from the middle of the face.
std::vector<Finding> contact_findings(const ContactResult& contact,
                                      const std::array<double, 2>& face_widths);

}  // namespace gearwright::detail
