// Finds the worst member of a family in the whole box of tolerances, not only at its corners.
//
// The peak to peak of TE is the greatest minus the least value of a curve. The peak to peak is
// therefore neither convex nor quasi-convex in the errors. If the contact moves from one edge to
// another, a point inside the box may be worse than every corner.
//                                    theory: docs/theory/14-scatter.md, [T14.15]
// Internal to scatter/.
#pragma once

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// Returns the worst member that a search finds. This is the member with the greatest peak to peak
/// or with the least play. The search starts at the worst corners of the box and at the worst
/// samples. It steps along the coordinates and then along the sum of the successful steps. If no
/// step gives an improvement, the steps are halved. Returns none if no member has a value.
///
/// Accuracy  the worst local optimum that is found from several starts, which is not a bound.
///           For the least play, WorstMember::bound is a bound [T14.29]
/// Laws      (1) no sample and no examined corner is worse than the result
std::optional<WorstMember> worst_member(const ContactSetup& setup, const ScatterTask& task,
                                        const std::vector<ScatterSample>& samples,
                                        ScatterQuantity quantity);

}  // namespace gearwright
