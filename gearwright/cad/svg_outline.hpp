// Writes the transverse section as one SVG path, in millimetres.
//
// The profile is the first subpath, and the bore or rim is the second. The path is filled by the
// even-odd rule, so a gear has a visible bore, and an internal gear has a visible rim. Lands are
// elliptical arc commands (A), which represent true circles. Other arcs are cubic Bézier curves
// (C). The y axis of SVG points downwards, so y is written with the opposite sign. The picture then
// has the orientation of the gear frame. A transformation would have the same effect, but some
// readers ignore transformations.
#pragma once

#include <vector>

#include "gearwright/cad/drawing.hpp"
#include "gearwright/generation/outline.hpp"

namespace gearwright {

struct SvgOptions {
  double tolerance_mm = kSvgTolerance_mm;  ///< permitted normal distance of the Bézier curves
};

/// Returns the text of an SVG file of the section z = 0. Width, height and viewBox are in mm.
///
/// Units     mm, written with ten decimals
/// Domain    tolerance_mm > 0; the laws of the outline hold within 1e-6 mm (contract)
/// Errors    those of dxf_drawing
/// Accuracy  deviation_mm ≤ tolerance_mm
Result<Drawing> svg_drawing(const ToothedBody& body, const SvgOptions& options = {});

/// Writes several bodies into one picture. Each body is one path at its pose (a rotation about z
/// and a shift). A single body is drawn in its own frame.
Result<Drawing> svg_drawing(const std::vector<ToothedBody>& bodies, const SvgOptions& options = {});

// An arc of the outline as cubic Bézier curves, for SVG.
//
//   L    length of one piece, mm      T    unit tangent of the exact curve
//
// The handles of each piece are L/3 long and lie along the exact tangents at its ends. If the curve
// has unit speed, the cubic agrees with the curve to the fourth order in L, and neighbouring pieces
// share their tangent. Each piece is as long as the tolerance permits.

struct BezierChain {
  std::vector<Vec2> points;  ///< 3n + 1 points, mm, root to tip; every third is on the exact curve
  double deviation_mm;       ///< greatest normal distance at 64 points per piece
};

/// Returns a chain of cubics within `tolerance_mm` of the exact curve.
///
/// Units     mm
/// Domain    tolerance_mm > 0 (contract)
/// Accuracy  deviation_mm ≤ tolerance_mm if 2¹² pieces are sufficient, which the caller must check
/// Laws      the end points are identical to the end points of the arc, to the last bit
BezierChain fit_beziers(const Arc& arc, double tolerance_mm);

}  // namespace gearwright
