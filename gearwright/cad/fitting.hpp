// Functions that the fits of arcs by simpler curves share. Internal to cad/.
//
// Distance of a point from a circle that is given by one of its points and the normal there. The formula
// is also valid for lines:
//
//   e    the point, seen from a point of the circle, mm      κ    curvature, 1/mm
//   N    unit normal there, to the left: the centre is N/κ away
//
// |e − N/κ|² = (1 + κq)/κ² with q = κ|e|² − 2e·N, hence
//
//     | |e − N/κ| − 1/|κ| | = |q|/(1 + √(1 + κq))
//
// without a division by κ and without cancellation for large radii.
//
// An interval is covered by steps, each as long as a condition allows. If the condition, once it
// fails, also fails for every longer step (as for an error that grows with the length), the number
// of steps is the smallest possible.
#pragma once

#include <algorithm>
#include <cmath>

#include "gearwright/curve/curve.hpp"

namespace gearwright {

/// Distance of e from the circle through the origin with normal N and curvature κ.
///
/// Units     mm
/// Domain    |N| = 1; κ = 0 is the straight line
/// Accuracy  |error| < 4 ε (|e| + κ|e|²)
inline double circle_distance(const Vec2& e, const Vec2& normal, double kappa) {
  const double q = kappa * e.squaredNorm() - 2.0 * e.dot(normal);
  return std::abs(q) / (1.0 + std::sqrt(std::max(0.0, 1.0 + kappa * q)));
}

/// Normal distance of p from a curve near its point w, computed from the osculating circle at w.
///
/// Accuracy  third order in the distance from w along the curve
inline double osculating_distance(const CurvePoint& w, const Vec2& p) {
  const Vec2 normal(-std::sin(w.tangent_angle), std::cos(w.tangent_angle));
  return circle_distance(p - w.point, normal, w.curvature);
}

struct StepLimits {
  double shortest;  ///< relative to the interval; a step this short is always accepted
  double known;     ///< relative to the step; width of the bracket at which the search ends
};

/// Returns the greatest x in (from, to] for which fits(x) is true. The search starts with a step of
/// the length `guess`.
///
/// Accuracy  within limits.known of the step, on the side that fits; from + shortest if no step
///           fits
/// Domain    from < to, guess > 0
template <class Fits>
double longest_step(double from, double to, double guess, StepLimits limits, const Fits& fits) {
  if (to - from <= limits.shortest || fits(to)) return to;
  double good = from;
  double bad = to;
  double next = std::min(from + guess, 0.5 * (from + to));
  while (true) {
    if (fits(next)) {
      good = next;
      next = std::min(from + 1.5 * (good - from), 0.5 * (good + bad));
    } else {
      bad = next;
      if (good == from && bad - from <= limits.shortest) return bad;
      next = 0.5 * (good + bad);
    }
    if (good > from && bad - good <= limits.known * (good - from)) return good;
  }
}

}  // namespace gearwright
