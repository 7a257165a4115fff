// The least gaps between the tips of two gears on crossed axes and the mating root fillets. If one
// gear is an internal gear, the gaps to all parts of its teeth are computed. Internal to pair/.
//
// On crossed axes, every section is different. As the gear of the tip rotates, the edge of a tip
// corner sweeps the whole tip cylinder. Only the points of the tip cylinder inside the form
// cylinder of the mating gear matter. For such a point, closed forms give the rotation ω_A at which
// the edge passes the point, and the gap g there:
//
//   A, B   the gear of the tip and its mating gear     θ_c   half angle of the tip corner
//   ψ, z   azimuth and height on the tip cylinder of A     ω_A = ψ − θ_c − 2π z/p_zA
//   g = |ψ_B − 2π z_B/p_zB − κ ω_A| − θ_B(ρ_B),  κ = −z_A/z_B, reduced to one pitch of B    [T4.33]
#pragma once

#include <vector>

#include "gearwright/pair/mounted_gears.hpp"

namespace gearwright::detail {

/// The least gap between each tip (corner or rounded) and the mating gear's fillet, as a turn of
/// gear 2. For internal pairs, the least gap between the tip and the whole mating tooth is included
/// if it is less than the gap to the fillet.
///
/// Formula   [T4.33], minimised over the tip cylinder by a grid and quadratic steps
/// Domain    crossed axes and two gears with a tooth (contract); tips above the mating roots
/// Accuracy  every gap is the distance between two points of the surfaces. A minimum is exact to
///           rounding, but one of two minima less than one grid step apart may be missed. The grid
///           has 9 × 9 nodes, and for internal pairs 49 nodes around the circumference and 9 over
///           the face. A rounded tip is evaluated at 17 points
std::vector<OutlineTouch> crossed_gaps(const MountedGears& pair);

}  // namespace gearwright::detail
