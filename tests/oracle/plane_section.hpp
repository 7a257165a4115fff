// Converts a gear of the engine to the input of tests/oracle/plane_teeth.hpp, in which the outline
// is a list of points.
#pragma once

#include <cmath>

#include "gearwright/gear/gear.hpp"
#include "tests/oracle/plane_teeth.hpp"

namespace gearwright::oracle {

/// In normal modules, `held_diameter` in mm.
inline PlaneGear plane_section(const Gear& gear, double held_diameter, int real_teeth) {
  constexpr int kPoints = 600;
  constexpr double kSamePoint = 1e-9;  // modules
  const double m = gear.spec.normal_module;
  PlaneGear p;
  p.teeth = std::abs(gear.spec.teeth);
  p.ring = gear.internal();
  p.held = held_diameter / 2 / m;
  p.real_teeth = real_teeth;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    if (arc.name == ArcName::tip_land) continue;
    if (arc.name == ArcName::flank && p.root_points == 0) p.root_points = p.outline.size();
    for (const Vec2& v : sample(arc, kPoints)) {
      const std::complex<double> w(v.x() / m, v.y() / m);
      if (p.outline.empty() || std::abs(w - p.outline.back()) > kSamePoint) p.outline.push_back(w);
    }
  }
  return p;
}

}  // namespace gearwright::oracle
