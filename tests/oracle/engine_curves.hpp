// The arcs of the engine's half tooth as plain curves. The oracles measure distances to these
// curves.
#pragma once

#include <vector>

#include "gearwright/generation/outline.hpp"
#include "tests/oracle/toothed_outline.hpp"

namespace gearwright::oracle {

/// Refers to the arcs of `outline`, which must outlive this object.
inline std::vector<ToothedOutline::Curve> curves_of(const Outline& outline) {
  std::vector<ToothedOutline::Curve> curves;
  for (const Arc& arc : outline.arcs)
    curves.push_back([&arc](double u) -> Eigen::Vector2d { return arc.point(u); });
  return curves;
}

}  // namespace gearwright::oracle
