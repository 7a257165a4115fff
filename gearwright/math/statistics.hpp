// Estimates of the properties of a distribution from samples, with confidence intervals, and
// distribution functions with their inverses.
//
//   n   samples          R   replicates, independent of each other      α   1 − confidence
//   V   variance         S_g, S_Tg   first and total Sobol index of a group g of inputs
//                                    theory: docs/theory/14-scatter.md
//
// Sums are computed in the order of the samples, so a result depends on the samples only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gearwright {

struct Moments {
  double mean;
  double variance;  ///< unbiased estimate, with the divisor n − 1; 0 for n = 1
};

/// Mean and variance of the samples.   Domain  n ≥ 1 (contract)
Moments moments(std::span<const double> samples);

/// The p-quantile of the sorted samples, interpolated linearly between two samples.
///
/// Formula   at the rank 1 + p (n − 1), type 7 of Hyndman and Fan
/// Domain    n ≥ 1, sorted, 0 ≤ p ≤ 1 (contract)
double quantile(std::span<const double> sorted, double p);

/// Two ranks of sorted samples, counted from 1. With a given confidence, the p-quantile of the
/// distribution lies between the samples with these ranks. A rank is absent if there are too few
/// samples for it.
struct RankInterval {
  std::optional<std::int64_t> lower, upper;
};

/// The ranks for n samples. If both ranks exist, the confidence is at least `confidence`.
///
/// Formula   [T14.8]
/// Domain    n ≥ 1, 0 < p < 1, 0 < confidence < 1 (contract)
RankInterval quantile_ranks(std::int64_t n, double p, double confidence);

struct ConfidenceInterval {
  double lower, upper;
};

/// The Clopper-Pearson interval for the probability of an event that occurred in `count` of `of`
/// trials.
///
/// Formula   [T14.7]
/// Domain    0 ≤ count ≤ of, of ≥ 1, 0 < confidence < 1 (contract)
ConfidenceInterval probability_interval(std::int64_t count, std::int64_t of, double confidence);

/// An estimate of a statistic from R replicates.
struct Estimate {
  double value;
  std::optional<double> standard_error;  ///< none if R = 1
};

/// The mean of the values that a statistic has in the replicates, with the standard error.
///
/// Formula   [T14.9]
/// Domain    R ≥ 1 (contract)
Estimate estimate(std::span<const double> replicates);

/// The interval value ± t_{R−1} · standard_error, with R = `replicates`.
///
/// Domain    an estimate with a standard error, R ≥ 2, 0 < confidence < 1 (contract)
ConfidenceInterval interval(const Estimate& estimate, std::size_t replicates, double confidence);

/// A number for each sample, absent for samples in which the number does not exist.
using SampleValues = std::vector<std::optional<double>>;
/// The numbers that exist, in the same order.
std::vector<double> existing(std::span<const std::optional<double>> values);

struct SobolIndices {
  std::vector<double> first, total;  ///< one index for each group
};

/// Estimates the Sobol indices of groups of inputs of a function f. A and B are two independent
/// sets of n points. `a` contains the values of f at the points of A, and `b` the values at the
/// points of B. For each group, `mixed` contains the values of f at the points of A after the
/// inputs of the group are replaced by the inputs of B. The indices of a group are computed
/// from those points at which `a`, `b` and `mixed` have values. None if a group has no such point,
/// or if the variance of the values in `a` and `b` is at most `least_variance`.
///
/// Formula   [T14.10]
/// Domain    n ≥ 1, and all spans have n values (contract)
/// Laws      both indices of a group are exactly 0 if the group has no influence
std::optional<SobolIndices> sobol_indices(const SampleValues& a, const SampleValues& b,
                                          std::span<const SampleValues> mixed,
                                          double least_variance);

// Distribution functions and their inverses, used for confidence intervals and tolerances.
//
//   Φ   normal distribution        I_x(p, q)   regularised incomplete beta function, 0 ≤ x ≤ 1
//   B⁻¹(u; p, q)   inverse of I    t_ν(u)      quantile of Student's distribution
//                                  theory: docs/theory/14-scatter.md
//
// Boost.Math computes these functions in double, because long double is missing on some machines.

/// Φ(x).
///
/// Accuracy  |error| < 1e-15
double normal_cdf(double x);

/// Φ⁻¹(u).
///
/// Domain    0 < u < 1 (contract)
/// Accuracy  |Φ(Φ⁻¹(u)) − u| < 1e-14 u for u ≥ 1e-10
double normal_quantile(double u);

/// I_x(p, q).
///
/// Domain    p > 0, q > 0, 0 ≤ x ≤ 1 (contract)
/// Accuracy  |error| < 1e-14
double beta_cdf(double x, double p, double q);

/// B⁻¹(u; p, q).
///
/// Domain    p > 0, q > 0, 0 ≤ u ≤ 1 (contract)
/// Accuracy  |I_x(p, q) − u| < 1e-11 u, except for the rounding of x if x is near 1
double beta_quantile(double u, double p, double q);

/// t_ν(u).
///
/// Formula   ν/(ν + t²) = B⁻¹(2 min(u, 1 − u); ν/2, ½); [T14.9]
/// Domain    ν > 0, 0 < u < 1 (contract)
/// Accuracy  |relative error| < 1e-11
double student_quantile(double u, double nu);

}  // namespace gearwright
