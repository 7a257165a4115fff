#include "gearwright/curve/arc_length.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"

namespace gearwright {
namespace {

constexpr int kDeepest = 10;  // greatest number of halvings, which gives at most 1024 panels

// A series has converged if its last coefficients are below these limits, relative to the size of
// the curve. Rounding causes errors of about 1e-16 in the coefficients of the points.
// Differentiation multiplies these errors by degree² = 256, so the errors in the coefficients of
// the speed are about 3e-14. Each limit is well above the corresponding error.
constexpr double kPointTail = 1e-14;
constexpr double kSpeedTail = 1e-12;
// Newton's method ends when a step in the parameter x of a panel is at most this long. The length
// is a little less than twice the distance from 1 to the next greater double.
constexpr double kLastStep = 4e-16;

}  // namespace

// Clenshaw's recurrence for a series of Chebyshev polynomials.
double ArcLength::value(const Series& series, double x) {
  double b1 = 0.0;
  double b2 = 0.0;
  for (std::size_t k = series.size(); k-- > 1;) {
    const double b = series[k] + 2 * x * b1 - b2;
    b2 = b1;
    b1 = b;
  }
  return series[0] + x * b1 - b2;
}

void ArcLength::add(const Curve& curve, double t_begin, double t_end, double scale, int depth) {
  constexpr std::size_t n = kDegree;
  // The nodes are x_j = cos(π j/n). The panel begins at x_n = −1. The cosines cos(π jk/n) are
  // computed from the fraction jk/(2n) of a turn, so they are exact at multiples of 90°.
  const auto cosine = [](std::size_t j, std::size_t k) {
    return sincos_turn(static_cast<long long>(j * k), 2 * static_cast<long long>(n)).cos;
  };
  const auto series_of = [&](const std::array<double, n + 1>& at_nodes) {
    Series c{};
    for (std::size_t k = 0; k <= n; ++k) {
      double sum = 0.5 * (at_nodes[0] + (k % 2 == 0 ? at_nodes[n] : -at_nodes[n]));
      for (std::size_t j = 1; j < n; ++j) sum += at_nodes[j] * cosine(j, k);
      c[k] = sum * (k == 0 || k == n ? 1.0 : 2.0) / static_cast<double>(n);
    }
    return c;
  };
  const auto derivative_of = [](const Series& c) {
    Series d{};
    for (std::size_t k = n; k >= 1; --k) {
      const double above = k + 1 <= n ? d[k + 1] : 0.0;
      d[k - 1] = above + 2.0 * static_cast<double>(k) * c[k];
    }
    d[0] *= 0.5;
    return d;
  };
  const auto tail = [](const Series& c) {
    return std::max({std::abs(c[n - 2]), std::abs(c[n - 1]), std::abs(c[n])});
  };

  const double middle = t_begin + 0.5 * (t_end - t_begin);
  std::array<double, n + 1> x{};
  std::array<double, n + 1> y{};
  for (std::size_t j = 0; j <= n; ++j) {
    const double t = j == 0   ? t_end
                     : j == n ? t_begin
                              : middle + 0.5 * (t_end - t_begin) * cosine(j, 1);
    const Vec2 w = curve.point(t);
    x[j] = w.x();
    y[j] = w.y();
  }
  const Series c_x = series_of(x);
  const Series c_y = series_of(y);
  const Series d_x = derivative_of(c_x);
  const Series d_y = derivative_of(c_y);
  std::array<double, n + 1> v{};
  for (std::size_t j = 0; j <= n; ++j) {
    v[j] = std::hypot(value(d_x, cosine(j, 1)), value(d_y, cosine(j, 1)));
  }
  const Series speed = series_of(v);

  const double point_tail = std::max(tail(c_x), tail(c_y));
  const double speed_tail = tail(speed);
  if (depth < kDeepest && (point_tail > kPointTail * scale || speed_tail > kSpeedTail * scale)) {
    add(curve, t_begin, middle, scale, depth + 1);
    add(curve, middle, t_end, scale, depth + 1);
    return;
  }

  // ∫ T_k = T_(k+1)/(2(k+1)) − T_(k−1)/(2(k−1)).
  Series travelled{};
  travelled[1] = speed[0] - 0.5 * speed[2];
  for (std::size_t k = 2; k <= n + 1; ++k) {
    const double above = k + 1 <= n ? speed[k + 1] : 0.0;
    travelled[k] = (speed[k - 1] - above) / (2.0 * static_cast<double>(k));
  }
  travelled[0] = -value(travelled, -1.0);
  const double s_end = length_ + std::max(0.0, value(travelled, 1.0));
  panels_.push_back({t_begin, t_end, length_, s_end, speed, travelled});
  length_ = s_end;
  error_estimate_ += speed_tail / static_cast<double>(n);
}

ArcLength::ArcLength(const Curve& curve, double t0, double t1) : t0_(t0), t1_(t1) {
  GW_EXPECTS(t0 != t1);
  // `scale` is the size of the curve. The rounding errors of the points are proportional to it.
  double scale = 0.0;
  for (int i = 0; i <= 4; ++i) {
    scale = std::max(scale, curve.point(t0 + 0.25 * i * (t1 - t0)).norm());
  }
  add(curve, t0, t1, scale, 0);
}

double ArcLength::length_to(double t) const {
  const double direction = t1_ > t0_ ? 1.0 : -1.0;
  if (direction * (t - t0_) <= 0.0) return 0.0;
  if (direction * (t1_ - t) <= 0.0) return length_;
  const auto panel = std::find_if(panels_.begin(), panels_.end() - 1,
                                  [&](const Panel& p) { return direction * (t - p.t_end) <= 0.0; });
  const double x = -1.0 + 2.0 * ((t - panel->t_begin) / (panel->t_end - panel->t_begin));
  return panel->s_begin + value(panel->travelled, x);
}

double ArcLength::parameter(double s) const {
  if (s <= 0.0) return t0_;
  if (s >= length_) return t1_;
  const auto panel =
      std::upper_bound(panels_.begin(), panels_.end() - 1, s,
                       [](double wanted, const Panel& p) { return wanted < p.s_end; });
  const double target = s - panel->s_begin;
  const double extent = panel->s_end - panel->s_begin;
  // Newton's method within a bracket. Every step narrows the bracket, because s increases with x.
  double lo = -1.0;
  double hi = 1.0;
  double x = extent > 0.0 ? -1.0 + 2.0 * (target / extent) : 0.0;
  for (int i = 0; i < 60; ++i) {
    const double excess = value(panel->travelled, x) - target;
    if (excess == 0.0) break;
    (excess > 0.0 ? hi : lo) = x;
    const double slope = value(panel->speed, x);
    double next = slope > 0.0 ? x - excess / slope : 0.5 * (lo + hi);
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    const bool closed = std::abs(next - x) <= kLastStep;
    x = next;
    if (closed) break;
  }
  return panel->t_begin + 0.5 * (x + 1.0) * (panel->t_end - panel->t_begin);
}

}  // namespace gearwright
