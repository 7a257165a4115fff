// Computes the centre distance from the profile shifts, or the shifts from the distance.
//
//   Σx = x1 + x2   σ = +1 external, −1 internal   a, a_d   actual and reference centre distance, mm
//   parallel axes: inv α_wt = inv α_t + 2 tan α_n Σx/(z1 + z2)
//                  theory: docs/theory/02-involute-and-pair.md, [T2.15]…[T2.18]
//   crossed axes:  theory: docs/theory/04-conjugate-action.md, [T4.28]
//
// All formulas apply to the nominal teeth. A thickness allowance causes backlash and does not
// change the centre distance.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/pair/leaf_formulas.hpp"

namespace gearwright {

enum class Mounting { tight, extended };

/// Greatest centre distance, relative to the sum of the base radii (to their difference for
/// internal pairs). The working pressure angle is then 89.4°, and no tooth reaches the other gear.
inline constexpr double kMaxDistance = 100.0;

struct ShiftProblem {
  int z1 = 0, z2 = 0;                     ///< internal gear: z2 < 0
  double normal_module = 0.0;             ///< m_n  mm
  Angle normal_pressure_angle{};          ///< α_n
  std::array<Angle, 2> helix_angle{};     ///< β, signed; on parallel axes, only the first angle is
                                          ///< used
  std::optional<Angle> shaft_angle;       ///< Σ    of crossed axes; none for parallel axes
  std::optional<double> x1, x2;           ///< computed if absent
  std::optional<double> center_distance;  ///< a    mm
  Mounting mounting = Mounting::tight;
  double lambda = 0.625;  ///< λ of [T2.18a], used if both shifts are absent (external pairs)
};

struct ShiftSolution {
  double x1, x2;
  double center_distance;  ///< a  mm, as given or as determined by the `mounting`
};

/// Reference centre distance a_d = m_n |z1 + z2| / (2 cos β), mm. [T2.15]
template <class T>
T reference_center_distance(int z1, int z2, const T& normal_module, const T& cos_beta) {
  return normal_module * T(std::abs(z1 + z2)) / (T(2) * cos_beta);
}

/// Returns inv α_wt of the backlash-free mesh of nominal teeth. It is < 0 if there is no such mesh.
/// [T2.16]
template <class T>
T nominal_working_involute(int z1, int z2, const T& alpha_n, const T& alpha_t, const T& sum_x) {
  using std::tan;
  return leaf::working_involute(T(involute(alpha_t)), T(tan(alpha_n)), sum_x, T(z1 + z2));
}

/// Backlash-free centre distance of nominal teeth, mm. [T2.17]
///
/// Domain    nominal_working_involute ≥ 0
template <class T>
T tight_center_distance(int z1, int z2, const T& normal_module, const T& alpha_n, const T& alpha_t,
                        const T& cos_beta, const T& sum_x) {
  using std::cos;
  const T a_d = reference_center_distance(z1, z2, normal_module, cos_beta);
  if (sum_x == T(0)) return a_d;  // exact, without an involute and its inverse
  return a_d * cos(alpha_t) /
         cos(inverse_involute(nominal_working_involute(z1, z2, alpha_n, alpha_t, sum_x)));
}

/// Extended centre distance a_d + σ m_n Σx, mm. [T2.18]
template <class T>
T extended_center_distance(int z1, int z2, const T& normal_module, const T& cos_beta,
                           const T& sum_x) {
  const T a_d = reference_center_distance(z1, z2, normal_module, cos_beta);
  return T(a_d + side_of<T>(z1 + z2) * (normal_module * sum_x));
}

/// Returns the Σx that gives no backlash at the centre distance a, on parallel axes.
///
/// Domain    a ≥ a_d cos α_t (contract)
template <class T>
T tight_shift_sum(int z1, int z2, const T& normal_module, const T& alpha_n, const T& alpha_t,
                  const T& cos_beta, const T& a) {
  using std::atan2;
  using std::cos;
  using std::sqrt;
  using std::tan;
  const T a_d = reference_center_distance(z1, z2, normal_module, cos_beta);
  if (a == a_d) return T(0);
  const T r = a_d * cos(alpha_t);
  GW_EXPECTS(!(a < r));
  const T alpha_wt = atan2(T(sqrt((a - r) * (a + r))), r);
  return (involute(alpha_wt) - involute(alpha_t)) * T(z1 + z2) / (T(2) * tan(alpha_n));
}

/// Returns the Σx that gives no backlash at the centre distance a, on crossed axes.
///
/// Formula   Σx = (2 X sin α_wn − Q_0) π/(2 p_bn tan α_n), where X is the distance of the pitch
///           planes, and Q_0 is the excess Q of pair/common_rack.hpp at Σx = 0; [T4.28]
/// Domain    as angles_at_shaft_angle (contract)
double crossed_shift_sum(const ShiftProblem& problem, double a);

/// Divides a sum of shifts into x1 and x2. In an external pair, the division depends on λ. In an
/// internal pair, the pinion gets the whole sum. [T2.18a]
std::array<double, 2> divided_shift_sum(int z1, int z2, double sum, double lambda = 0.625);
/// Computes the absent values of the problem (docs/spec.md, Shift and centre distance). If the
/// centre distance is absent, an absent shift is 0.
///
/// Domain    on crossed axes without a centre distance, the mounting is `extended` (contract)
/// Errors    on parallel axes only: `pair.center_distance` if there is no working pressure angle at
///           this distance, or if the distance exceeds kMaxDistance times the least possible one;
///           `profile_shift` if the given shifts lead to no centre distance
Result<ShiftSolution> complete_shifts(const ShiftProblem& problem);

}  // namespace gearwright
