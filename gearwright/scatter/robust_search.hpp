// Finds the corrections with the lowest percentile of a quantity over a family. The search consists
// of a descent of the mean of the worst samples, a search of the box, a second descent, and a local
// search of the percentile, in this order.
//
//   v     corrections                       f_k   the quantity of sample k, with the corrections v
//   p     the percentile, as a fraction     CVaR  mean of the worst 1 − p of all f_k
//                                    theory: docs/theory/14-scatter.md, [T14.17], [T14.18]
// Internal to scatter/.
#pragma once

#include <vector>

#include "gearwright/contact/compensation.hpp"

namespace gearwright {

/// Evaluates a quantity of the family for given corrections. All corrections are evaluated with one
/// set of samples, so that differences between corrections are not due to chance.
class CorrectedFamily {
 public:
  struct Values {
    std::vector<double> f;                   ///< rad; kLostSpan for a sample without a value
    std::vector<std::vector<double>> slope;  ///< [sample][correction]; empty unless requested
  };
  virtual ~CorrectedFamily() = default;
  virtual Values at(const std::vector<double>& v, bool slopes) const = 0;
  double percentile(const std::vector<double>& v, double p) const;
};

/// Sets the slopes with respect to correction i to difference quotients. This is necessary if the
/// exact slopes with respect to this correction are not known.
void add_difference(CorrectedFamily::Values& values, const CorrectedFamily& family,
                    const std::vector<double>& v, std::size_t i, const Correction& bounds);

struct RobustSearch {
  const CorrectedFamily& coarse;  ///< few samples, for the search of the whole box
  const CorrectedFamily& fine;    ///< for the descents and the comparison
  std::vector<Correction> box;
  double p;        ///< the percentile, as a fraction
  double gain;     ///< rad, smallest gain worth another step
  bool whole_box;  ///< false for a search around the start only
};

/// Returns the best corrections that the search from `start` finds, or `start` if none of them is
/// better. The corrections are not rounded.
///
/// Domain    lo ≤ start ≤ hi of the box (contract)
/// Accuracy  a local minimum, to `gain`
std::vector<double> lowest_percentile(const RobustSearch& search, const std::vector<double>& start);

constexpr double kRobustParts = 100;  ///< rounded corrections are multiples of step/100

}  // namespace gearwright
