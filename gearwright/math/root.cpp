#include "gearwright/math/root.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/math/tools/toms748_solve.hpp>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

// Greatest number of evaluations by TOMS 748, which usually needs about ten. If the limit is
// reached, the remaining bracket is bisected.
constexpr std::uintmax_t kBudget = 100;
// TOMS 748 does not evaluate f within two ulp of the ends of its bracket, so it may cycle until
// kBudget is reached. It is therefore stopped when the width of the bracket is at most this
// fraction of the end with the greater magnitude.
constexpr double kCircles = 16 * std::numeric_limits<double>::epsilon();

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
    // If the root is 0, the relative criterion below is never met. The bracket therefore also
    // counts as closed if its ends are neighbouring doubles.
    if (std::nextafter(a, b) == b) return true;
    return std::abs(b - a) <=
           2 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
  };
  // The ends of the last bracket are among the last points at which f was evaluated. The values at
  // these points are stored here, so that they need not be computed again.
  struct Look {
    double x = kNoNumber;
    double value = 0.0;
  };
  std::array<Look, 4> looks;
  std::size_t next = 0;
  const auto look = [&](double x) {
    const double value = f(x);
    looks[next] = {x, value};
    next = (next + 1) % looks.size();
    return value;
  };
  const auto known = [&](double x) {
    for (const Look& l : looks)
      if (l.x == x) return l.value;
    return x == lo ? f_lo : x == hi ? f_hi : f(x);
  };
  std::uintmax_t budget = kBudget;
  const auto nearly_closed = [&](double a, double b) {
    return closed(a, b) || std::abs(b - a) <= kCircles * std::max(std::abs(a), std::abs(b));
  };
  auto [a, b] = boost::math::tools::toms748_solve(look, lo, hi, f_lo, f_hi, nearly_closed, budget);
  double f_a = known(a);
  double f_b = known(b);
  while (!closed(a, b) && f_a != 0.0 && f_b != 0.0) {
    const double middle = a + (b - a) / 2;
    if (middle == a || middle == b) break;
    const double f_middle = f(middle);
    ++budget;
    if (std::isnan(f_middle)) break;
    const bool low = std::signbit(f_middle) == std::signbit(f_a);
    (low ? a : b) = middle;
    (low ? f_a : f_b) = f_middle;
  }
  const bool low = std::abs(f_a) <= std::abs(f_b);
  const double residual = low ? f_a : f_b;
  const RootStop stop = residual == 0.0 ? RootStop::exact
                        : closed(a, b)  ? RootStop::bracket
                                        : RootStop::evaluations;
  return {low ? a : b, residual, static_cast<int>(budget) + 4, stop};
}

std::vector<double> polynomial_roots(std::span<const double> c, double lo, double hi) {
  GW_EXPECTS(lo <= hi);
  while (!c.empty() && c.back() == 0.0) c = c.first(c.size() - 1);
  if (c.size() <= 1) return {};
  std::vector<double> derivative;
  for (std::size_t i = 1; i < c.size(); ++i) derivative.push_back(static_cast<double>(i) * c[i]);
  std::vector<double> ends = polynomial_roots(derivative, lo, hi);
  ends.insert(ends.begin(), lo);
  ends.push_back(hi);

  std::vector<double> roots;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    double a = ends[i];
    double b = ends[i + 1];
    const double fa = evaluate_polynomial(c, a);
    const double fb = evaluate_polynomial(c, b);
    if (fa == 0.0 || fb == 0.0 || std::signbit(fa) == std::signbit(fb)) continue;
    for (;;) {
      const double middle = a + 0.5 * (b - a);
      if (middle <= a || middle >= b) break;
      const double f = evaluate_polynomial(c, middle);
      if (f == 0.0) {
        a = b = middle;
        break;
      }
      (std::signbit(f) == std::signbit(fa) ? a : b) = middle;
    }
    roots.push_back(a);
  }
  return roots;
}

}  // namespace gearwright
