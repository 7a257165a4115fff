// DXF drawings of the transverse section: AutoCAD 2000 (AC1015), millimetres.
//
//   layer PROFILE   the closed outline of all teeth
//   layer BORE      the bore with its keyway; an internal gear's rim
//
//   biarcs    PROFILE is one closed LWPOLYLINE whose bulges are true arcs; lands are one arc each
//   splines   PROFILE is one SPLINE per arc of the outline and one ARC per land; poles at the ends
//             of neighbouring splines are equal text
//
// Numbers are the shortest decimals that read back to the same double, so equal points are equal
// text. A bore without keyway is a CIRCLE, and one with a keyway is a closed LWPOLYLINE.
#pragma once

#include "gearwright/cad/drawing.hpp"

namespace gearwright {

/// The text of a DXF file of the body's section z = 0.
///
/// Units     mm ($INSUNITS 4)
/// Domain    tolerance_mm > 0; the outline's laws hold within 1e-6 mm (contract)
/// Errors    a severed tooth; a bore that leaves the root; an arc that does not meet the tolerance
/// Accuracy  deviation_mm ≤ tolerance_mm
/// Laws      (1) the same body and options give the same bytes   (2) the number of segments is
///           proportional to |z|
Result<Drawing> dxf_drawing(const ToothedBody& body, const ContourOptions& options = {});

/// Writes several bodies into one drawing, each at its pose (a turn about z and a shift). A single
/// body is drawn in its own frame.
Result<Drawing> dxf_drawing(const std::vector<ToothedBody>& bodies,
                            const ContourOptions& options = {});

}  // namespace gearwright
