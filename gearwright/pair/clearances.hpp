// The clearances of two mounted gears in closed form: between tips and roots, and between the
// flanks that are used and the ends of the usable flanks. Also the tip diameter at which contact
// stays on the mating gear's usable flank.
//
//   r_a, r_f   tip and root radius        d_Nf/2   radius down to which the mating tip touches
//                                         theory: docs/theory/02-involute-and-pair.md, [T2.23], [T2.25]
#pragma once

#include <array>
#include <optional>

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

/// A gear meshes without clearance with the gear that has cut it. Rounding errors of such a pair are
/// not interference. The limit is relative to the base pitch.
constexpr double kNoCollision = 1e-11;

/// c on the centre line, mm: tip 1 to root 2, tip 2 to root 1. `side` is the side σ of gear 2.
/// Formula [T2.23]
std::array<double, 2> tip_clearances(const std::array<double, 2>& tip_radius,
                                     const std::array<double, 2>& root_radius,
                                     double center_distance, double side);

/// d_Nf/2 of each gear, mm; none if the mating tip reaches past the base tangent point.   Formula
/// [T2.25]
std::array<std::optional<double>, 2> contact_root_radii(const MeshInput<double>& input,
                                                        const Mesh<double>& mesh);

/// The greatest tip diameter (internal gear: the least) of gear `tip` (1 or 2). With this diameter,
/// contact ends on the mating gear at a radius `margin` mm above the start of its usable flank. If
/// this start is not known, the mating gear's base circle is used. None if the tip need not be
/// turned down, or if the mating gear is an internal gear without a known start of its flank.
std::optional<double> tip_that_clears(const InvolutePair& pair, int tip, double margin = 0.0);

}  // namespace gearwright
