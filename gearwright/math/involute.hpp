// Involute functions of the transverse profile.    theory: docs/theory/02-involute-and-pair.md
//
//   α    pressure angle at a point, rad        ξ = tan α   roll angle, rad
//   r_b  base radius, mm                       inv α       polar angle of the point, rad
//
// The functions are templates over the scalar, which is double in the engine and a number of 50
// digits in the accuracy ledger. For double, small angles use a series, because tan α − α has a
// relative error of 3ε/α² by cancellation.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace detail {
/// tan α − α by its Maclaurin series.   Accuracy  truncation < 1e-17 relative for |α| ≤ 0.46
double tan_minus_self_series(double alpha);
/// ξ − atan ξ by its Maclaurin series.  Accuracy  truncation < 1e-17 relative for |ξ| ≤ 0.28
double self_minus_atan_series(double xi);
}  // namespace detail

/// Involute function  inv α = tan α − α.
///
/// Formula   ISO 21771-1, "involute function"; [T2.1]
/// Units     α in rad, result in rad
/// Domain    |α| < π/2 (contract)
/// Accuracy  ledger row `involute`
template <class T>
T involute(const T& alpha) {
  using std::abs;
  using std::tan;
  GW_EXPECTS(abs(alpha) < 1.5707963267948966);
  if constexpr (std::is_same_v<T, double>) {
    if (std::abs(alpha) <= 0.46) return detail::tan_minus_self_series(alpha);
  }
  return tan(alpha) - alpha;
}

/// Polar angle of an involute point from its roll angle,  ξ − atan ξ = inv(atan ξ).
///
/// Formula   [T2.2]
/// Units     rad, any sign (odd)
/// Accuracy  ledger row `involute_of_roll`
template <class T>
T involute_of_roll(const T& xi) {
  using std::abs;
  using std::atan;
  if constexpr (std::is_same_v<T, double>) {
    if (std::abs(xi) <= 0.28) return detail::self_minus_atan_series(xi);
  }
  return xi - atan(xi);
}

/// Pressure angle α with inv α = y, by Halley's iteration from a start value within 2.4 % of α.
///
/// Formula   [T2.3]; the iteration is monotone from the second step on
/// Units     rad; odd in y
/// Domain    |y| ≤ 1e12 (contract); for greater |y|, |α| differs from π/2 in the last bits only
/// Accuracy  ledger row `inverse_involute`
template <class T>
T inverse_involute(const T& y) {
  using std::abs;
  using std::atan;
  using std::cbrt;
  using std::tan;
  const T limit(1e12);    // greatest y; π/2 − α is then 1/y
  const T rounding(1e3);  // error of tan α − α near π/2, as a multiple of the tolerance
  GW_EXPECTS(abs(y) <= limit);
  if (y == T(0)) return y;
  if (y < T(0)) return -inverse_involute<T>(-y);
  // For small y, the start value follows from inv α = α³/3 + 2α⁵/15 + …, and for large y, from
  // α → π/2 − 1/(y + π/2).
  T alpha;
  if (y < T(0.6)) {
    const T c = cbrt(T(3) * y);
    alpha = c / (T(1) + c * c * T(2) / T(15));
  } else {
    const T half_pi = atan(T(1)) * T(2);
    const T xi = y + half_pi;
    alpha = atan(xi - T(1) / xi);
  }
  const T tolerance = T(4) * std::numeric_limits<T>::epsilon();
  for (int i = 0; i < 12; ++i) {
    const T t = tan(alpha);
    const T f = involute(alpha) - y;
    const T newton = f / (t * t);
    // f''/(2f') = (1 + t²)/t
    const T step = newton / (T(1) - newton * (T(1) + t * t) / t);
    alpha = alpha - step;
    if (abs(step) <= tolerance * alpha) return alpha;
  }
  GW_ENSURES(abs(involute(alpha) - y) <= rounding * tolerance * (y + alpha));
  return alpha;
}

/// ρ = √(r² − r_b²), the radius of curvature of the involute at the radius r, which is equal to the
/// rolling length r_b ξ. The result is 0 inside the base circle.
///
/// Formula   [T2.2]
/// Units     mm
inline double roll_length(double radius, double base_radius) {
  return std::sqrt(std::max(0.0, (radius - base_radius) * (radius + base_radius)));
}

}  // namespace gearwright
