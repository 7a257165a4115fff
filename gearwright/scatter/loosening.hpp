// Computes by how much each tolerance can be loosened, and which tolerance to tighten first.
//
//   P(s)   percentile of the peak-to-peak TE if one tolerance is s times as wide as specified
//                                    theory: docs/theory/14-scatter.md, [T14.19]
// Internal to scatter/.
#pragma once

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// Returns the effect of each tolerance if all others stay the same. To make a tolerance s times as
/// wide, its coordinates x are multiplied by s in the samples of the first replicate.
///
/// Accuracy  Change::factor is at most 1 % below the smallest s for which P(s) exceeds the limit.
///           This s is searched on a grid and refined by halving. Because P(s) is computed from
///           samples, s has a sampling error
Loosening loosening_of(const ContactSetup& setup, const ScatterTask& task);

}  // namespace gearwright
