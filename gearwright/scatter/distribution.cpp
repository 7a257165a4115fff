#include "gearwright/scatter/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearwright {

namespace {

using Kind = DistributionSpec::Kind;

double density(double x) { return std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi); }

}  // namespace

Result<Distribution> Distribution::of(const DistributionSpec& spec) {
  const auto [l, h] = spec.range;
  if (!std::isfinite(l) || !std::isfinite(h) || !(l <= h))
    return refused(
        "range", h,
        "the upper end of a range must be at least its lower end; give the lower end first");
  if (spec.kind == Kind::normal) {
    if (!(spec.cpk > 0.0) || !std::isfinite(spec.cpk))
      return refused("cpk", spec.cpk,
                     "must be > 0; the standard deviation is the distance between the mean and the "
                     "nearer end of the range, divided by 3 C_pk. The usual C_pk is 1.33. For a "
                     "process of unknown capability, give distribution = \"uniform\"");
    const double half = 0.5 * (h - l);
    if (!(std::abs(spec.offset) < half) && h > l)
      return refused(
          "offset", spec.offset, {-half, half},
          "must lie between {} and {}, the ends excluded, so that the mean stays inside the "
          "range");
  }
  if (spec.kind == Kind::beta) {
    for (const double p : spec.shape)
      if (!(p > 0.0) || !std::isfinite(p))
        return refused("shape", p, "must be > 0; [1, 1] is the uniform distribution");
  }
  return Distribution(spec);
}

Distribution::Distribution(const DistributionSpec& spec) : spec_(spec) {
  if (spec.kind != Kind::normal || !varies()) return;
  const double half = 0.5 * (greatest() - least());
  mean_ = 0.5 * (least() + greatest()) + spec.offset;
  sigma_ = (half - std::abs(spec.offset)) / (3.0 * spec.cpk);
  from_ = normal_cdf((least() - mean_) / sigma_);
  to_ = normal_cdf((greatest() - mean_) / sigma_);
}

double Distribution::at(double u) const {
  GW_EXPECTS(u > 0.0 && u < 1.0);
  const double l = least();
  const double h = greatest();
  if (!varies()) return l;
  double x = l;
  switch (spec_.kind) {
    case Kind::uniform: x = l + (h - l) * u; break;
    case Kind::triangular:
      x = u < 0.5 ? l + (h - l) * std::sqrt(0.5 * u) : h - (h - l) * std::sqrt(0.5 * (1.0 - u));
      break;
    case Kind::normal: {
      const double v = from_ + u * (to_ - from_);
      // If h is many standard deviations above the mean, Φ at h rounds to 1, and v may be 1.
      if (v >= 1.0) return h;
      x = mean_ + sigma_ * normal_quantile(v);
      break;
    }
    case Kind::beta: x = l + (h - l) * beta_quantile(u, spec_.shape[0], spec_.shape[1]); break;
  }
  return std::clamp(x, l, h);
}

Moments Distribution::moments() const {
  const double width = greatest() - least();
  const double middle = 0.5 * (least() + greatest());
  if (!varies()) return {least(), 0.0};
  switch (spec_.kind) {
    case Kind::uniform: return {middle, width * width / 12.0};
    case Kind::triangular: return {middle, width * width / 24.0};
    case Kind::normal: {
      const double a = (least() - mean_) / sigma_;
      const double b = (greatest() - mean_) / sigma_;
      const double share = to_ - from_;
      const double shift = (density(a) - density(b)) / share;
      const double cut = (a * density(a) - b * density(b)) / share;
      return {mean_ + sigma_ * shift, sigma_ * sigma_ * (1.0 + cut - shift * shift)};
    }
    case Kind::beta: break;
  }
  const auto [p, q] = spec_.shape;
  const double sum = p + q;
  return {least() + width * p / sum, width * width * p * q / (sum * sum * (sum + 1.0))};
}

std::array<double, 2> in_disc(double radius, double u, double v) {
  const double r = radius * std::sqrt(u);
  const double turn = 2.0 * std::numbers::pi * v;
  return {r * std::cos(turn), r * std::sin(turn)};
}

}  // namespace gearwright
