// Finds the corrections that minimise a percentile of the peak-to-peak TE over the family, for
// rigid teeth or under load.
//
//   v     corrections         f_k   peak-to-peak TE of sample k, with the corrections v
//                         theory: docs/theory/14-scatter.md, [T14.16] to [T14.18], [T14.25]
//
// Every v is evaluated with the same samples, so that differences between corrections are not due
// to chance. The result is assessed with other samples, from another seed.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "gearwright/contact/corrections.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

struct RobustTask {
  std::vector<WorkshopCorrection> corrections;
  std::vector<Correction> bounds;  ///< bounds of each correction in its unit, lo ≤ 0 ≤ hi
  double percent = 95.0;           ///< 100 p, the percentile that is minimised
  /// If given, f_k is the loaded peak to peak under the worst of the torques of `load`.
  std::optional<LoadedFamily> load{};
};

/// The family without or with corrections. Its samples have another seed than those of the search.
struct JudgedFamily {
  std::vector<std::vector<double>> x;  ///< points x of the samples, in the users' units
  Spread peak_to_peak;                 ///< spread of f, with the minimised percentile only
  /// Probability that an edge touches or, under load, carries load.
  Probability edge;
  Probability lost;                    ///< probability that a sample has no f
  std::vector<LoadedSpread> loaded{};  ///< results for each torque; empty for rigid teeth

  const Percentile& percentile() const { return peak_to_peak.percentiles[0]; }
};

struct RobustCorrections {
  std::vector<double> value;  ///< values in the units of the corrections
  JudgedFamily before, after;

  /// False if no correction lowers the percentile, so that every value is 0.
  bool any() const {
    return std::any_of(value.begin(), value.end(), [](double v) { return v != 0.0; });
  }
};

/// Computes the corrections, and the family without and with them.
///
/// Domain    as scatter_of(); at least one correction, which the setup can take; bounds as stated;
///           0 < percent < 100 (contract)
/// Errors    as scatter_of(); `scatter.robust` if no sample has a peak to peak
/// Accuracy  a local minimum, which is the best that a search of the whole box and descents with
///           derivatives find; values are multiples of a hundredth of `step`
/// Laws      (1) in the samples from the other seed, the corrections increase neither the
///           percentile nor the number of samples without f. Corrections that increase this number,
///           or that do not lower the percentile by more than kSameError, are replaced by 0
///           (2) the result is the same, byte for byte, for any number of threads
///           (3) with tolerances of width 0, the percentile with the corrections is equal to the
///           value at the optimum of the nominal pair
Result<RobustCorrections> robust_corrections(const ContactSetup& setup, const ScatterTask& task,
                                             const RobustTask& robust);

}  // namespace gearwright
