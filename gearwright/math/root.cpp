#include "gearwright/math/root.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "gearwright/base/contract.hpp"

namespace gearwright {

// TOMS 748 halves its bracket at least every four evaluations: 64 halvings, more than the bits of a
// double, so that only a root at a tiny fraction of the interval can run it out.
constexpr std::uintmax_t kBudget = 256;

Root find_root(const std::function<double(double)>& f, double lo, double hi) {
  GW_EXPECTS(lo <= hi);
  const double f_lo = f(lo);
  if (f_lo == 0.0) return {lo, 0.0, 1, RootStop::exact};
  const double f_hi = f(hi);
  if (f_hi == 0.0) return {hi, 0.0, 2, RootStop::exact};
  if (std::signbit(f_lo) == std::signbit(f_hi)) {
    const bool low = std::abs(f_lo) < std::abs(f_hi);
    return {low ? lo : hi, low ? f_lo : f_hi, 2, RootStop::no_bracket};
  }
  const auto closed = [](double a, double b) {
    return std::abs(b - a) <=
           2 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
  };
  std::uintmax_t budget = kBudget;
  const auto [a, b] = boost::math::tools::toms748_solve(f, lo, hi, f_lo, f_hi, closed, budget);
  const double f_a = f(a);
  const double f_b = f(b);
  const bool low = std::abs(f_a) <= std::abs(f_b);
  const double residual = low ? f_a : f_b;
  const RootStop stop = residual == 0.0 ? RootStop::exact
                        : closed(a, b)  ? RootStop::bracket
                                        : RootStop::evaluations;
  return {low ? a : b, residual, static_cast<int>(budget) + 4, stop};
}

}  // namespace gearwright
