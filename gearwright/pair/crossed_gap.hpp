// The least gaps between the tips of two gears on crossed axes and the mating root fillets. If one
// gear is an internal gear, the gaps to all parts of its teeth are computed. Internal to pair/.
//
// On crossed axes, every section is different. As its gear rotates, the edge of a tip corner sweeps
// the whole tip cylinder. For a place of the tip cylinder within the mating gear's form cylinder,
// closed forms give the rotation at which the edge passes and the gap:
//
//   ψ, z   place on the tip cylinder of the moving gear A     ω_A = ψ − θ_c − 2π z/p_zA
//   g = |ψ_B − 2π z_B/p_zB − κ ω_A| − θ_B(ρ_B),  κ = −z_A/z_B, reduced to one pitch of B    [T4.33]
#pragma once

#include <vector>

#include "gearwright/pair/mounted_gears.hpp"

namespace gearwright::detail {

/// The least gap between each tip (corner or rounded) and the mating gear's fillet, as a turn of gear
/// 2. For internal pairs, the least gap to the whole tooth is included if it is smaller.
///
/// Formula   [T4.33], minimised over the tip cylinder by a grid and quadratic steps
/// Domain    crossed axes, both gears with a tooth, tips above the mating roots (contract: crossed)
/// Accuracy  every gap is the distance between two points of the surfaces. A minimum is exact to
///           rounding, but one of two minima less than one grid step apart may be missed. The step is
///           1/9 of the range; for internal pairs it is 1/49 of the circumference and 1/9 of the face.
///           A rounded tip is evaluated at 17 places
std::vector<OutlineTouch> crossed_gaps(const MountedGears& pair);

}  // namespace gearwright::detail
