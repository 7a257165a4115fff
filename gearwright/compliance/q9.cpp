#include "gearwright/compliance/q9.hpp"

#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"

namespace gearwright::detail {

namespace {

constexpr std::array<std::array<int, 2>, 9> kOrder{
    {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}}};

std::array<double, 3> quadratic(double x) {
  return {0.5 * x * (x - 1), 1 - x * x, 0.5 * x * (x + 1)};
}
std::array<double, 3> quadratic_slope(double x) { return {x - 0.5, -2 * x, x + 0.5}; }

}  // namespace

Shape9 shape9(double x, double y) {
  const auto a = quadratic(x);
  const auto b = quadratic(y);
  const auto da = quadratic_slope(x);
  const auto db = quadratic_slope(y);
  Shape9 s;
  for (int k = 0; k < 9; ++k) {
    const auto [i, j] = kOrder[k];
    s.value[k] = a[i] * b[j];
    s.slope(0, k) = da[i] * b[j];
    s.slope(1, k) = a[i] * db[j];
  }
  return s;
}

const std::array<GaussPoint, 9>& gauss9() {
  static const std::array<GaussPoint, 9> points = [] {
    const std::array<double, 3> x{-std::sqrt(0.6), 0.0, std::sqrt(0.6)};
    const std::array<double, 3> w{5.0 / 9, 8.0 / 9, 5.0 / 9};
    std::array<GaussPoint, 9> p{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) p[3 * i + j] = {x[i], x[j], w[i] * w[j]};
    return p;
  }();
  return points;
}

GaussRule gauss_rule(int n) {
  GW_EXPECTS(n >= 1 && n <= 64);
  GaussRule rule{std::vector<double>(n), std::vector<double>(n)};
  for (int i = 0; i < n; ++i) {
    // Newton's method for a root of the Legendre polynomial P_n starts at Tricomi's approximation.
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 1.0;
    for (int turn = 0; turn < 8; ++turn) {
      double before = 1.0;
      double p = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule.x[i] = x;
    rule.weight[i] = 2 / ((1 - x * x) * slope * slope);
  }
  if (n % 2 == 1) rule.x[n / 2] = 0.0;
  return rule;
}

}  // namespace gearwright::detail
