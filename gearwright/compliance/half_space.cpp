#include "gearwright/compliance/half_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/compliance/q9.hpp"

namespace gearwright::detail {

namespace {

constexpr int kGraded = 40;      // nodes on each side of the singularity, denser towards it
constexpr double kTiny = 1e-12;  // modules: least |x| in F, so that asinh is finite

double bump_at(double x, double c) {
  const double q = 1 - x * x / (c * c);
  return q > 0.0 ? 15.0 / (16.0 * c) * q * q : 0.0;
}

// Returns the density of the difference t = x − x′, if the densities of x and x′ are bumps of the
// half widths c and c_other. The integrand is a polynomial, so the quadrature is exact.
double difference_density(double t, double c, double c_other) {
  static const GaussRule rule = gauss_rule(6);
  const double lo = std::max(-c, t - c_other);
  const double hi = std::min(c, t + c_other);
  if (!(hi > lo)) return 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < rule.x.size(); ++i) {
    const double x = 0.5 * (lo + hi) + 0.5 * (hi - lo) * rule.x[i];
    sum += rule.weight[i] * bump_at(x, c) * bump_at(x - t, c_other);
  }
  return 0.5 * (hi - lo) * sum;
}

// Adds nodes between 0 and `to` that become denser towards 0: x = to·u⁴.
template <class Density>
void graded(double to, Density density, Offsets& out) {
  static const GaussRule rule = gauss_rule(kGraded);
  for (int i = 0; i < kGraded; ++i) {
    const double u = 0.5 * (rule.x[i] + 1);
    const double x = to * u * u * u * u;
    const double w = std::abs(to) * 4 * u * u * u * 0.5 * rule.weight[i];
    out.x.push_back(x);
    out.weight.push_back(w * density(x));
  }
}

double second_integral(double x, double z) {
  return z * std::asinh(z / std::max(std::abs(x), kTiny)) - std::hypot(x, z);
}

struct Squared {
  double x, shift, scale;  // R² = x² + (scale·z + shift)²
};

Squared squared(const FlankMetric& m, double offset) {
  const double q = std::sqrt(m.zz);
  return {std::abs(offset) * std::sqrt(1 - m.sz * m.sz / m.zz), m.sz * offset / q, q};
}

}  // namespace

double plane_bump(double c, double poisson_ratio) {
  static const double mean_log = [] {
    const Offsets o = bump_offsets(0.0, 1.0, 1.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < o.x.size(); ++i) sum += o.weight[i] * std::log(std::abs(o.x[i]));
    return sum;
  }();
  return -2 * (1 - poisson_ratio * poisson_ratio) / std::numbers::pi * (std::log(c) + mean_log);
}

double plane_hertz(double a, double poisson_ratio) {
  return -2 * (1 - poisson_ratio * poisson_ratio) / std::numbers::pi * (std::log(0.5 * a) - 0.5);
}

Offsets bump_offsets(double ds, double c, double c_other) {
  Offsets out;
  const double reach = c + c_other;
  const auto density = [&](double x) { return difference_density(x - ds, c, c_other); };
  if (ds - reach < 0.0 && ds + reach > 0.0) {
    graded(ds - reach, density, out);
    graded(ds + reach, density, out);
    return out;
  }
  static const GaussRule rule = gauss_rule(kGraded);
  for (int i = 0; i < kGraded; ++i) {
    const double x = ds + reach * rule.x[i];
    out.x.push_back(x);
    out.weight.push_back(reach * rule.weight[i] * density(x));
  }
  return out;
}

Offsets hertz_offsets(double a) {
  Offsets out;
  const auto density = [a](double x) {
    return 2 / (std::numbers::pi * a) * std::sqrt(std::max(0.0, 1 - x * x / (a * a)));
  };
  graded(a, density, out);
  graded(-a, density, out);
  return out;
}

double slices_inverse(const FlankMetric& metric, double offset, double d, double h) {
  const Squared s = squared(metric, offset);
  const double at = s.scale * d + s.shift;
  const double step = s.scale * h;
  return (second_integral(s.x, at + step) - 2 * second_integral(s.x, at) +
          second_integral(s.x, at - step)) /
         (step * step);
}

double slice_to_point(const FlankMetric& metric, double offset, double z, double z_lo,
                      double z_hi) {
  const Squared s = squared(metric, offset);
  const double x = std::max(s.x, kTiny);
  const double hi = s.scale * (z_hi - z) + s.shift;
  const double lo = s.scale * (z_lo - z) + s.shift;
  return (std::asinh(hi / x) - std::asinh(lo / x)) / (hi - lo);
}

}  // namespace gearwright::detail
