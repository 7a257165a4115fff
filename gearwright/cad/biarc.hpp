// Approximates an arc of the outline by a chain of biarcs. A biarc consists of two circular arcs
// with a common tangent.
//
//   P_i   points of the chain, mm; about every second point lies on the exact curve
//   T     unit tangents of the exact curve at the ends of one biarc
//   b     bulge of an arc: tan(sweep/4), > 0 counter-clockwise; 0 is a line (the DXF convention)
//
// A biarc joins (P0, T0) and (P1, T1) by two arcs that meet at J. Its control polygon runs from P0
// along T0, then through J, and then along T1 to P1. If the legs at P0 and at P1 have the same
// length d,
//     J = (P0 + P1)/2 + d (T0 − T1)/2,   |v|² − 2d v·(T0 + T1) − 2d²(1 − T0·T1) = 0,  v = P1 − P0
// (Bolton, Biarc curves, CAD 7 (1975)). On a curve of monotone curvature, the error of a biarc
// grows with its length. The number of biarcs is therefore smallest if each biarc is as long as the
// tolerance permits.
#pragma once

#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/contour.hpp"

namespace gearwright {

struct BiarcChain {
  std::vector<Vec2> points;    ///< mm
  std::vector<double> bulges;  ///< bulges[i] belongs to the arc from points[i] to points[i + 1]; in
                               ///< a closed chain, the last arc ends at points[0]
  double deviation_mm;         ///< greatest normal distance at 256 points per biarc
};

/// Returns a chain of arcs within `tolerance_mm` of the exact curve, from the root side to the tip
/// side, including both ends.
///
/// Units     mm
/// Domain    tolerance_mm > 0 (contract); the curve has a tangent at every point
/// Accuracy  deviation_mm ≤ tolerance_mm if 2¹² biarcs are sufficient, which the caller must check;
///           tangents of neighbouring arcs agree to 1e-9 rad; if a line replaces an arc, the
///           tangent error of the line times its length is below 4e-9 mm
/// Laws      (1) the number of arcs grows as tolerance^(−1/3), because each arc is as long as
///               possible
///           (2) a circular arc is represented by one arc
BiarcChain fit_biarcs(const Arc& arc, double tolerance_mm);

/// Returns the closed outline of the whole gear, counter-clockwise. Each land is one arc. Every other
/// arc of the half outline is fitted by biarcs only once, and all teeth use this fit.
///
/// Errors    `tolerance_mm` if an arc cannot be fitted within this tolerance
/// Domain    tolerance_mm > 0 (contract)
Result<BiarcChain> biarc_contour(const Outline& outline, const Contour& contour,
                                 double tolerance_mm);

}  // namespace gearwright
