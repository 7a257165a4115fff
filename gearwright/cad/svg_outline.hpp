// SVG of the transverse section: one path, in millimetres.
//
// The profile is the first subpath, bore or rim the second, filled by the even-odd rule: a gear
// shows its bore, an internal gear its rim. Lands are elliptical arc commands (A), true circles;
// other arcs cubic Bézier curves (C). SVG's y axis points down, so y is written with the opposite
// sign. The picture is then upright like the gear frame, without a transformation that some readers
// ignore.
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

/// Several bodies in one picture, each at its pose (a turn about z and a shift), a path each; a
/// single body is in its own frame.
Result<Drawing> svg_drawing(const std::vector<ToothedBody>& bodies, const SvgOptions& options = {});

}  // namespace gearwright
