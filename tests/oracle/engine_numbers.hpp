// The numbers of an engine's gear as the swept rack wants them, and the finished half tooth as a list
// of points: all that the oracle and the engine have to share.
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

}  // namespace gearwright::oracle
