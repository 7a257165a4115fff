// Distribution functions and their inverses, used for confidence intervals and tolerances.
//
//   Φ   normal distribution        I_x(p, q)   regularised incomplete beta function, 0 ≤ x ≤ 1
//   B⁻¹(u; p, q)   its inverse     t_ν(u)      quantile of Student's distribution
//                                  theory: docs/theory/14-scatter.md
//
// Boost.Math computes them in double, because long double is missing on some machines.
#pragma once

namespace gearwright {

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
