// A gear described by the dimensions of its base cylinder. These dimensions determine the flanks
// independently of the rack.
//
//   z    teeth, negative if internal     r_b    base radius, mm
//   s_bt transverse tooth thickness on the base cylinder, mm; extrapolated for an internal gear
//   β_b  base helix angle, rad, > 0 right hand
//   α_n  pressure angle of a rack       p_bn   normal base pitch, mm
//                                              theory: docs/theory/04-conjugate-action.md
//
// Every rack with m_n cos α_n = p_bn/π can cut the gear. m_n, α_n, β and x depend on the rack that
// is chosen. The functions are templates over the scalar.
#pragma once

#include <cmath>
#include <cstdlib>
#include <optional>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

template <class T>
struct BaseGear {
  int teeth = 0;        ///< z
  T radius{};           ///< r_b   mm
  T tooth_thickness{};  ///< s_bt  mm
  T helix_angle{};      ///< β_b   rad, signed
};

/// Returns +1 for an external gear and −1 for an internal gear.
template <class T>
T side_of(const BaseGear<T>& gear) {
  return side_of<T>(gear.teeth);
}

template <class T>
BaseGear<T> base_gear(int teeth, const ReferenceGeometry<T>& g) {
  return {teeth, g.base_diameter / T(2), g.base_tooth_thickness, g.base_helix_angle};
}

/// Returns p_bn = 2π r_b cos β_b/|z|, mm. [T4.1]
template <class T>
T normal_base_pitch(const BaseGear<T>& gear) {
  using std::atan;
  using std::cos;
  const T pi = atan(T(1)) * T(4);
  return T(2) * pi * gear.radius * cos(gear.helix_angle) / T(std::abs(gear.teeth));
}

/// True if a rack with the pressure angle α_n can cut this gear: cos α_n > |sin β_b|. [T4.2]
template <class T>
bool has_rack(const BaseGear<T>& gear, const T& alpha_n) {
  using std::abs;
  using std::cos;
  using std::sin;
  return cos(alpha_n) > abs(sin(gear.helix_angle));
}

/// Returns the reference data of the gear for a rack with the pressure angle α_n. The profile shift
/// accounts for the whole tooth thickness, so the allowance is 0.
///
/// Formula   m_n = p_bn/(π cos α_n), sin β = sin β_b/cos α_n, x from s_bt; [T4.2], [T4.3]
/// Domain    0 < α_n < π/2, has_rack (contract)
/// Accuracy  ledger rows `as_rack.*`
template <class T>
ReferenceInput<T> as_rack(const BaseGear<T>& gear, const T& alpha_n) {
  using std::asin;
  using std::atan;
  using std::cos;
  using std::sin;
  using std::sqrt;
  using std::tan;
  GW_EXPECTS(has_rack(gear, alpha_n));
  const T pi = atan(T(1)) * T(4);
  const T cos_alpha = cos(alpha_n);
  const T sin_b = sin(gear.helix_angle);
  ReferenceInput<T> rack;
  rack.teeth = gear.teeth;
  rack.normal_module = normal_base_pitch(gear) / (pi * cos_alpha);
  rack.normal_pressure_angle = alpha_n;
  rack.helix_angle = gear.helix_angle == T(0) ? T(0) : T(asin(sin_b / cos_alpha));
  // u = cos α_n cos β, so that r = r_b cos β_b/u and tan α_t = sin α_n/u.
  const T u = sqrt((cos_alpha - sin_b) * (cos_alpha + sin_b));
  const T alpha_t = atan(sin(alpha_n) / u);
  const T r = gear.radius * cos(gear.helix_angle) / u;
  const T s_n = (gear.tooth_thickness / gear.radius - side_of(gear) * T(2) * involute(alpha_t)) *
                r * u / cos_alpha;
  rack.profile_shift = (s_n / rack.normal_module - pi / T(2)) / (T(2) * tan(alpha_n));
  return rack;
}

/// The rack that is to describe a gear. Either number determines the other.
struct WantedRack {
  std::optional<double> normal_module;         ///< m_n  mm
  std::optional<Angle> normal_pressure_angle;  ///< α_n  1° to 60°
};

/// Describes the gear, with its teeth as cut, by another rack.
///
/// Domain    at least one number of the rack (contract)
/// Errors    `normal_module` or `normal_pressure_angle` with its limit if no such rack describes
///           this gear; `rack` with both numbers as its value if they contradict each other, and
///           without a value if the teeth are not involute
Result<ReferenceInput<double>> as_rack(const Gear& gear, const WantedRack& rack);

// The rack that cuts a given root diameter and root form diameter.
//
//   d, d_f, d_Ff          reference, root and root form diameter, mm
//   ρ_C, ρ_F              radii of curvature of the flank at d and at d_Ff, mm
//   h_fP*, ρ_fP*, h_Ff*   dedendum, tip rounding and flank depth of the rack, in modules
//                                              theory: docs/theory/04-conjugate-action.md, 4.2

/// Returns the rack of `spec`, with the dedendum that gives d_f. If d_Ff is given, the tip rounding
/// of the rack is chosen so that the fillet of the gear ends at d_Ff.
///
/// Formula   h_fP* = x_E ± (d − d_f)/(2 m_n), h_Ff* = x_E − (ρ_F − ρ_C) sin α_t/m_n,
///           ρ_fP* = (h_fP* − h_Ff*)/(1 − sin α_n); [T4.4]
/// Errors    `root_diameter`, `root_form_diameter` with the allowed range; for an internal gear
///           `root_form_diameter` is not supported, because a rack does not cut its fillet
Result<StraightRack> rack_leaving_root(const CylindricalSpec& spec, double root_diameter,
                                       std::optional<double> root_form_diameter);

}  // namespace gearwright
