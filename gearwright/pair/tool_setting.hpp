// The setting b_F of the rack that cuts the convex teeth of circular-arc gears. The functions
// compute the setting that restores the contact after a change of the centre distance, and the
// effect of a changed setting on the tooth thickness.
//
//   θ   normal angle at the contact       C   centre distance       C0 = r_F + r_P
//   w = (ρ_F − ρ_P) sin θ − (b_F − b_P)   distance of the points of the two racks, mm
//                                         theory: docs/theory/08-contact.md, [T8.20], [T8.21]
#pragma once

#include "gearwright/pair/arc_contact.hpp"

namespace gearwright {

/// The change Δb_F with which the contact has the angle θ at `in.center_distance` + ΔC.
///
/// Formula   exact, a quadratic equation in w; the first order is −ΔC (Litvin and Tsay, Eq. 34)
/// Units     mm
/// Domain    0 < θ < π/2 (contract)
double tool_setting_change(const ArcMeshInput& in, Angle theta, double delta_distance);

/// Increase of the normal thickness of the convex tooth caused by Δb_F, at the height of the point
/// with the angle θ, mm; < 0 if the tooth becomes thinner.
///
/// Formula   2 (√(ρ² − (x + b)²) − ρ cos θ), exact; slope [T8.23]
double thickness_change(const WorkingArc& convex, Angle theta, double delta_b);

}  // namespace gearwright
