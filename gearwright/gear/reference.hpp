// Computes the reference geometry of a cylindrical involute gear in closed form from its drawing
// values.
//
//   z         teeth, negative if internal     m_n, m_t   normal and transverse module, mm
//   α_n, α_t  pressure angles, rad           β, β_b     helix angles, rad, > 0 right hand
//   d, d_b    reference and base diameter    s_n, s_t, s_bt   tooth thicknesses, mm
//   x, x_E    profile shift and generating profile shift, which includes the allowance E_sn
//                                              theory: docs/theory/02-involute-and-pair.md
//
// The functions are templates over the scalar. The program uses double, and the accuracy ledger
// uses 50 digits.
#pragma once

#include <cmath>
#include <cstdlib>

#include "gearwright/base/numbers.hpp"
#include "gearwright/gear/leaf_formulas.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

template <class T>
struct ReferenceInput {
  int teeth = 0;              ///< z
  T normal_module{};          ///< m_n  mm
  T normal_pressure_angle{};  ///< α_n  rad
  T helix_angle{};            ///< β    rad
  T profile_shift{};          ///< x
  T thickness_allowance{};    ///< E_sn mm
};

template <class T>
struct ReferenceGeometry {
  T transverse_module;                     ///< m_t   mm
  T transverse_pressure_angle;             ///< α_t   rad
  T base_helix_angle;                      ///< β_b   rad, signed
  T reference_diameter;                    ///< d     mm
  T base_diameter;                         ///< d_b   mm
  T generating_profile_shift;              ///< x_E
  T reference_tooth_thickness_normal;      ///< s_n   mm, with the allowance
  T reference_tooth_thickness_transverse;  ///< s_t   mm
  T base_tooth_thickness;   ///< s_bt  mm; extrapolated and possibly < 0 for an internal gear
  T base_pitch_normal;      ///< p_bn  mm
  T base_pitch_transverse;  ///< p_bt  mm
};

/// Returns the reference geometry of a gear.
///
/// Formula   ISO 21771-1, clauses 5 and 6; [T2.5]…[T2.10]
/// Units     mm, rad
/// Domain    z ≠ 0, m_n > 0, 0 < α_n < π/2, |β| < π/2 (contract)
/// Accuracy  ledger rows `reference.*`
template <class T>
ReferenceGeometry<T> reference_geometry(const ReferenceInput<T>& in) {
  using std::asin;
  using std::atan;
  using std::cos;
  using std::sin;
  using std::tan;
  GW_EXPECTS(in.teeth != 0);
  GW_EXPECTS(in.normal_module > T(0));
  const T pi = atan(T(1)) * T(4);
  const int z = std::abs(in.teeth);
  const T cos_beta = cos(in.helix_angle);
  const T tan_alpha_n = tan(in.normal_pressure_angle);

  ReferenceGeometry<T> g;
  g.transverse_module = in.normal_module / cos_beta;
  g.transverse_pressure_angle =
      cos_beta == T(1) ? in.normal_pressure_angle : T(atan(tan_alpha_n / cos_beta));
  g.base_helix_angle = asin(sin(in.helix_angle) * cos(in.normal_pressure_angle));
  g.reference_diameter = g.transverse_module * T(z);
  g.base_diameter = g.reference_diameter * cos(g.transverse_pressure_angle);
  g.generating_profile_shift =
      in.profile_shift + in.thickness_allowance / (T(2) * in.normal_module * tan_alpha_n);
  g.reference_tooth_thickness_normal =
      in.normal_module * (pi / T(2) + T(2) * in.profile_shift * tan_alpha_n) +
      in.thickness_allowance;
  g.reference_tooth_thickness_transverse = g.reference_tooth_thickness_normal / cos_beta;
  const T half_sum = g.reference_tooth_thickness_transverse / g.reference_diameter;
  const T inv_alpha_t = involute(g.transverse_pressure_angle);
  g.base_tooth_thickness = g.base_diameter * T(half_sum + side_of<T>(in.teeth) * inv_alpha_t);
  g.base_pitch_normal = pi * in.normal_module * cos(in.normal_pressure_angle);
  g.base_pitch_transverse = pi * g.base_diameter / T(z);
  return g;
}

/// Returns the transverse tooth thickness (arc) at the diameter d_y, mm. It is negative beyond the
/// diameter at which the flanks meet.
///
/// Formula   s_yt = d_y (s_bt/d_b ∓ inv α_y), with minus for an external gear; [T2.11]
/// Domain    d_y ≥ d_b (contract)
template <class T>
T tooth_thickness_transverse(int teeth, const T& base_diameter, const T& base_tooth_thickness,
                             const T& d_y) {
  GW_EXPECTS(!(d_y < base_diameter));
  const T xi = leaf::curvature(d_y, base_diameter) / base_diameter;
  const T half = base_tooth_thickness / base_diameter;
  return leaf::transverse_thickness(side_of<T>(teeth), half, xi, d_y);
}

/// Returns cos β_y on the cylinder with the diameter d_y, where tan β_y = d_y tan β_b/d_b. [T2.12]
template <class T>
T cos_helix_at(const T& base_diameter, const T& base_helix_angle, const T& d_y) {
  using std::tan;
  return T(1) / leaf::helix_secant(base_diameter, T(tan(base_helix_angle)), d_y);
}

}  // namespace gearwright
