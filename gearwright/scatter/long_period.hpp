// Computes TE of a pair with unequal pitches over its long period, after which every tooth meets
// the same mating tooth again.
//
//   T(φ)    TE of one tooth pair alone, over the whole range in which it touches
//   ε_i,k   angle by which tooth k of gear i is ahead, rad
//                                    theory: docs/theory/14-scatter.md, [T14.22]
// Internal to scatter/.
#pragma once

#include <array>
#include <vector>

#include "gearwright/contact/transmission.hpp"

namespace gearwright {

/// Peak to peak of TE over lcm(z1, |z2|) pitches at the positions of `touches`, rad.
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
