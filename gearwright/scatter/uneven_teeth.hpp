// Computes unequal pitches within the tolerances of a grade.
//
//   ε_k   angle by which tooth k is ahead, rad     r   reference radius, mm
//   e, χ  amplitude and phase of the eccentricity  g   random walk along the circumference, mm
//                                    theory: docs/theory/14-scatter.md, [T14.20]
// Internal to scatter/.
#pragma once

#include <vector>

#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

/// The angles ε of all teeth: r ε_k = e sin(2πk/z + χ) + g_k. The walk g is closed, which means
/// that it returns to its start after one turn. Both e and g are computed from `share`, `phase` and
/// `eccentric`.
///
/// Formula   [T14.20]
/// Domain    share ≥ 0, 0 ≤ eccentric ≤ 1 (contract)
/// Laws      (1) the sum of all ε_k is 0   (2) r ε_k varies by at most share · F_pT, and no step
///           from tooth to tooth exceeds f_ptT; one of the two limits is reached
std::vector<double> uneven_pitch(const Gear& gear, const VaryingPitch& tolerance, double share,
                                 double phase, double eccentric);

}  // namespace gearwright
