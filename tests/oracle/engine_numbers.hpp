// The data of an engine's gear as input for the swept rack, and the finished half tooth as a list
// of points. The oracle and the engine share nothing else.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "gearwright/gear/gear.hpp"
#include "tests/oracle/swept_rack.hpp"

namespace gearwright::oracle {

/// The cutter and the blank of a gear with z > 0. Two results of the engine are used: x_E including
/// the thickness allowance, and the full radius of a named rack.
inline RackNumbers numbers_of(const Gear& gear) {
  const CylindricalSpec& spec = gear.spec;
  const StraightRack& rack = spec.straight_rack();
  RackNumbers n{.teeth = spec.teeth,
                .normal_module = spec.normal_module,
                .normal_pressure_angle = spec.normal_pressure_angle.rad(),
                .helix_angle = spec.helix_angle.rad(),
                .profile_shift = gear.reference().generating_profile_shift,
                .addendum = rack.addendum,
                .dedendum = rack.dedendum,
                .root_fillet_radius = rack.root_fillet_radius,
                .protuberance = rack.protuberance,
                .protuberance_angle = rack.protuberance_angle.rad(),
                .tip_fillet_radius = rack.tip_fillet_radius,
                .tool_addendum = rack.tool_addendum,
                .tip_radius = gear.tip_diameter / 2};
  if (rack.semi_topping_angle) n.semi_topping_angle = rack.semi_topping_angle->rad();
  if (rack.named) {
    n.root_fillet_radius =
        std::min(n.root_fillet_radius, full_radius(rack, spec.normal_pressure_angle));
  }
  return n;
}

/// n points on every arc from the root to the tip. The tip land is omitted if it is a part of the
/// blank.
inline std::vector<Vec2> cut_points(const GeneratedTooth& tooth, int n) {
  std::vector<Vec2> points;
  for (const Arc& arc : tooth.outline.arcs) {
    if (arc.name == ArcName::tip_land && !tooth.tip_cut_by_rack) continue;
    const std::vector<Vec2> more = sample(arc, n);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

/// The point of an arc at this distance (mm, chord) from one of its ends, by bisection.
inline Vec2 point_near_end(const Arc& arc, bool at_begin, double distance) {
  const Vec2 end = at_begin ? arc.begin_point : arc.end_point;
  double near = at_begin ? 0.0 : 1.0, far = at_begin ? 1.0 : 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (near + far);
    ((arc.point(middle) - end).norm() < distance ? near : far) = middle;
  }
  return arc.point(far);
}

/// Between two neighbouring `dense_points`, the tangent turns by at most this angle.
inline constexpr double kMaxTurn = 0.4;  // rad
/// Distance from every joint at which `edged_points` places a point. It is twenty times the nudge
/// of the comparison.
inline constexpr double kBeside = 2e-5;  // mm

namespace numbers_detail {

inline void fill(const Arc& arc, double u, const Vec2& p, double v, const Vec2& q, double longest,
                 int depth, std::vector<Vec2>& points) {
  const double middle = 0.5 * (u + v), length = (q - p).norm();
  const Vec2 between = arc.point(middle);
  const Vec2 a = between - p, b = q - between;
  const double turn = std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
  if (depth == 0 || !(length > longest || (length > 4 * kBeside && turn > kMaxTurn))) return;
  fill(arc, u, p, middle, between, longest, depth - 1, points);
  points.push_back(between);
  fill(arc, middle, between, v, q, longest, depth - 1, points);
}

}  // namespace numbers_detail

/// n points on an arc. More points are added if two are more than `longest` (mm) apart or if the
/// arc turns much between them. If a step remains longer, the arc has a gap.
inline std::vector<Vec2> dense_points(const Arc& arc, int n, double longest) {
  constexpr int kDepth = 30;
  std::vector<Vec2> points{arc.begin_point};
  for (int i = 1; i < n; ++i) {
    const double u = static_cast<double>(i - 1) / (n - 1), v = static_cast<double>(i) / (n - 1);
    const Vec2 p = points.back(), q = arc.point(v);
    numbers_detail::fill(arc, u, p, v, q, longest, kDepth, points);
    points.push_back(q);
  }
  return points;
}

/// Points on an arc, its ends, and a point at 2e-5 mm from each end. At a joint, the chord of the
/// two neighbouring points is then perpendicular to the bisector of the corner, even if the arcs
/// have very different steps.
inline void append_edged(const Arc& arc, const std::vector<Vec2>& all, std::vector<Vec2>& points) {
  points.push_back(all.front());
  // An arc shorter than 3 kBeside has only its end points. A slightly longer arc has no points in
  // between.
  if ((all.back() - all.front()).norm() > 3 * kBeside) {
    points.push_back(point_near_end(arc, true, kBeside));
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
      if ((all[i] - all.front()).norm() > 2 * kBeside && (all[i] - all.back()).norm() > 2 * kBeside)
        points.push_back(all[i]);
    }
    points.push_back(point_near_end(arc, false, kBeside));
  }
  points.push_back(all.back());
}

/// Edged points of the whole half tooth. If `land`, the tip land made by the bottom of the cutter
/// is included; otherwise the points end at the blank.
inline std::vector<Vec2> edged_points(const GeneratedTooth& tooth, int n, bool land,
                                      double longest = std::numeric_limits<double>::infinity()) {
  std::vector<Vec2> points;
  for (const Arc& arc : tooth.outline.arcs) {
    if (arc.name == ArcName::tip_land && !land) continue;
    const bool plain = std::isinf(longest);
    append_edged(arc, plain ? sample(arc, n) : dense_points(arc, n, longest), points);
  }
  return points;
}

}  // namespace gearwright::oracle
