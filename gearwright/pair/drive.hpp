// The ends of contact of a pair and, for parallel axes, the required face widths, the axial force
// and the effect of a change of the centre distance. For double-helical gears, contact ratios and
// face widths refer to one half.
//
//   ε_α   transverse contact ratio of the clipped path     ε_β   overlap ratio, b |tan β_b|/p_bt
//                                              theory: docs/theory/06-few-teeth.md, 6.6
#pragma once

#include <array>
#include <optional>

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

/// Returns the face width at which the total contact ratio is `total`, mm. Returns 0 if ε_α alone
/// is sufficient. Returns none if there is no contact, or if ε_α of a spur pair is not sufficient.
///
/// Formula   b = (total − ε_α) p_bt/|tan β_b|, [T6.14]
std::optional<double> face_width_for_total(const ParallelPair& pair, double total);

/// Returns the least face width with continuous contact, mm, rounded up to 0.01, for a helical pair
/// with ε_α < 1. For double-helical gears, the width includes both halves and the gap. Returns none
/// if ε_α ≥ 1, if there is no contact, or if no face width is sufficient.
std::optional<double> face_width_needed(const ParallelPair& pair);

/// Returns the face width at which ε_β = 1, mm, or none for a spur pair.
std::optional<double> face_width_for_overlap(const ParallelPair& pair);

/// Returns ρ_1 at the start and the end of contact, mm. These points are usually A and E. If
/// undercut has removed a part of a flank, contact on this flank ends at the end of the clipped
/// path. If no part of the path remains, the function returns A and E.
std::array<double, 2> contact_ends(const InvolutePair& pair);

/// The parts of the transverse contact ratio before the pitch point (approach) and after it
/// (recess), on the clipped path. Gear 1 drives.
std::array<double, 2> approach_and_recess(const ParallelPair& pair);

/// Returns the axial force on each gear along +z of the housing, divided by the tangential force on
/// the working pitch cylinder. Gear 1 drives clockwise, seen from +z.
///
/// Formula   F_z1/F_t = −tan β_w1, F_z2 = −F_z1, [T6.15]
std::array<double, 2> axial_force(const ParallelPair& pair);

/// Returns 2 tan α_wt, the change of the circumferential backlash per mm of centre distance. If the
/// centre distance of an internal pair increases, the backlash decreases by this amount. [T6.16]
double backlash_per_distance(const ParallelPair& pair);

}  // namespace gearwright
