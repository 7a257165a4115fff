// Requirements of a pair on parallel axes on its housing: face widths, axial force, and the effect
// of a change of the centre distance. Contact ratios and face widths of double-helical gears are those
// of one half.
//
//   ε_α, ε_β   of the clipped path; ε_β = b |tan β_b|/p_bt
//                                              theory: docs/theory/06-few-teeth.md, 6.6
#pragma once

#include <array>
#include <optional>

#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

/// The face width at which the total contact ratio reaches `total`, mm; 0 if ε_α alone suffices,
/// none for a spur pair that needs overlap, and none without contact.
///
/// Formula   b = (total − ε_α) p_bt/|tan β_b|, [T6.14]
std::optional<double> face_width_for_total(const ParallelPair& pair, double total);

/// The least face width with continuous contact of a helical pair whose contact is not continuous
/// in a transverse section; mm, rounded up to 0.01, of double-helical gears with both halves and the
/// gap. None if the transverse contact is continuous,
/// if there is no contact, or if no face width is enough.
std::optional<double> face_width_needed(const ParallelPair& pair);

/// The face width of ε_β = 1, mm; nothing for a spur pair.
std::optional<double> face_width_for_overlap(const ParallelPair& pair);

/// Contact ratios before and after the pitch point, gear 1 driving: approach and recess. The path
/// as clipped.
std::array<double, 2> approach_and_recess(const ParallelPair& pair);

/// Axial force on each gear along +z of the housing, per unit of tangential force on the working
/// pitch cylinder, while gear 1 drives in its sense (clockwise seen from +z).
///
/// Formula   F_z1/F_t = −tan β_w1, F_z2 = −F_z1, [T6.15]
std::array<double, 2> axial_force(const ParallelPair& pair);

/// Growth of the circumferential backlash per mm of centre distance. [T6.16]
double backlash_per_distance(const ParallelPair& pair);

}  // namespace gearwright
