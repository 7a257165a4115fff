// An arc of the outline as a chain of true circular arcs with common tangents: biarcs.
//
//   P_i   points of the chain, mm; about every second one lies on the exact curve
//   T     unit tangents of the exact curve at the ends of one biarc
//   b     bulge of an arc: tan(sweep/4), > 0 counter-clockwise; 0 is a line (the DXF convention)
//
// A biarc joins (P0, T0) and (P1, T1) by two arcs whose tangents meet at J. If both tangents have
// the same length d,
//     J = (P0 + P1)/2 + d (T0 − T1)/2,   |v|² − 2d v·(T0 + T1) − 2d²(1 − T0·T1) = 0,  v = P1 − P0
// (Bolton, Biarc curves, CAD 7 (1975)). On a curve of monotone curvature the error of a biarc grows
// with its length, so the fewest biarcs result if each is as long as the tolerance allows. A
// stretch that is a circular arc is represented by one arc.
#pragma once

#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/contour.hpp"

namespace gearwright {

struct BiarcChain {
  std::vector<Vec2> points;    ///< mm, root side to tip side; the ends are the arc's, bit for bit
  std::vector<double> bulges;  ///< one fewer than points; bulges[i] leads to points[i + 1]
  double deviation_mm;  ///< greatest normal distance of the exact curve, 256 points per biarc
};

/// Chain of arcs within `tolerance_mm` of the exact curve.
///
/// Units     mm
/// Domain    tolerance_mm > 0 (contract); the curve has a tangent at every point
/// Accuracy  deviation_mm ≤ tolerance_mm if 2¹² biarcs suffice, which the caller must check;
///           tangents of neighbouring arcs agree to 1e-9 rad, or to 4e-9 mm over the length of the
///           arc if an arc with less than 1e-9 mm sagitta was replaced by a line
/// Laws      (1) each arc is as long as the tolerance allows: about tolerance^(−1/3) arcs
///           (2) an arc of a circle gives one arc
BiarcChain fit_biarcs(const Arc& arc, double tolerance_mm);

/// Area between an arc and its chord, mm²; > 0 to the right of the chord (a counter-clockwise
/// bulge).
double bulge_area(const Vec2& from, const Vec2& to, double bulge);

/// The closed outline of the whole gear in true circular arcs: one chain of points and bulges.
struct BiarcContour {
  std::vector<Vec2> points;    ///< mm, counter-clockwise
  std::vector<double> bulges;  ///< tan(sweep/4); bulges[i] leads from points[i] to the next, the
                               ///< last one to the first
  double deviation_mm;         ///< greatest normal distance measured from the exact outline
};

/// Each land is one arc. Every other piece is the biarc chain of its arc, fitted once for all
/// teeth.
///
/// Errors    `tolerance_mm` if an arc does not meet it
/// Domain    tolerance_mm > 0 (contract)
Result<BiarcContour> biarc_contour(const Outline& outline, const Contour& contour,
                                   double tolerance_mm);

}  // namespace gearwright
