// Computes areas of the transverse section and the volume of the exact solid without a CAD kernel.
//
//   A    area enclosed by the outline of all teeth, mm²
//   r    bore radius, w keyway width, t keyway depth from the bore circle, mm
//
// The area follows from Green's theorem, A = ½ ∮ (x dy − y dx). The two rays that bound half a
// tooth pass through the axis and contribute nothing, so A is 2|z| times the integral over the half
// outline. A curve provides points, but no derivatives with respect to its parameter. dx/dt and
// dy/dt are therefore taken from the polynomial through the points at 16 Gauss nodes of a panel.
// The panels are halved until the sum converges.
#pragma once

#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/generation/outline.hpp"

namespace gearwright {

/// Returns the area enclosed by the closed outline of |z| teeth. For an internal gear, this is the
/// area of the hole inside the teeth.
///
/// Formula   2|z| Σ_arcs ½ ∫ (x dy − y dx)
/// Units     mm²
/// Domain    teeth ≠ 0, at least one arc (contract)
/// Accuracy  |relative error| < 1e-12 if the curves are smooth between their ends
/// Laws      (1) scaling every point by c scales A by c²   (2) a circle of radius r gives π r²
double section_area(const Outline& outline);

/// Returns the area of the bore with its keyway,
/// π r² + w (r + t) − ((w/2) √(r² − w²/4) + r² asin(w/(2r))).
///
/// Units     mm²
/// Domain    0 ≤ w < 2r, t ≥ 0 (contract)
double bore_area(const Bore& bore);

/// Returns the area of the metal in a transverse section. It is the outline minus the bore or, for
/// an internal gear, the rim minus the outline.
///
/// Units     mm²
/// Domain    an internal gear has a bore, which is its rim (contract)
double metal_area(const ToothedBody& body);

/// Returns the volume of the body with its teeth as cut. For a gear, this is the area of the metal
/// times the face width, minus the volume of the groove of a double-helical gear. If the solid
/// contains several gears, the result includes all gears and the cylinders between them.
///
/// Units     mm³
/// Domain    as for metal_area
double metal_volume(const ToothedBody& body);

}  // namespace gearwright
