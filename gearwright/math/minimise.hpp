// Minimises a function of several variables within a box, without derivatives.
//
//   whole_box   DIRECT-L divides the box into thirds repeatedly; the parts become smallest where f
//               is least
//   downhill    Subplex moves simplices of two to five variables downhill from a start point
//
// Both methods are deterministic. They evaluate f at the same points in the same order as
// GN_DIRECT_L and LN_SBPLX of NLopt 2.7, so their results agree with those of NLopt in all bits.
//
// Sources   Jones, Perttunen, Stuckman, Lipschitzian optimization without the Lipschitz constant
//           (1993); Gablonsky, Kelley, A locally-biased form of the DIRECT algorithm (2001);
//           Rowan, Functional stability analysis of numerical algorithms (1990); Nelder, Mead, A
//           simplex method for function minimization (1965); Richardson, Kuester, The complex
//           method for constrained optimization (1973), for the limits of the box
#pragma once

#include <functional>
#include <vector>

namespace gearwright {

enum class Minimiser {
  whole_box,  ///< DIRECT-L, a global search that starts in the middle of the box
  downhill    ///< Subplex, a local search from the start point
};

/// A search ends after `evaluations` evaluations, or earlier if the best value of f changes too
/// little in a step. This is the case if the change is less than `gain` or less than the fraction
/// `relative_gain` of the value, or if the change is 0 and `relative_gain` > 0. A search of the
/// whole box makes at least two evaluations.
struct MinimiserTask {
  std::vector<double> lo{}, hi{};  ///< ends of the box
  std::vector<double> step{};      ///< first step of each variable (downhill only), > 0
  int evaluations = 1;
  double relative_gain = 0.0;
  double gain = 0.0;
  std::function<double(const std::vector<double>&)> f{};  ///< finite everywhere in the box
};

/// The best point found from `start`. Exceptions of f reach the caller.
///
/// Domain    lo, hi and step are as long as start, which is not empty; lo ≤ start ≤ hi, lo < hi,
///           evaluations ≥ 1 (contract)
std::vector<double> minimise(Minimiser how, const MinimiserTask& task, std::vector<double> start);

}  // namespace gearwright
