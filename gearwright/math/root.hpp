// One-dimensional roots with a bracket: TOMS 748 (Alefeld, Potra, Shi 1995) by Boost.Math.
//
// A solver returns its final x, the residual, the number of evaluations and the reason for
// stopping. Because of the bracket, it needs no start value and cannot diverge.
#pragma once

#include <functional>

namespace gearwright {

enum class RootStop {
  exact,        ///< f(x) = 0
  bracket,      ///< |b − a| ≤ 2 ulp of the larger end
  no_bracket,   ///< f(lo) and f(hi) have the same sign; nothing was solved, and x is the better end
  evaluations,  ///< the budget was used up, which happens only if f is NaN inside the bracket
};

struct Root {
  double x;
  double residual;
  int evaluations;
  RootStop stop;
  bool found() const { return stop == RootStop::exact || stop == RootStop::bracket; }
};

/// Root of f in [lo, hi].   Domain: lo ≤ hi (contract)
Root find_root(const std::function<double(double)>& f, double lo, double hi);

}  // namespace gearwright
