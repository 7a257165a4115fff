// Computes the least gaps between the tips of two gears on crossed axes and the mating root
// fillets. If one gear is internal, the gaps to all parts of the mating teeth are computed.
// Internal to pair/.
//
// On crossed axes, every section is different. While the gear of the tip rotates, the edge of a tip
// corner sweeps the whole tip cylinder. Only the points of this cylinder inside the form cylinder
// of the mating gear matter. The edge passes such a point at the rotation ω_A, where the gap is g.
// Both ω_A and g have closed forms:
//
//   A, B   the gear of the tip and its mating gear     θ_c   half angle of the tip corner
//   ψ, z   azimuth and height on the tip cylinder of A     ω_A = ψ − θ_c − 2π z/p_zA
//   g = |ψ_B − 2π z_B/p_zB − κ ω_A| − θ_B(ρ_B),  κ = −z_A/z_B, reduced to one pitch of B    [T4.33]
#pragma once

#include <vector>

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright::detail {

/// Returns the least gap between each tip (corner or rounded) and the mating fillet, as a rotation
/// of gear 2. For internal pairs, the gap between the tip and the whole mating tooth is included if
/// it is less than the gap to the fillet.
///
/// Formula   [T4.33], minimised over the tip cylinder by a grid and quadratic steps
/// Domain    two gears with a tooth (contract); tips above the mating roots
/// Accuracy  every gap is the rotation that brings two points of the surfaces together. A minimum
///           is exact to rounding. If two minima are less than one grid step apart, one of them may
///           be missed. The grid of an external pair has 9 × 9 nodes. The grid of an internal pair
///           has 49 nodes around the circumference and 9 over the face. A rounded tip is evaluated
///           at 17 points.
std::vector<OutlineTouch> crossed_gaps(const CrossedPair& pair);

}  // namespace gearwright::detail
