// Functions shared by the fits that replace arcs by simpler curves. Internal to cad/.
//
// Some fits need the distance of a point from a circle. The circle is described by one of its
// points and the normal at this point. The formula must also be valid for lines:
//
//   e    the point, relative to the given point of the circle, mm      κ    curvature, 1/mm
//   N    unit normal at the given point, to the left, so that the centre is at N/κ
//
// |e − N/κ|² = (1 + κq)/κ² with q = κ|e|² − 2e·N, hence
//
//     | |e − N/κ| − 1/|κ| | = |q|/(1 + √(1 + κq))
//
// without a division by κ and without cancellation for large radii.
//
// An interval is covered by steps that are as long as a condition permits. If the condition fails
// for every step that is longer than a failing step, the number of steps is the smallest possible.
// The condition "the error is within the tolerance" has this property if the error grows with the
// length of the step.
#pragma once

#include <algorithm>
#include <cmath>

#include "gearwright/curve/curve.hpp"

namespace gearwright {

/// Returns the distance of e from the circle through the origin with normal N and curvature κ.
///
/// Units     mm
/// Domain    |N| = 1; κ = 0 gives the straight line
/// Accuracy  |error| < 4 ε (|e| + κ|e|²)
inline double circle_distance(const Vec2& e, const Vec2& normal, double kappa) {
  const double q = kappa * e.squaredNorm() - 2.0 * e.dot(normal);
  return std::abs(q) / (1.0 + std::sqrt(std::max(0.0, 1.0 + kappa * q)));
}

/// Returns the normal distance of p from a curve near the curve point w, computed from the
/// osculating circle at w.
///
/// Accuracy  third order in the distance from w along the curve
inline double osculating_distance(const CurvePoint& w, const Vec2& p) {
  const Vec2 normal(-std::sin(w.tangent_angle), std::cos(w.tangent_angle));
  return circle_distance(p - w.point, normal, w.curvature);
}

struct StepLimits {
  double shortest;  ///< in the units of x; a step of this length is always accepted
  double known;     ///< relative to the step; the search ends when its bracket is at most this wide
};

/// Returns the greatest x in (from, to] for which fits(x) is true. The search first checks `to`. If
/// `to` does not fit, the next step has the length `guess`, but at most half of the interval.
///
/// Accuracy  the step from `from` to x is too short by at most limits.known times its length;
///           if no step fits, its length is at most limits.shortest
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
