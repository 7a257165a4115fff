// Approximates the least centre distance of two gears, for manual calculation. Some approximations
// are power series in the sum of the shifts. Others replace helical gears by virtual spur gears.
// Other parts of the program solve the involute equation instead (pair/working_angles.hpp).
//
//   α        pressure angle, in the normal section, of the rack that describes both gears, rad
//   β_i, x_i helix angle on the reference cylinder, and shift including the allowance
//   σ        +1 external pair, −1 internal pair
//   z_i′     virtual number of teeth z_i/cos³ β_i, negative if internal
//   w_i      z_i′/(z_1′ + z_2′)
//   L        2 (x_1 + x_2)/((z_1′ + z_2′) tan α), the variable of the series
//   M_2, M_4 Σ w_i tan² β_i, Σ w_i tan⁴ β_i
//   Δ        α_n − α, where α_n is the pressure angle of the common rack at the least distance
//   a_0, Σ_0 centre distance and shaft angle of the gears if both roll with a rack of the angle α
//            and the distance between their pitch planes is X = m_n (x_1 + x_2)
//                                              theory: docs/theory/05-approximations.md
//
// With signed numbers of teeth, the same formulas apply to internal pairs (on parallel axes).
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

/// Two gears with a common rack, and therefore with equal modules and pressure angles. An internal
/// gear is always the second gear.
template <class T>
using ReferencePair = std::array<ReferenceInput<T>, 2>;

/// Virtual number of teeth z/cos³ β. [T5.12]
template <class T>
T virtual_teeth(int teeth, const T& beta) {
  using std::cos;
  const T c = cos(beta);
  return T(teeth) / (c * c * c);
}

/// The approximations for one pair. Angles are in rad, lengths in mm.
template <class T>
struct MinDistanceSeries {
  T alpha;                         ///< α
  T module;                        ///< m_n
  T side;                          ///< σ
  std::array<T, 2> helix;          ///< β_i
  std::array<T, 2> virtual_teeth;  ///< z_i′
  std::array<T, 2> weight;         ///< w_i
  T L, M2, M4;                     ///< L, M_2, M_4
  T rack_center_distance;          ///< a_0
  T rack_shaft_angle;              ///< Σ_0

  /// α_n at the least distance, computed with 1, 2 or 3 terms of the series. The error is O(L²),
  /// O(L³) or O(L⁴). [T5.20]…[T5.22]
  T pressure_angle(int terms) const {
    using std::sin;
    using std::tan;
    GW_EXPECTS(terms >= 1 && terms <= 3);
    const T s2 = sin(alpha) * sin(alpha);
    const T t = tan(alpha);
    T delta = L;
    if (terms >= 2) delta -= (T(1) / s2 + T(3) / T(2) * M2) * t * L * L;
    if (terms >= 3) {
      const T c3 = (T(5) - T(2) * s2) / (T(3) * s2 * s2) + (T(7) - T(2) * s2) / (T(2) * s2) * M2 +
                   T(9) / T(2) * M2 * M2 - T(5) / T(2) * M4;
      delta += c3 * t * t * L * L * L;
    }
    return alpha + delta;
  }

  /// Returns the least distance, a_0 − m_n |z_1′ + z_2′| L²/4. If `factors` is 2, the term with L²
  /// is multiplied by a second factor. The error is O(L³) for one factor and O(L⁴) for two.
  /// [T5.24]…[T5.26]
  T center_distance(int factors) const {
    using std::tan;
    GW_EXPECTS(factors == 1 || factors == 2);
    const T t = tan(alpha);
    T change = -side * module * (virtual_teeth[0] + virtual_teeth[1]) / T(4) * L * L;
    if (factors == 2) change *= T(1) - (T(4) / (T(3) * t) + t * (T(1) + M2)) * L;
    return rack_center_distance + change;
  }

  /// Returns the helix angle of gear 0 or 1 on the pitch cylinder that rolls with a rack of the
  /// angle α + Δ. The result is computed with 1, 2 or 3 terms in Δ. [T5.27]
  T helix_angle(int gear, const T& delta, int terms) const {
    using std::sin;
    using std::tan;
    GW_EXPECTS(terms >= 1 && terms <= 3);
    const T tan_b = tan(helix[static_cast<unsigned>(gear)]);
    const T P = tan_b * tan_b;
    const T s = sin(alpha);
    const T c2 = (T(1) - s) * (T(1) + s);
    const T t = tan(alpha);
    const T K = T(1) + s * s * (T(1) + P);  // 1 + sin² α/cos² β
    T sum = t * delta;
    if (terms >= 2) sum += K / (T(2) * c2) * delta * delta;
    if (terms >= 3) sum += ((T(1) + T(3) * P) * K + T(4)) * t / (T(6) * c2) * delta * delta * delta;
    return helix[static_cast<unsigned>(gear)] + tan_b * sum;
  }

  /// Returns the shaft angle of two gears that roll with a rack of the angle α + Δ, to first order
  /// in Δ. For Δ = L, the result is the shaft angle at the least distance, with an error of O(L²).
  /// [T5.28]
  T shaft_angle(const T& delta) const {
    using std::tan;
    return rack_shaft_angle + tan(alpha) * (tan(helix[0]) + side * tan(helix[1])) * delta;
  }

  /// Returns α_n of the virtual spur pair, in closed form, with an error of O(L²). Returns none if
  /// the virtual pair has no backlash-free position. [T5.29]
  std::optional<T> virtual_pressure_angle() const {
    using std::tan;
    const T t = tan(alpha);
    const T inv = involute(alpha) + t * t * L;
    if (inv < T(0)) return std::nullopt;
    return inverse_involute(inv);
  }

  /// Returns α_n of the virtual spur pair with a correction of second order. The remaining error is
  /// O(L³). [T5.30]
  std::optional<T> corrected_virtual_pressure_angle() const {
    using std::tan;
    const auto plain = virtual_pressure_angle();
    if (!plain) return std::nullopt;
    return T(*plain - T(3) / T(2) * tan(alpha) * M2 * L * L);
  }
};

/// Prepares the approximations for a pair.
///
/// Formula   [T5.18], [T5.19], [T5.23]
/// Domain    common m_n > 0 and 0 < α < π/2, |β| < π/2, z_1 > 0, z_2 ≠ 0; an internal gear has more
///           virtual teeth than its pinion and the same helix angle (contract)
template <class T>
MinDistanceSeries<T> min_distance_series(const ReferencePair<T>& pair) {
  using std::cos;
  using std::tan;
  const auto& [g1, g2] = pair;
  GW_EXPECTS(g1.teeth > 0 && g2.teeth != 0);
  GW_EXPECTS(g1.normal_module > T(0) && g1.normal_module == g2.normal_module);
  GW_EXPECTS(g1.normal_pressure_angle > T(0) &&
             g1.normal_pressure_angle == g2.normal_pressure_angle);
  GW_EXPECTS(g2.teeth > 0 || (g1.helix_angle == g2.helix_angle && -g2.teeth > g1.teeth));
  MinDistanceSeries<T> s;
  s.alpha = g1.normal_pressure_angle;
  s.module = g1.normal_module;
  s.side = side_of<T>(g2.teeth);
  s.helix = {g1.helix_angle, g2.helix_angle};
  const T t = tan(s.alpha);
  T shifts(0);
  for (const auto& g : pair)
    shifts += g.profile_shift + g.thickness_allowance / (T(2) * s.module * t);
  for (unsigned i : {0u, 1u})
    s.virtual_teeth[i] = virtual_teeth(pair[i].teeth, pair[i].helix_angle);
  const T total = s.virtual_teeth[0] + s.virtual_teeth[1];
  s.M2 = s.M4 = T(0);
  for (unsigned i : {0u, 1u}) {
    const T P = tan(s.helix[i]) * tan(s.helix[i]);
    s.weight[i] = s.virtual_teeth[i] / total;
    s.M2 += s.weight[i] * P;
    s.M4 += s.weight[i] * P * P;
  }
  s.L = T(2) * shifts / (total * t);
  // z of an internal gear is negative, so r_2 + σ r_1 is σ times the sum of m_n z/(2 cos β).
  const T radii = T(g1.teeth) / cos(g1.helix_angle) + T(g2.teeth) / cos(g2.helix_angle);
  s.rack_center_distance = s.side * s.module * (radii / T(2) + shifts);
  s.rack_shaft_angle = g1.helix_angle + s.side * g2.helix_angle;
  return s;
}

}  // namespace gearwright
