// The least distance of the tips of two gears on crossed axes from the mating root fillets, and in an
// internal gear from all of its teeth, in relation to the play of the flanks. Internal to pair/.
//
// Teeth are screws here, and all sections differ. The edge of a tip corner sweeps the tip cylinder
// at every rotation. For a place of that cylinder within the mating gear's form cylinder, the
// rotation at which the edge passes it follows in closed form, and from it the gap:
//
//   ψ, z   place on the cylinder of the moving gear A     ω_A = ψ − θ_c − 2π z/p_zA
//   g = |ψ_B − 2π z_B/p_zB − κ ω_A| − θ_B(ρ_B),  κ = −z_A/z_B, reduced to one pitch of B    [T4.33]
#pragma once

#include <vector>

#include "gearwright/pair/mounted_gears.hpp"

namespace gearwright::detail {

/// The least gaps between each tip (corner or rounded) and the mating gear's fillet, as turns of gear
/// 2, and of internal pairs those to the whole tooth if they are less.
///
/// Formula   [T4.33], least over the places of the cylinder, by a grid and quadratic steps
/// Domain    crossed axes, both gears with a tooth, tips above the mating roots (contract: crossed)
/// Accuracy  every gap is that of two points of the surfaces; a minimum is found to rounding, but
///           one of two minima within a ninth of the places (internal pairs: a 49th around, a ninth
///           along the face) may be missed. A rounded tip is evaluated at 17 places along its profile
std::vector<OutlineTouch> crossed_gaps(const MountedGears& pair);

}  // namespace gearwright::detail
