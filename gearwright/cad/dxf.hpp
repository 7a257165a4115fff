// Writes the transverse section as a DXF drawing (AutoCAD 2000, AC1015) in millimetres.
//
//   layer PROFILE   the closed outline of all teeth
//   layer BORE      the bore with its keyway, or the rim of an internal gear
//
//   biarcs    PROFILE is one closed LWPOLYLINE of lines and circular arcs; each land is one arc
//   splines   PROFILE has one SPLINE per arc of the outline and one SPLINE per land; on a rack,
//             each land is a LINE; where two pieces meet, their ends are written as equal text
//
// Every number is written as the shortest decimal that a reader converts back to the same double,
// so equal points have equal text. A bore without a keyway is a CIRCLE. A bore with a keyway is a
// closed LWPOLYLINE.
#pragma once

#include "gearwright/cad/drawing.hpp"

namespace gearwright {

/// Returns the text of a DXF file of the section z = 0 of the body.
///
/// Units     mm ($INSUNITS 4)
/// Domain    tolerance_mm > 0; the laws of the outline hold within 1e-6 mm (contract)
/// Errors    a severed tooth; a bore that reaches the root circle; an arc that cannot be fitted
///           within the tolerance
/// Accuracy  deviation_mm ≤ tolerance_mm
/// Laws      (1) the same body and options give the same bytes   (2) the number of segments is
///           proportional to |z|
Result<Drawing> dxf_drawing(const ToothedBody& body, const ContourOptions& options = {});

/// Writes several bodies into one drawing, each at its pose (a turn about z and a shift). A single
/// body is drawn in its own frame.
Result<Drawing> dxf_drawing(const std::vector<ToothedBody>& bodies,
                            const ContourOptions& options = {});

}  // namespace gearwright
