#include "gearwright/math/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

// Boost adds terms in another order if SSE2 is available. Results must not depend on the processor,
// so Boost is compiled as if SSE2 were missing. MinGW also defines the macros of MSVC.
#pragma push_macro("__SSE2__")
#pragma push_macro("_M_AMD64")
#pragma push_macro("_M_X64")
#undef __SSE2__
#undef _M_AMD64
#undef _M_X64
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/erf.hpp>
#pragma pop_macro("__SSE2__")
#pragma pop_macro("_M_AMD64")
#pragma pop_macro("_M_X64")

#include "gearwright/base/contract.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

// Returns P(B ≥ k), where B is binomial with n trials and the probability p.
double at_least(std::int64_t k, std::int64_t n, double p) {
  if (k <= 0) return 1.0;
  if (k > n) return 0.0;
  return beta_cdf(p, static_cast<double>(k), static_cast<double>(n - k + 1));
}

// Combines two estimates of a share between 0 and 1. The first estimate is exact if the share is 0,
// and the second estimate is exact if the share is 1.
double combined(double exact_at_0, double exact_at_1, double weight_of_second) {
  return exact_at_0 + std::clamp(weight_of_second, 0.0, 1.0) * (exact_at_1 - exact_at_0);
}

}  // namespace

Moments moments(std::span<const double> samples) {
  GW_EXPECTS(!samples.empty());
  const auto n = static_cast<double>(samples.size());
  // The first sample is subtracted from each sample, because the sum would otherwise lose
  // digits if the mean is far from 0.
  double sum = 0.0;
  for (const double x : samples) sum += x - samples[0];
  const double mean = samples[0] + sum / n;
  double squares = 0.0;
  for (const double x : samples) squares += (x - mean) * (x - mean);
  return {mean, samples.size() > 1 ? squares / (n - 1.0) : 0.0};
}

double quantile(std::span<const double> sorted, double p) {
  GW_EXPECTS(!sorted.empty() && p >= 0.0 && p <= 1.0);
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[below + 1] - sorted[below]);
}

RankInterval quantile_ranks(std::int64_t n, double p, double confidence) {
  GW_EXPECTS(n >= 1 && p > 0.0 && p < 1.0 && confidence > 0.0 && confidence < 1.0);
  const double half = 0.5 * (1.0 - confidence);
  // P(B ≥ k) decreases as k increases. Bisection finds the greatest l for which P(B ≥ l) ≥ 1 − α/2,
  // and the least u for which P(B ≥ u) ≤ α/2.
  const auto first_at_most = [&](double bound, bool strict) {
    std::int64_t lo = 0, hi = n + 1;  // P(B ≥ 0) = 1, P(B ≥ n + 1) = 0
    while (hi - lo > 1) {
      const std::int64_t k = lo + (hi - lo) / 2;
      const double tail = at_least(k, n, p);
      (strict ? tail < bound : tail <= bound) ? hi = k : lo = k;
    }
    return hi;
  };
  const std::int64_t l = first_at_most(1.0 - half, true) - 1;
  const std::int64_t u = first_at_most(half, false);
  RankInterval ranks;
  if (l >= 1) ranks.lower = l;
  if (u <= n) ranks.upper = u;
  return ranks;
}

ConfidenceInterval probability_interval(std::int64_t count, std::int64_t of, double confidence) {
  GW_EXPECTS(of >= 1 && count >= 0 && count <= of && confidence > 0.0 && confidence < 1.0);
  const double half = 0.5 * (1.0 - confidence);
  const auto k = static_cast<double>(count);
  const auto n = static_cast<double>(of);
  return {count == 0 ? 0.0 : beta_quantile(half, k, n - k + 1.0),
          count == of ? 1.0 : beta_quantile(1.0 - half, k + 1.0, n - k)};
}

Estimate estimate(std::span<const double> replicates) {
  const Moments m = moments(replicates);
  if (replicates.size() < 2) return {m.mean, std::nullopt};
  return {m.mean, std::sqrt(m.variance / static_cast<double>(replicates.size()))};
}

ConfidenceInterval interval(const Estimate& estimate, std::size_t replicates, double confidence) {
  GW_EXPECTS(estimate.standard_error && replicates >= 2 && confidence > 0.0 && confidence < 1.0);
  const double t = student_quantile(0.5 + 0.5 * confidence, static_cast<double>(replicates - 1));
  return {estimate.value - t * *estimate.standard_error,
          estimate.value + t * *estimate.standard_error};
}

std::vector<double> existing(std::span<const std::optional<double>> values) {
  std::vector<double> list;
  for (const std::optional<double>& v : values)
    if (v) list.push_back(*v);
  return list;
}

std::optional<SobolIndices> sobol_indices(const SampleValues& a, const SampleValues& b,
                                          std::span<const SampleValues> mixed,
                                          double least_variance) {
  GW_EXPECTS(!a.empty() && a.size() == b.size());
  std::vector<double> both = existing(a);
  for (const double f : existing(b)) both.push_back(f);
  if (both.empty()) return std::nullopt;
  const auto [mean, variance] = moments(both);
  if (!(variance > least_variance)) return std::nullopt;
  SobolIndices indices;
  for (const SampleValues& m : mixed) {
    GW_EXPECTS(m.size() == a.size());
    // Estimates of S, 1 − S, S_T and 1 − S_T, each multiplied by `rows` and by V.
    double first = 0.0, others = 0.0, total = 0.0, others_alone = 0.0, rows = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (!a[i] || !b[i] || !m[i]) continue;
      const double f_a = *a[i], f_b = *b[i], f_m = *m[i];
      first += (f_b - mean) * (f_m - f_a);
      others += 0.5 * (f_b - f_m) * (f_b - f_m);
      total += 0.5 * (f_a - f_m) * (f_a - f_m);
      others_alone += (f_a - mean) * (f_m - f_b);
      ++rows;
    }
    if (rows == 0.0) return std::nullopt;
    const double scale = 1.0 / (rows * variance);
    const double s = scale * first, s_t = scale * total;
    indices.first.push_back(combined(s, 1.0 - scale * others, s));
    indices.total.push_back(combined(s_t, 1.0 - scale * others_alone, s_t * s_t));
  }
  return indices;
}

double normal_cdf(double x) { return 0.5 * boost::math::erfc(-x / std::numbers::sqrt2); }

double normal_quantile(double u) {
  GW_EXPECTS(u > 0.0 && u < 1.0);
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * u);
}

double beta_cdf(double x, double p, double q) {
  GW_EXPECTS(p > 0.0 && q > 0.0 && x >= 0.0 && x <= 1.0);
  return boost::math::ibeta(p, q, x);
}

double beta_quantile(double u, double p, double q) {
  GW_EXPECTS(p > 0.0 && q > 0.0 && u >= 0.0 && u <= 1.0);
  if (u == 0.0 || u == 1.0) return u;
  // The inverse function of Boost fails for some values of p and q that differ greatly. Newton's
  // iteration within a bracket always converges.
  const auto f = [&](double x) {
    return Slope<double>{beta_cdf(x, p, q) - u, boost::math::ibeta_derivative(p, q, x)};
  };
  return newton_in_bracket(f, 0.0, 1.0, p / (p + q), true).x;
}

double student_quantile(double u, double nu) {
  GW_EXPECTS(nu > 0.0 && u > 0.0 && u < 1.0);
  // Near u = 1/2, c = t²/(ν + t²) is small. Far from 1/2, the complement b = 1 − c is small. The
  // smaller of c and b is computed, because it has more correct digits.
  const double middle = std::abs(2.0 * u - 1.0);
  double t = 0.0;
  if (middle < 0.5) {
    const double c = beta_quantile(middle, 0.5, 0.5 * nu);
    t = std::sqrt(nu * c / (1.0 - c));
  } else {
    const double b = beta_quantile(2.0 * std::min(u, 1.0 - u), 0.5 * nu, 0.5);
    t = std::sqrt(nu * (1.0 - b) / b);
  }
  return u < 0.5 ? -t : t;
}

}  // namespace gearwright
