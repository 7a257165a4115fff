// Computes a root of a function of one variable within a bracket, by TOMS 748 (Alefeld, Potra, Shi
// 1995) of Boost.Math or by Newton's iteration. Because of the bracket, these solvers cannot
// diverge. They return x, the residual, the number of evaluations and the reason for stopping.
//
// The file also contains a search for the limit of a condition, and the roots of a polynomial.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "gearwright/base/contract.hpp"

namespace gearwright {

enum class RootStop {
  exact,        ///< f(x) = 0
  bracket,      ///< |b − a| ≤ 2 ulp of the end with the greater magnitude
  no_bracket,   ///< f(lo) and f(hi) have the same sign; x is the end at which |f| is smaller
  evaluations,  ///< f is NaN inside the bracket, so the bracket could not be narrowed further
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

/// Finds the value nearest to `wanted` for which `possible` returns true, by bisection. `possible`
/// must be true at `known` and false at `wanted`, and must change only once between them. 50
/// halvings reduce any range to the rounding error.
template <class Possible>
double nearest_possible(double known, double wanted, const Possible& possible, int halvings = 50) {
  for (int step = 0; step < halvings; ++step) {
    const double middle = (known + wanted) / 2;
    (possible(middle) ? known : wanted) = middle;
  }
  return known;
}

/// Σ c_i x^i.
template <class T>
T evaluate_polynomial(std::span<const std::type_identity_t<T>> c, const T& x) {
  T sum(0);
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * x + c[i];
  return sum;
}

/// The roots in [lo, hi] at which the polynomial Σ c_i x^i changes sign, in ascending order.
///
/// A polynomial is monotone between two neighbouring roots of its derivative, so there is at most
/// one root between them. The roots of the derivative are found by recursion. The interval is not
/// sampled, so close roots are not missed.
///
/// Accuracy  each root is bisected until its bracket is two neighbouring doubles
/// Domain    lo ≤ hi (contract); finite coefficients
std::vector<double> polynomial_roots(std::span<const double> c, double lo, double hi);

// Newton's iteration within a bracket, for smooth functions with a cheap derivative.
//
// Every evaluation narrows the bracket. If a step would leave the bracket, the next point is the
// middle of the bracket instead. From the third evaluation on, this is also the case if a step
// would be at least half as long as the previous step. newton_in_bracket() is a template over the
// scalar, like the functions of involute.hpp.

template <class T>
struct Slope {
  T value;
  T derivative;
};

enum class NewtonStop {
  exact,      ///< f(x) = 0
  step,       ///< the next step is below 2 ulp of x
  bracket,    ///< the width of the bracket is at most 2 ulp of its ends
  iterations  ///< the budget of iterations was used up
};

template <class T>
struct NewtonRoot {
  T x;
  T residual;
  int iterations;
  NewtonStop stop;
  bool found() const { return stop != NewtonStop::iterations; }
};

/// The root of f in [lo, hi]. f(x) returns a Slope<T>. If `rising` is true, f must satisfy
/// f(lo) ≤ 0 ≤ f(hi), and otherwise f(lo) ≥ 0 ≥ f(hi). f may be infinite at lo and hi, and is not
/// evaluated there unless the iteration starts there.
///
/// Domain    lo ≤ start ≤ hi (contract)
template <class T, class F>
NewtonRoot<T> newton_in_bracket(const F& f, T lo, T hi, T start, bool rising) {
  using std::abs;
  GW_EXPECTS(!(start < lo) && !(hi < start));
  constexpr int kBudget = 400;  // more than twice the 170 bisections that numbers of 50 digits need
  const T ulps = T(2) * std::numeric_limits<T>::epsilon();
  NewtonRoot<T> root{start, T(0), 0, NewtonStop::iterations};
  T last = hi - lo;
  while (root.iterations < kBudget) {
    const Slope<T> s = f(root.x);
    ++root.iterations;
    root.residual = s.value;
    if (s.value == T(0)) {
      root.stop = NewtonStop::exact;
      return root;
    }
    ((s.value < T(0)) == rising ? lo : hi) = root.x;
    if (!(hi - lo > ulps * (abs(lo) + abs(hi)) / T(2))) {
      root.stop = NewtonStop::bracket;
      return root;
    }
    const T step = -s.value / s.derivative;
    T next = root.x + step;
    const bool inside = next > lo && next < hi;  // false for NaN
    if (inside && !(abs(step) > ulps * abs(root.x))) {
      root.x = next;
      root.stop = NewtonStop::step;
      return root;
    }
    const bool slow = !(T(2) * abs(step) < last) && root.iterations > 2;
    if (!inside || slow) next = lo + (hi - lo) / T(2);
    last = abs(next - root.x);
    root.x = next;
  }
  return root;
}

}  // namespace gearwright
