// An arc of the outline as cubic Bézier curves, for SVG.
//
//   L    length of one piece, mm      T    unit tangent of the exact curve
//
// The handles of each piece are L/3 long and lie along the exact tangents at its ends. If the curve
// has unit speed, the cubic then agrees with it to the fourth order in L, and neighbouring pieces
// share their tangent. Each piece is as long as the tolerance allows.
#pragma once

#include <vector>

#include "gearwright/generation/outline.hpp"

namespace gearwright {

struct BezierChain {
  std::vector<Vec2> points;  ///< 3n + 1 points, mm, root to tip; every third point lies on the
                             ///< exact curve
  double deviation_mm;       ///< greatest normal distance at 64 points per piece
};

/// A chain of cubics within `tolerance_mm` of the exact curve.
///
/// Units     mm
/// Domain    tolerance_mm > 0 (contract)
/// Accuracy  deviation_mm ≤ tolerance_mm if 2¹² pieces suffice; the caller must check this
/// Laws      the end points are identical to those of the arc
BezierChain fit_beziers(const Arc& arc, double tolerance_mm);

}  // namespace gearwright
