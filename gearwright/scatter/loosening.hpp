// Computes by how much each tolerance can be loosened, and which tolerance to tighten first.
//
//   P(s)   percentile of the peak to peak TE, if one tolerance is s times as wide as given
//                                    theory: docs/theory/14-scatter.md, [T14.19]
// Internal to scatter/.
#pragma once

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// The effect of each tolerance by itself. A tolerance is made s times as wide by multiplying its
/// coordinates x by s, in the samples of the first replicate.
///
/// Accuracy  Change::factor is at most 1 % below the smallest s for which P(s) exceeds the limit;
///           this s is searched on a grid and refined by halving. With other samples, it changes by
///           the sampling error of the percentile
Loosening loosening_of(const ContactSetup& setup, const ScatterTask& task);

}  // namespace gearwright
