// Writes the transverse section as SVG: one path, in millimetres.
//
// The profile is the first subpath, and the bore or rim is the second. The path is filled by the
// even-odd rule, so that a gear has a visible bore and an internal gear a visible rim. Lands are
// elliptical arc commands (A), which represent true circles. Other arcs are cubic Bézier curves
// (C). The y axis of SVG points downwards, so y is written with the opposite sign. The picture is
// then oriented like the gear frame, without a transformation, which some readers ignore.
#pragma once

#include "gearwright/cad/drawing.hpp"

namespace gearwright {

struct SvgOptions {
  double tolerance_mm = kSvgTolerance_mm;  ///< permitted normal distance of the Bézier curves
};

/// Returns the text of an SVG file of the section z = 0 of the body. Width, height and viewBox are
/// in mm.
///
/// Units     mm, written with ten decimals
/// Domain    tolerance_mm > 0; the laws of the outline hold within 1e-6 mm (contract)
/// Errors    those of dxf_drawing
/// Accuracy  deviation_mm ≤ tolerance_mm
Result<Drawing> svg_drawing(const ToothedBody& body, const SvgOptions& options = {});

/// Writes several bodies into one picture. Each body is one path at its pose (a rotation about z
/// and a shift). A single body is drawn in its own frame.
Result<Drawing> svg_drawing(const std::vector<ToothedBody>& bodies, const SvgOptions& options = {});

}  // namespace gearwright
