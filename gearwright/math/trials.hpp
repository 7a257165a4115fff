// Counts the evaluations of a minimiser and decides when it ends. Internal to math/.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "gearwright/math/minimise.hpp"

namespace gearwright::detail {

class Trials {
 public:
  explicit Trials(const MinimiserTask& task) : task_(&task) {}

  /// Returns f(x). NaN cannot be compared, so it is replaced by infinity.
  double at(const std::vector<double>& x) {
    ++done_;
    const double f = task_->f(x);
    return std::isnan(f) ? std::numeric_limits<double>::infinity() : f;
  }
  /// True if no further evaluation is allowed.
  bool spent() const { return done_ >= task_->evaluations; }
  /// True if the change of f between two steps is so small that the search ends.
  bool settled(double before, double now) const {
    const double change = std::abs(now - before);
    return change < task_->gain ||
           change < task_->relative_gain * (std::abs(now) + std::abs(before)) * 0.5 ||
           (task_->relative_gain > 0.0 && now == before);
  }

 private:
  const MinimiserTask* task_;
  int done_ = 0;
};

}  // namespace gearwright::detail
