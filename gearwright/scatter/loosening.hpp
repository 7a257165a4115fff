// How far each tolerance can be loosened, and which one should be tightened first.
//
//   P(s)   percentile of the peak to peak TE, if one tolerance is s times as wide
//                                    theory: docs/theory/14-scatter.md, [T14.19]
// Internal to scatter/.
#pragma once

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// Each tolerance individually: the factor multiplies its x in the samples of the first replicate.
///
/// Accuracy  the factor is 1 % below the first s of a grid, refined by halving, with P(s) over the limit;
///           that of more samples differs by the error of the percentile
Loosening loosening_of(const ContactSetup& setup, const ScatterTask& task);

}  // namespace gearwright
