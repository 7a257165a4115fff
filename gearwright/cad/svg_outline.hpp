// Writes the transverse section as SVG: one path, in millimetres.
//
// The profile is the first subpath and the bore or rim the second. The path is filled by the
// even-odd rule, so a gear shows its bore and an internal gear its rim. Lands are elliptical arc
// commands (A), which are true circles. Other arcs are cubic Bézier curves (C). The y axis of SVG
// points down, so y is written with the opposite sign. The picture is then upright like the gear
// frame, without a transformation that some readers ignore.
#pragma once

#include "gearwright/cad/drawing.hpp"

namespace gearwright {

struct SvgOptions {
  double tolerance_mm = kSvgTolerance_mm;  ///< normal distance of the Bézier curves
};

/// The text of an SVG file of the body's section z = 0; width, height and viewBox in mm.
///
/// Units     mm, written with ten decimals
/// Domain    tolerance_mm > 0; the outline's laws hold within 1e-6 mm (contract)
/// Errors    as dxf_drawing
/// Accuracy  deviation_mm ≤ tolerance_mm
Result<Drawing> svg_drawing(const ToothedBody& body, const SvgOptions& options = {});

/// Writes several bodies into one picture, each at its pose (a turn about z and a shift) as one
/// path. A single body is drawn in its own frame.
Result<Drawing> svg_drawing(const std::vector<ToothedBody>& bodies, const SvgOptions& options = {});

}  // namespace gearwright
