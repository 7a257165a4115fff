// The imaginary rack between two involute gears. Its plane flank touches both gears.
//
//   z, r_b, s_bt, β_b   of each gear alone (gear/basic.hpp)     S = sin β_b
//   α_n  pressure angle of the rack, the free parameter     u_i = cos α_n cos β_i
//   β_i, α_ti, r_i, t_ni   helix angle, transverse pressure angle, radius, normal tooth thickness
//        of gear i on the pitch cylinder that rolls with the rack
//   τ_i  +1, −1 if internal       σ   +1 external pair, −1 internal
//   X    distance of the two pitch planes, mm, X = σ (a − r_2 − σ r_1)
//                                              theory: docs/theory/04-conjugate-action.md
//
// Spur, helical and crossed pairs differ only in the α_n of this rack (pair/working_angles.hpp).
#pragma once

#include <array>
#include <cmath>

#include "gearwright/gear/basic.hpp"

namespace gearwright {

template <class T>
using BasePair = std::array<BaseGear<T>, 2>;

template <class T>
T side_of(const BasePair<T>& gears) {
  return side_of(gears[1]);
}

/// Returns the base helix angles β_b1 and σ β_b2, rad, with the signs of Σ = β_1 + σ β_2.
template <class T>
std::array<T, 2> adding_helix_angles(const BasePair<T>& gears) {
  return {gears[0].helix_angle, side_of(gears) * gears[1].helix_angle};
}

/// r_b2 + σ r_b1, mm: the lower limit of the centre distance on parallel axes. [T4.12]
template <class T>
T base_radius_sum(const BasePair<T>& gears) {
  return gears[1].radius + side_of(gears) * gears[0].radius;
}

/// α_n of the rack, and u of both gears. Near β = 90°, cos β loses its digits, but u is accurate.
template <class T>
struct RackAngles {
  T sin_alpha;         ///< sin α_n
  T cos_alpha;         ///< cos α_n
  std::array<T, 2> u;  ///< cos α_n cos β_i
};

/// The angles of the rack with the pressure angle α_n.
///
/// Formula   u² = cos² α_n − sin² β_b = (cos α_n − S)(cos α_n + S); [T4.5]
/// Domain    cos α_n ≥ |sin β_b| of both gears (contract)
template <class T>
RackAngles<T> angles_at(const BasePair<T>& gears, const T& alpha_n) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  RackAngles<T> a{sin(alpha_n), cos(alpha_n), {}};
  for (int i : {0, 1}) {
    const T s = sin(gears[i].helix_angle);
    const T square = (a.cos_alpha - s) * (a.cos_alpha + s);
    GW_EXPECTS(!(square < T(0)));
    a.u[i] = sqrt(square);
  }
  return a;
}

/// The data of one gear that rolls with the rack.
template <class T>
struct RackSide {
  T helix_angle;             ///< β_i   rad, signed, on the pitch cylinder
  T cos_helix, tan_helix;    ///< cos β_i and tan β_i
  T transverse_angle;        ///< α_ti  rad
  T tan_transverse;          ///< tan α_ti
  T pitch_radius;            ///< r_i   mm
  T tooth_thickness_normal;  ///< t_ni  mm, on the pitch cylinder
  T pitch_point_curvature;   ///< ρ_iC = r_bi tan α_ti  mm
};

template <class T>
struct CommonRack {
  RackAngles<T> angles;
  T normal_pressure_angle;  ///< α_n  rad
  T pitch_normal;           ///< p_n  mm
  T excess;                 ///< Q(α_n) = (Σ t_n − p_n) cos α_n  mm
  T shaft_angle;            ///< Σ = β_1 + σ β_2  rad
  std::array<RackSide<T>, 2> sides;

  /// Returns the distance X at which there is no backlash and all four flanks touch, Q/(2 sin α_n),
  /// mm. [T4.8]
  T tight_plane_distance() const { return excess / (T(2) * angles.sin_alpha); }
};

/// Returns K = Q(0) = Σ s_bt cos β_b − p_bn, mm, the sum of the base thicknesses minus the base
/// pitch. [T4.7]
template <class T>
T base_excess(const BasePair<T>& gears) {
  using std::cos;
  return gears[0].tooth_thickness * cos(gears[0].helix_angle) +
         gears[1].tooth_thickness * cos(gears[1].helix_angle) - normal_base_pitch(gears[0]);
}

/// Returns the rack with the given angles, and the data of both gears that roll with it.
///
/// Formula   r = r_b cos β_b/u, tan α_t = sin α_n/u, tan β = S/u, [T4.5];
///           t_n = (s_bt − τ d_b inv α_t) cos β_b/cos α_n, [T4.6];  Q = K − Σ τ d_b cos β_b inv
///           α_t, [T4.7]
/// Domain    u_i > 0, sin α_n > 0 (contract)
/// Accuracy  ledger rows `mesh.*`
template <class T>
CommonRack<T> common_rack(const BasePair<T>& gears, const RackAngles<T>& angles) {
  using std::atan2;
  using std::cos;
  using std::sin;
  CommonRack<T> rack;
  rack.angles = angles;
  rack.normal_pressure_angle = atan2(angles.sin_alpha, angles.cos_alpha);
  rack.pitch_normal = normal_base_pitch(gears[0]) / angles.cos_alpha;
  rack.excess = base_excess(gears);
  for (int i : {0, 1}) {
    const BaseGear<T>& gear = gears[i];
    RackSide<T>& side = rack.sides[i];
    GW_EXPECTS(angles.u[i] > T(0) && angles.sin_alpha > T(0));
    const T cos_b = cos(gear.helix_angle);
    const T sin_b = sin(gear.helix_angle);
    side.helix_angle = atan2(sin_b, angles.u[i]);
    side.cos_helix = angles.u[i] / angles.cos_alpha;
    side.tan_helix = sin_b / angles.u[i];
    side.transverse_angle = atan2(angles.sin_alpha, angles.u[i]);
    side.tan_transverse = angles.sin_alpha / angles.u[i];
    side.pitch_radius = gear.radius * cos_b / angles.u[i];
    side.pitch_point_curvature = gear.radius * side.tan_transverse;
    const T inv = side_of(gear) * T(2) * gear.radius * involute(side.transverse_angle);
    side.tooth_thickness_normal = (gear.tooth_thickness - inv) * cos_b / angles.cos_alpha;
    rack.excess -= inv * cos_b;
  }
  rack.shaft_angle = rack.sides[0].helix_angle + side_of(gears) * rack.sides[1].helix_angle;
  return rack;
}

/// Returns the centre distance without backlash, a = r_2 + σ (r_1 + X), computed without
/// cancellation.
///
/// Formula   a = r_b2 α_t2/sin α_t2 + σ (r_b1 α_t1/sin α_t1 + K/(2 sin α_n)); [T4.9], [T4.11]
/// Accuracy  ledger row `crossed.center_distance`
template <class T>
T conjugate_center_distance(const BasePair<T>& gears, const CommonRack<T>& rack) {
  using std::cos;
  const auto share = [&](int i) {
    const T sin_t = rack.angles.sin_alpha / cos(gears[i].helix_angle);
    return gears[i].radius * rack.sides[i].transverse_angle / sin_t;
  };
  return share(1) +
         side_of(gears) * (share(0) + base_excess(gears) / (T(2) * rack.angles.sin_alpha));
}

/// Returns the derivative of conjugate_center_distance with respect to α_n, −σ X/tan α_n, mm/rad.
/// The derivative is 0 at the least centre distance. [T4.10]
template <class T>
T conjugate_center_distance_slope(const BasePair<T>& gears, const CommonRack<T>& rack) {
  return -side_of(gears) * rack.tight_plane_distance() * rack.angles.cos_alpha /
         rack.angles.sin_alpha;
}

}  // namespace gearwright
