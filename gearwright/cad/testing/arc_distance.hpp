// Searches for the distance between a point of a drawing and an exact arc. The fits measure their
// deviation with osculating circles. This search shares no code with them.
#pragma once

#include <algorithm>
#include <cmath>

#include "gearwright/generation/outline.hpp"

namespace gearwright::testing {

/// Returns the distance from q to the arc, mm. Ternary search refines the nearest of 400 samples.
inline double distance_to_arc(const Arc& arc, const Vec2& q) {
  constexpr int kSteps = 400;
  const auto distance = [&](double u) { return (arc.point(u) - q).norm(); };
  int nearest = 0;
  for (int i = 1; i <= kSteps; ++i) {
    const double u = static_cast<double>(i) / kSteps;
    if (distance(u) < distance(static_cast<double>(nearest) / kSteps)) nearest = i;
  }
  double lo = std::max(0.0, (nearest - 1.0) / kSteps);
  double hi = std::min(1.0, (nearest + 1.0) / kSteps);
  double best = distance(static_cast<double>(nearest) / kSteps);
  for (int i = 0; i < 60; ++i) {
    const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
    const double d_a = distance(a), d_b = distance(b);
    (d_a < d_b ? hi : lo) = d_a < d_b ? b : a;
    best = std::min({best, d_a, d_b});
  }
  return best;
}

/// Returns the area between an arc and its chord, mm². The area is positive if the arc lies to the
/// right of the chord, which means a counter-clockwise bulge.
inline double bulge_area(const Vec2& from, const Vec2& to, double bulge) {
  if (bulge == 0.0) return 0.0;
  const double half = 2.0 * std::atan(bulge);  // half the sweep angle, with its sign
  const double chord = (to - from).norm();
  const double radius = chord / (2.0 * std::sin(half));
  return 0.5 * radius * radius * (2.0 * half - std::sin(2.0 * half));
}

}  // namespace gearwright::testing
