// Converts between a tip radius and the curvature radius of the flank at the tip, and tightens
// bounds. Internal to design/.
//
//   u, b   tip and base radius
//   q      √(u² − b²), curvature radius of the flank at its tip
#pragma once

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/gear/leaf_formulas.hpp"

namespace gearwright::detail {

/// Returns q for the tip radius u. If the tip lies inside the base circle, q is 0. The signs of u
/// and b have no effect.
inline double curvature(double u, double b) { return leaf::curvature_at(std::abs(u), std::abs(b)); }
/// Returns |u| for the curvature radius q.
inline double radius_of(double q, double b) { return std::sqrt(b * b + q * q); }

inline void raise(double& lo, double value) { lo = std::max(lo, value); }
inline void lower(double& hi, double value) { hi = std::min(hi, value); }

}  // namespace gearwright::detail
