// Computes unequal pitches within the tolerances of a grade, and TE over the long period of the
// pair, after which every tooth meets the same mating tooth again.
//
//   ε_k   angle by which tooth k is ahead, rad     r   reference radius, mm
//   e, χ  amplitude and phase of the eccentricity  g   random walk along the circumference, mm
//   T(φ)  TE of one tooth pair alone, over the whole range in which it touches
//                                    theory: docs/theory/14-scatter.md, [T14.20], [T14.22]
// Internal to scatter/.
#pragma once

#include <array>
#include <vector>

#include "gearwright/contact/transmission.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

/// Returns the angles ε of all teeth: r ε_k = e sin(2πk/z + χ) + g_k. The walk g returns to its
/// start after one turn. Both e and g are computed from `share`, `phase` and `eccentric`.
///
/// Formula   [T14.20]
/// Domain    share ≥ 0, 0 ≤ eccentric ≤ 1 (contract)
/// Laws      (1) the sum of all ε_k is 0   (2) r ε_k varies by at most share · F_pT, and no step
///           from tooth to tooth exceeds f_ptT; one of the two limits is reached
std::vector<double> uneven_pitch(const Gear& gear, const VaryingPitch& tolerance, double share,
                                 double phase, double eccentric);

/// Returns the peak to peak of TE over lcm(z1, |z2|) pitches at the positions of `touches`, rad.
///
/// Formula   [T14.22]; exact for deviations of gear 2, and to first order for deviations of gear 1
/// Domain    a touch at every position; `pitch` of a gear has a value for each tooth, or is empty
///           (contract)
/// Laws      (1) without deviations, the result is the peak to peak of the touches
///           (2) the result is at most the peak to peak of the touches plus the ranges of both
///           deviations
double long_period_span(Transmission& transmission, const std::vector<PairTouch>& touches,
                        const std::array<int, 2>& teeth,
                        const std::array<std::vector<double>, 2>& pitch);

}  // namespace gearwright
