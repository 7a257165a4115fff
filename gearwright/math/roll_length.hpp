// Radius of curvature of an involute.              theory: docs/theory/02-involute-and-pair.md
#pragma once

#include <algorithm>
#include <cmath>

namespace gearwright {

/// ρ = √(r² − r_b²), the radius of curvature of the involute at the radius r, which is also its rolling
/// length r_b ξ; 0 inside the base circle.
///
/// Formula   [T2.2]
/// Units     mm
inline double roll_length(double radius, double base_radius) {
  return std::sqrt(std::max(0.0, (radius - base_radius) * (radius + base_radius)));
}

}  // namespace gearwright
