// Minimises a function of several variables within a box, without derivatives.
//
// NLopt provides DIRECT-L (Gablonsky and Kelley, 2001), which divides the box, and Subplex (Rowan,
// 1990), which descends from a start point. In a build without NLopt, can_minimise() is false, and
// callers must reject the task instead of calling minimise().
#pragma once

#include <functional>
#include <vector>

namespace gearwright {

enum class Minimiser {
  whole_box,  ///< DIRECT-L, a global search that starts in the middle of the box
  downhill    ///< Subplex, a local search from the start point
};

/// A search ends after `evaluations` evaluations, or earlier when a step changes the best value
/// of f by less than `gain`, or by less than the fraction `relative_gain` of this value.
struct MinimiserTask {
  std::vector<double> lo{}, hi{};  ///< ends of the box
  std::vector<double> step{};      ///< first step of each variable (downhill only), > 0
  int evaluations = 1;
  double relative_gain = 0.0;
  double gain = 0.0;
  std::function<double(const std::vector<double>&)> f{};  ///< finite everywhere in the box
};

bool can_minimise();

/// The best point found from `start`.
///
/// Domain    lo, hi and step are as long as start; lo ≤ start ≤ hi; can_minimise() (contract)
std::vector<double> minimise(Minimiser how, const MinimiserTask& task, std::vector<double> start);

}  // namespace gearwright
