// An arc of the outline as cubic Bézier curves, for SVG.
//
//   L    length of one piece, mm      T    unit tangent of the exact curve
//
// Each piece has its handles L/3 along the exact tangents at its ends. At unit speed, the cubic
// then agrees with the curve to the fourth order in L, and neighbouring pieces share their tangent.
// Pieces are as long as the tolerance allows.
#pragma once

#include <vector>

#include "gearwright/generation/outline.hpp"

namespace gearwright {

struct BezierChain {
  std::vector<Vec2> points;  ///< 3n + 1 points, mm, root to tip; every third point lies on the
                             ///< exact curve
  double deviation_mm;       ///< greatest normal distance, 64 points per piece
};

/// Chain of cubics within `tolerance_mm` of the exact curve.
///
/// Units     mm
/// Domain    tolerance_mm > 0 (contract)
/// Accuracy  deviation_mm ≤ tolerance_mm if 2¹² pieces suffice, which the caller must check
/// Laws      the end points equal those of the arc, bit for bit
BezierChain fit_beziers(const Arc& arc, double tolerance_mm);

}  // namespace gearwright
