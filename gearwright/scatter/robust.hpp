// Corrections for which a percentile of the peak to peak TE over the family is least.
//
//   v     corrections                       f_k   peak to peak TE of sample k, under v
//   p     share of the percentile           CVaR  mean of the worst 1 − p of all f_k
//                                    theory: docs/theory/14-scatter.md, [T14.16] to [T14.18]
//
// The samples are the same for every v, so that differences between corrections are not due to
// chance. The result is assessed with samples of another seed.
#pragma once

#include <vector>

#include "gearwright/contact/corrections.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

struct RobustTask {
  std::vector<WorkshopCorrection> corrections;
  std::vector<Correction> bounds;  ///< of each, lo ≤ 0 ≤ hi, in its unit
  double percent = 95.0;           ///< 100 p
};

struct RobustCorrections {
  std::vector<double> value;  ///< in the units of the corrections
  Scatter before, after;      ///< with the other seed; their only percentile is the one that is
                              ///< minimised

  /// The percentile of the peak to peak, rad.
  static const Percentile& percentile(const Scatter& s) {
    return s.spread[static_cast<std::size_t>(ScatterQuantity::peak_to_peak)]->percentiles[0];
  }
};

/// Domain    as scatter_of(); at least one correction, which the setup can take; bounds as stated;
///           0 < percent < 100; can_minimise() (contract)
/// Errors    as scatter_of(); `percentile`, if contact is lost in every sample
/// Accuracy  a local minimum, the best from a search of the whole box and descents by exact
///           derivatives; values are multiples of a hundredth of `step`
/// Laws      (1) the percentile after is at most that before, with the other seed, and contact is
///           lost no more often; otherwise every value is 0   (2) the same bytes on any number of
///           threads
Result<RobustCorrections> robust_corrections(const ContactSetup& setup, const ScatterTask& task,
                                             const RobustTask& robust);

}  // namespace gearwright
