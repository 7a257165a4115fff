// A quantity that is the greatest of several spreads, each of a group of linear functions.
//
//   q(x) = max_g ( max_i l_i(x) − min_i l_i(x) ),   l_i(x) = b_i + a_i·x,   i in group g
//
// The peak to peak of a curve is such a spread, with a function for each position. A greatest value
// is a spread if the group contains the function 0.
#pragma once

#include <algorithm>
#include <vector>

#include "gearwright/base/numbers.hpp"

namespace gearwright {

class LinearSpreads {
 public:
  void begin_group() { begin_.push_back(value_.size()); }
  /// Adds the function with the value b at x = 0 and the slope a to the last group.
  ///
  /// Domain    after begin_group(); slopes of the same length (contract)
  template <class Slope>
  void add(double value, const Slope& slope) {
    value_.push_back(value);
    slope_.insert(slope_.end(), slope.begin(), slope.end());
  }
  /// Adds the groups of another quantity of the same variables.
  void append(const LinearSpreads& other) {
    for (const std::size_t b : other.begin_) begin_.push_back(value_.size() + b);
    value_.insert(value_.end(), other.value_.begin(), other.value_.end());
    slope_.insert(slope_.end(), other.slope_.begin(), other.slope_.end());
  }
  /// Changes the unit of x: the new unit is `unit` times the present one.
  void scale(double unit) {
    for (double& a : slope_) a *= unit;
  }
  /// q(x); 0 without groups.
  double at(const std::vector<double>& x) const {
    double q = 0.0;
    for (std::size_t g = 0; g < begin_.size(); ++g) {
      double least = kInfinity, greatest = -kInfinity;
      const std::size_t end = g + 1 < begin_.size() ? begin_[g + 1] : value_.size();
      for (std::size_t i = begin_[g]; i < end; ++i) {
        double l = value_[i];
        for (std::size_t k = 0; k < x.size(); ++k) l += slope_[i * x.size() + k] * x[k];
        least = std::min(least, l);
        greatest = std::max(greatest, l);
      }
      q = std::max(q, greatest - least);
    }
    return q;
  }

 private:
  std::vector<std::size_t> begin_;     // index of the first function of each group
  std::vector<double> value_, slope_;  // b_i; a_i, one after the other
};

}  // namespace gearwright
