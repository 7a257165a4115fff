// The numbers of an engine's gear as the swept rack wants them, and the finished half tooth as a
// list of points: all that the oracle and the engine have to share.
#pragma once

#include <algorithm>
#include <vector>

#include "gearwright/gear/gear.hpp"
#include "tests/oracle/swept_rack.hpp"

namespace gearwright::oracle {

/// The cutter and the blank of a gear with z > 0. Shared with the engine are the two decisions that
/// are the engine's to make: x_E of the thickness allowance, and the full radius of a named rack.
inline RackNumbers numbers_of(const Gear& gear) {
  const CylindricalSpec& spec = gear.spec;
  const StraightRack& rack = spec.rack;
  RackNumbers n{.teeth = spec.teeth,
                .normal_module = spec.normal_module,
                .normal_pressure_angle = spec.normal_pressure_angle.rad(),
                .helix_angle = spec.helix_angle.rad(),
                .profile_shift = gear.reference.generating_profile_shift,
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

/// n points of every arc from the root to the tip, the tip land left out where the blank made it.
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

/// The same with a point at 2e-5 mm on either side of every joint, so that there the chord of the
/// two neighbours is square to the bisector of the edge, however unequal the arcs' steps are.
/// `land`: whether the cutter's bottom makes the tip land, or ends where the blank does.
inline std::vector<Vec2> edged_points(const GeneratedTooth& tooth, int n, bool land) {
  constexpr double kBeside = 2e-5;  // twenty nudges of the comparison
  std::vector<Vec2> points;
  for (const Arc& arc : tooth.outline.arcs) {
    if (arc.name == ArcName::tip_land && !land) continue;
    const std::vector<Vec2> all = sample(arc, n);
    points.push_back(all.front());
    // An arc shorter than that has its ends only, one a little longer no points between.
    if ((all.back() - all.front()).norm() > 3 * kBeside) {
      points.push_back(point_near_end(arc, true, kBeside));
      if ((all[1] - all[0]).norm() > 2 * kBeside &&
          (all[n - 1] - all[n - 2]).norm() > 2 * kBeside) {
        points.insert(points.end(), all.begin() + 1, all.end() - 1);
      }
      points.push_back(point_near_end(arc, false, kBeside));
    }
    points.push_back(all.back());
  }
  return points;
}

}  // namespace gearwright::oracle
