// Computes in closed form how far the tips of two mounted gears reach. The results are the
// clearance between each tip and the mating root, and the radius down to which each tip touches the
// mating flank. Another result is the tip diameter with which contact stays on the usable flank of
// the mating gear.
//
//   r_a, r_f   tip and root radius        d_Nf/2   radius down to which the mating tip touches
//                                     theory: docs/theory/02-involute-and-pair.md, [T2.23], [T2.25]
#pragma once

#include <array>
#include <optional>

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

/// An overlap of at most this fraction of the base pitch is a rounding error and no interference.
/// It occurs if one gear has cut the other, because their clearance is then 0.
constexpr double kNoCollision = 1e-11;

/// Returns the clearances c on the centre line, mm, first from tip 1 to root 2, then from tip 2 to
/// root 1. `side` is σ of gear 2. [T2.23]
std::array<double, 2> tip_clearances(const std::array<double, 2>& tip_radius,
                                     const std::array<double, 2>& root_radius,
                                     double center_distance, double side);

/// The extended centre distance a_d + σ (x1 + x2) m_n, mm. The tip shortening is σ times the
/// difference between the actual and the extended centre distance. [T2.18], [T2.21]
double extended_center_distance(const Gear& gear_1, const Gear& gear_2);

/// Returns d_Nf/2 of each gear, mm, or none if the mating tip extends beyond the base tangent
/// point. [T2.25]
std::array<std::optional<double>, 2> contact_root_radii(const MeshInput<double>& input,
                                                        const Mesh<double>& mesh);

/// Returns the tip diameter of gear `tip` (1 or 2) that keeps contact on the usable flank of the
/// mating gear. Contact then ends `margin` mm above the radius at which the usable flank starts.
/// Returns none if the present tip is already short enough, if the mating gear has no usable flank
/// or no outline, or if no tip diameter has this effect.
std::optional<double> tip_that_clears(const InvolutePair& pair, int tip, double margin = 0.0);
/// Works like the function above, for two gears that need not be mounted.
std::optional<double> tip_that_clears(const std::array<const Gear*, 2>& gears,
                                      const Mesh<double>& mesh, int tip, double margin);

}  // namespace gearwright
