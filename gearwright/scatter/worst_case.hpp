// The worst member of a family: a search of the whole box of tolerances, not of its corners alone.
//
// Peak to peak TE is the greatest of a curve less its least and as such neither convex nor quasi-convex
// in the errors: where edges switch, the inside of a box may be worse than every corner.
//                                    theory: docs/theory/14-scatter.md, [T14.15]
// Internal to scatter/.
#pragma once

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// The greatest peak to peak, or the least play: from the corners of the box and the worst samples, by
/// steps along the coordinates and along the last gain, halved where nothing is gained.
///
/// Accuracy  a local worst, the worst that descents from several starts find; no bound
/// Laws      (1) no sample and no corner that was tried is worse
std::optional<WorstMember> worst_member(const ContactSetup& setup, const ScatterTask& task,
                                        const std::vector<ScatterSample>& samples,
                                        ScatterQuantity quantity);

}  // namespace gearwright
