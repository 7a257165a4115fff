// Approximates the shortest chord by its power series, and by the chord of a virtual spur gear. The
// rest of the program uses the exact chord of chordal_thickness.hpp.
//
//   θ_t, ψ, r   half angle s_t/d, helix angle and radius at the diameter of the chord
//   s_n         normal tooth thickness at this diameter, 2 r θ_t cos ψ, mm
//   u           θ_t cos³ ψ, half angle of the virtual spur gear     T   tan² ψ
//   θ*, k*, Δh* half angle, chord and height of the shortest chord
//                                              theory: docs/theory/05-approximations.md
//
// The variable of the series is θ_t² sin² ψ cos⁴ ψ, which is greatest at ψ = 35° [T5.11]. With
// three corrections, the relative error of the chord at 35° is 1e-9 for θ_t = 0.2 and 3e-7 for 0.4.
// For the threads of a worm, whose helix angle is great, the error is small. The functions are
// templates over the scalar.
#pragma once

#include <cmath>

#include "gearwright/base/contract.hpp"

namespace gearwright {

template <class T>
struct ApproximateChord {
  T half_angle;  ///< θ*   rad
  T chord;       ///< k*   mm
  T height;      ///< Δh*  mm
};

/// Returns θ*, k* and Δh* by their series, each with 0 to 3 corrections after the first term.
///
/// Formula   [T5.8], [T5.9], [T5.10]
/// Units     mm, rad
/// Accuracy  with n corrections, the relative error of each value is O(u^(2n + 2))
/// Domain    θ_t > 0, |ψ| < π/2, 0 ≤ corrections ≤ 3 (contract)
template <class T>
ApproximateChord<T> chord_by_series(const T& theta_t, const T& psi, const T& radius,
                                    int corrections) {
  using std::cos;
  using std::tan;
  GW_EXPECTS(corrections >= 0 && corrections <= 3);
  GW_EXPECTS(theta_t > T(0));
  const T c = cos(psi);
  GW_EXPECTS(c > T(0));
  const T t = tan(psi) * tan(psi);
  const T u = theta_t * c * c * c;
  const T u2 = u * u;
  const T angle[] = {T(1), T(2) * t / T(3), T(2) * t * (T(9) * t - T(1)) / T(15),
                     T(4) * t * (T(225) * t * t - T(54) * t + T(1)) / T(315)};
  const T chord[] = {T(1), T(-1) / T(6), (T(1) - T(24) * t) / T(120),
                     -(T(1) - T(264) * t + T(1800) * t * t) / T(5040)};
  const T height[] = {T(1) / T(2), -(T(1) - T(15) * t) / T(24),
                      (T(1) - T(174) * t + T(945) * t * t) / T(720),
                      -(T(1) - T(1629) * t + T(42435) * t * t - T(135135) * t * t * t) / T(40320)};
  ApproximateChord<T> sum{T(0), T(0), T(0)};
  T power(1);
  for (int i = 0; i <= corrections; ++i) {
    sum.half_angle += angle[i] * power;
    sum.chord += chord[i] * power;
    sum.height += height[i] * power;
    power *= u2;
  }
  const T s_n = T(2) * radius * theta_t * c;
  sum.half_angle *= theta_t * c * c;
  sum.chord *= s_n;
  sum.height *= s_n * u / T(2);
  return sum;
}

/// A virtual spur gear that represents a helical gear. The members describe one tooth.
template <class T>
struct VirtualSpur {
  T half_angle;
  T radius;  ///< mm
  /// Returns the chord of the virtual spur gear, in closed form. [T5.13]
  ApproximateChord<T> chord() const {
    using std::sin;
    const T half_sine = sin(half_angle / T(2));
    return {half_angle, T(2) * radius * sin(half_angle), T(2) * radius * half_sine * half_sine};
  }
};

/// Returns the virtual spur gear with z/cos³ ψ teeth, the half angle u and the radius r/cos² ψ.
/// [T5.12]
template <class T>
VirtualSpur<T> virtual_spur(const T& theta_t, const T& psi, const T& radius) {
  using std::cos;
  const T c = cos(psi);
  return {theta_t * c * c * c, radius / (c * c)};
}

/// Returns the virtual spur gear with z/(cos ψ cos² β_b) teeth. Strength calculations use this
/// gear, but its chord is not a suitable approximation. [T5.14]
template <class T>
VirtualSpur<T> virtual_spur_on_base_helix(const T& theta_t, const T& psi, const T& base_helix,
                                          const T& radius) {
  using std::cos;
  const T b = cos(base_helix);
  return {theta_t * cos(psi) * b * b, radius / (b * b)};
}

/// Returns the error of the chord of virtual_spur, k* − k, to leading order, mm. [T5.15]
template <class T>
T virtual_spur_chord_error(const T& theta_t, const T& psi, const T& radius) {
  using std::cos;
  using std::sin;
  const T c = cos(psi);
  const T s = sin(psi);
  const T u = theta_t * c * c * c;
  // sin² ψ cos¹⁰ ψ θ_t⁴ = sin² ψ/cos² ψ · u⁴
  return -(s * s) / (c * c) * u * u * u * u / T(5) * T(2) * radius * theta_t * c;
}

/// Returns the error of the height of virtual_spur, Δh* − Δh, to leading order, mm. [T5.16]
template <class T>
T virtual_spur_height_error(const T& theta_t, const T& psi, const T& radius) {
  using std::cos;
  using std::tan;
  const T c = cos(psi);
  const T t = tan(psi);
  const T u = theta_t * c * c * c;
  return T(5) / T(16) * t * t * u * u * u * T(2) * radius * theta_t * c;
}

}  // namespace gearwright
