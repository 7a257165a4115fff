// Finds the worst member of a family by a search of the whole box of tolerances, not only of its corners.
//
// Peak to peak TE is the difference of the greatest and the least value of a curve, and therefore
// neither convex nor quasi-convex in the errors. If contact changes between edges, the inside of a
// box may be worse than every corner.
//                                    theory: docs/theory/14-scatter.md, [T14.15]
// Internal to scatter/.
#pragma once

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// The member with the greatest peak to peak, or with the least play. The search starts at the worst
/// corners of the box and the worst samples, and takes steps along the coordinates and along the last
/// gain, which are halved if nothing is gained.
///
/// Accuracy  a local maximum, the worst one found from several starts; not a bound
/// Laws      (1) no sample and no corner that was tried is worse
std::optional<WorstMember> worst_member(const ContactSetup& setup, const ScatterTask& task,
                                        const std::vector<ScatterSample>& samples,
                                        ScatterQuantity quantity);

}  // namespace gearwright
