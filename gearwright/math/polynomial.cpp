#include "gearwright/math/polynomial.hpp"

#include <cmath>

#include "gearwright/base/contract.hpp"

namespace gearwright {

double evaluate_polynomial(std::span<const double> c, double x) {
  double sum = 0.0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * x + c[i];
  return sum;
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
