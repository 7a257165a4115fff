// Computes the chordal tooth thickness, which is the reading of a calliper over one tooth.
//
//   d, r     diameter and radius at which the jaws touch, mm      r_a  tip radius, mm
//   θ_t      half angle of the tooth at d, s_t/d, rad             ψ    helix angle at d, rad
//   θ        half angle between the two points of contact, rad    T    tan² ψ
//   ζ        half of the axial distance between these points, relative to r
//   k, Δh    chord, and rise of the arc over the chord, mm        * marks the shortest chord
//                                                   theory: docs/theory/05-approximations.md
//
// A calliper across a helical tooth can be inclined. The reading is then the shortest chord, which
// is computed exactly. The same code applies to spur gears and worms. The functions are templates
// over the scalar.
#pragma once

#include <cmath>
#include <optional>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

/// A tooth on one cylinder.
template <class T>
struct ToothArc {
  T half_angle{};   ///< θ_t  rad
  T helix_angle{};  ///< ψ    rad, signed
  T radius{};       ///< r    mm
  T tip_radius{};   ///< r_a  mm
  T side{1};        ///< σ    −1 for an internal gear, whose tip lies inside r
};

template <class T>
struct ChordalThickness {
  T chord;            ///< k*   mm, the least over the inclinations of the calliper
  T height;           ///< Δh*  mm, rise of the arc over the chord
  T tip_to_chord;     ///< mm, depth setting of the calliper; < 0 if the chord of an internal gear
                      ///< lies inside the tip
  T caliper_angle;    ///< rad, to the transverse plane, with the sign of ψ if θ* < π/2
  T half_angle_used;  ///< θ*   rad
};

/// Least θ_t, rad. For every greater θ_t and every T up to 1e33 (tan² of the double next to π/2),
/// θ* is a normal floating-point number. Real teeth have a much greater θ_t. Even a θ_t that is
/// only a rounding error, about 1e-17, is much greater.
inline constexpr double kMinHalfAngle = 1e-100;

/// Returns the half angle θ* of the shortest chord, which is the root of T sin 2θ + 2θ = 2θ_t.
///
/// For θ_t ≤ π/2 there is only one root in [0, θ_t], and it gives the least of all chords. A tooth
/// that covers more than half the circumference may have several roots. The result is then the root
/// at which the chord has the local minimum nearest to the axial direction. If θ* > π/2, the chord
/// lies beyond the axis.
///
/// Formula   [T5.4], from [T5.1]…[T5.3]; bracket between the turning points [T5.5], start [T5.8]
/// Domain    kMinHalfAngle ≤ θ_t < π (contract), any |ψ| < π/2 as T = tan² ψ
template <class T>
T shortest_chord_half_angle(const T& theta_t, const T& tan_psi_squared) {
  using std::acos;
  using std::atan;
  using std::cos;
  using std::sin;
  const T pi = atan(T(1)) * T(4);
  GW_EXPECTS(!(theta_t < T(kMinHalfAngle)) && theta_t < pi);
  GW_EXPECTS(!(tan_psi_squared < T(0)));
  const T half_pi = pi / T(2);
  const auto f = [&](const T& theta) {
    return Slope<T>{tan_psi_squared * sin(T(2) * theta) + T(2) * (theta - theta_t),
                    T(2) * tan_psi_squared * cos(T(2) * theta) + T(2)};
  };
  // f increases from −2θ_t up to its maximum, which exists if T > 1.
  T lo(0);
  T hi = theta_t;
  if (tan_psi_squared > T(1)) hi = acos(T(-1) / tan_psi_squared) / T(2);
  if (theta_t > half_pi && (!(tan_psi_squared > T(1)) || f(hi).value < T(0))) {
    lo = theta_t;  // the only root lies beyond the axis, where sin 2θ is negative
    hi = pi;
  }
  T start = theta_t / (T(1) + tan_psi_squared);
  if (start < lo) start = lo;
  if (start > hi) start = hi;
  const auto root = newton_in_bracket<T>(f, lo, hi, start, true);
  GW_ENSURES(root.found());
  return root.x;
}

/// Formula   k* = 2 r sin θ* √(1 + T cos² θ*), Δh* = 2 r sin² (θ*/2),
///           angle arctan(tan ψ cos θ*); [T5.6], [T5.7]. For ψ = 0, exactly 2 r sin θ_t as for a
///           spur gear
/// Units     mm, rad
/// Domain    kMinHalfAngle ≤ θ_t < π, |ψ| < π/2, r > 0 (contract)
/// Accuracy  ledger rows `chord.*`
template <class T>
ChordalThickness<T> shortest_chord(const ToothArc<T>& tooth) {
  using std::atan;
  using std::cos;
  using std::sin;
  using std::sqrt;
  using std::tan;
  GW_EXPECTS(tooth.radius > T(0));
  GW_EXPECTS(cos(tooth.helix_angle) > T(0));
  const T tan_psi = tan(tooth.helix_angle);
  const T theta = shortest_chord_half_angle(tooth.half_angle, T(tan_psi * tan_psi));
  const T rise = tan_psi * cos(theta);
  const T half_sine = sin(theta / T(2));
  ChordalThickness<T> c;
  c.chord = T(2) * tooth.radius * sin(theta) * sqrt(T(1) + rise * rise);
  c.height = T(2) * tooth.radius * half_sine * half_sine;
  c.tip_to_chord = tooth.side * ((tooth.tip_radius - tooth.radius) + c.height);
  c.caliper_angle = atan(rise);
  c.half_angle_used = theta;
  return c;
}

/// Returns the tooth of a gear on the cylinder with the diameter d_y.
///
/// Formula   θ_t = s_yt/d_y, tan ψ = (d_y/d_b) tan β_b; [T2.11], [T2.12]
/// Domain    d_y ≥ d_b (contract); θ_t ≤ 0 beyond the diameter at which the flanks meet
ToothArc<double> tooth_arc(const Gear& gear, double diameter);
/// Returns the shortest chord over a tooth of a gear, which may be internal. The tooth thickness
/// includes the thickness allowance. The usable flank lies between d_Ff and d_Fa, or for an
/// internal gear without a tooth between d_Fa and the root diameter. It never extends inside the
/// base circle.
///
/// Errors    `chord_diameter` if the diameter is not on the usable flank, if the flanks meet before
///           this diameter, if no calliper can span the tooth, or if the gear has no flank
Result<ChordalThickness<double>> chordal_thickness(const Gear& gear, double diameter);

// The constant chord, which is the chord between the points at which a rack touches both sides of a
// tooth at the same time.
//
//   s_n   normal tooth thickness at the reference cylinder, mm     s_c   constant chord, mm
//   h_c   height of the tip over the chord, mm                     α_n   pressure angle of the rack
//                                              theory: docs/theory/10-inspection.md
//
// The common normals of rack and tooth intersect on the reference cylinder, in the middle of the
// tooth. The chord therefore depends on the rack and s_n only, not on the number of teeth or the
// helix angle.

struct ConstantChord {
  double chord;             ///< s_c  mm
  double tip_to_chord;      ///< h_c  mm, from the actual tip
  double contact_diameter;  ///< mm
  ContactPlace place;
};

/// Formula   s_c = s_n cos² α_n, h_c = ±(d_a − d)/2 − s_n sin α_n cos α_n/2; [T10.13], [T10.14]
/// Units     mm
/// None      if there is no usable flank
std::optional<ConstantChord> constant_chord(const Gear& gear);

}  // namespace gearwright
