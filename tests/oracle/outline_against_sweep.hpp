// Compares a finished half-tooth outline with the sweep of the cutter, rack or pinion, that cut it.
//
//   outline   points (x, y) from the middle of the space to the tooth's end, side y ≥ 0, without
//             the tip land on the blank (the blank is turned, not cut)
//   n         normal into the material: perpendicular to the chord of the two neighbours,
//             clockwise, or counter-clockwise for an internal gear, whose outline approaches the
//             axis
//
// Two conditions are checked. First, every point must lie on the surface, so |clearance| must be
// small. Second, the surface must be a boundary with material on one side only: a nudge inwards
// must give clearance > 0, and a nudge outwards clearance < 0. If another position of the cutter
// has cut away a loop of a trochoid, the first condition fails on it. A point in the middle of a
// slot violates the second condition.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "tests/oracle/swept_rack.hpp"

namespace gearwright::oracle {

/// The nudge, mm. It is a thousand times the permitted `worst` and a thousandth of machining
/// accuracy.
inline constexpr double kNudge = 1e-6;

struct OutlineAgainstSweep {
  double worst = 0.0;  ///< greatest |clearance|  mm
  std::size_t worst_index = 0;
  double min_inward = std::numeric_limits<double>::infinity();  ///< mm, must be > 0
  std::size_t min_inward_index = 0;
  double max_outward = -std::numeric_limits<double>::infinity();  ///< mm, must be < 0
  std::size_t max_outward_index = 0;
  double longest_step = 0.0;  ///< mm between neighbours; detects a gap in the outline

  /// True if every point is on the surface to `tolerance` mm, with material inside and none
  /// outside.
  bool holds(double tolerance) const {
    return worst <= tolerance && min_inward > 0.0 && max_outward < 0.0;
  }
};

/// The side on which the material lies if the outline is followed from root to tip: the right side,
/// or the left side for an internal gear.
enum class Tooth { external, ring };

namespace outline_detail {

/// From {x, y} or from anything with x() and y().
template <class P>
PlanePoint plane_point(const P& p) {
  if constexpr (requires { p.x(); }) {
    return {p.x(), p.y()};
  } else {
    return {p.x, p.y};
  }
}

inline double distance(PlanePoint a, PlanePoint b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The mirror image of p in the ray through `axis`.
inline PlanePoint mirrored(PlanePoint p, PlanePoint axis) {
  const double along = 2 * (p.x * axis.x + p.y * axis.y) / (axis.x * axis.x + axis.y * axis.y);
  return {along * axis.x - p.x, along * axis.y - p.y};
}

/// Unit normal into the material at point i. Neighbours closer than a nudge (the doubled points at
/// the joints of arcs) do not determine a direction and are skipped. Beyond the middle of the
/// space, and beyond the point of a pointed tooth, the mirror image is used.
inline PlanePoint inward_normal(const std::vector<PlanePoint>& points, std::size_t i, Tooth tooth) {
  std::size_t before = i, after = i;
  while (before > 0 && distance(points[before], points[i]) < kNudge) --before;
  while (after + 1 < points.size() && distance(points[after], points[i]) < kNudge) ++after;
  PlanePoint from = points[before], to = points[after];
  if (distance(to, points[i]) < kNudge && std::abs(points[i].y) < kNudge) to = {from.x, -from.y};
  if (distance(from, points[i]) < kNudge) from = mirrored(to, points.front());
  const double length = tooth == Tooth::ring ? -distance(from, to) : distance(from, to);
  return {(to.y - from.y) / length, -(to.x - from.x) / length};
}

template <class Sweep>
double clearance(const Sweep& sweep, PlanePoint p) {
  if constexpr (requires { sweep.clearance(p); }) {
    return sweep.clearance(p);
  } else {
    return sweep.clearance(Eigen::Vector2d(p.x, p.y));
  }
}

}  // namespace outline_detail

/// Domain    at least two points, more than kNudge apart; `Points` is a range of {x, y} or of types
///           with x() and y(), in mm; `Sweep` has clearance(point), where the point is a PlanePoint
///           or a Vector2d
/// Cost      three clearances per point
template <class Points, class Sweep>
OutlineAgainstSweep outline_against_sweep(const Points& outline, const Sweep& sweep,
                                          Tooth tooth = Tooth::external) {
  using outline_detail::clearance;
  std::vector<PlanePoint> points;
  for (const auto& p : outline) points.push_back(outline_detail::plane_point(p));

  OutlineAgainstSweep result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PlanePoint p = points[i], n = outline_detail::inward_normal(points, i, tooth);
    const double on = std::abs(clearance(sweep, p));
    const double in = clearance(sweep, {p.x + kNudge * n.x, p.y + kNudge * n.y});
    const double out = clearance(sweep, {p.x - kNudge * n.x, p.y - kNudge * n.y});
    // The condition is negated, so that a NaN counts as the worst value.
    if (!(on <= result.worst)) result.worst = on, result.worst_index = i;
    if (!(in >= result.min_inward)) result.min_inward = in, result.min_inward_index = i;
    if (!(out <= result.max_outward)) {
      result.max_outward = out;
      result.max_outward_index = i;
    }
    if (i > 0) {
      result.longest_step =
          std::max(result.longest_step, outline_detail::distance(p, points[i - 1]));
    }
  }
  return result;
}

}  // namespace gearwright::oracle
