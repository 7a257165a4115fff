// Two involute gears on parallel axes: everything about their mesh that has a closed form.
//
//   z, r_b, s_bt, β_b   each gear as itself: teeth, base radius, base thickness, base helix
//   σ    +1 external pair, −1 internal pair (gear 2 is the ring)
//   a    centre distance, mm        α_wt  working transverse pressure angle, rad
//   ρ_1  curvature radius of flank 1 at a point of the path, mm; N = a sin α_wt     theory:
//   docs/theory/02-involute-and-pair.md
//
// A gear is what its base cylinder says, no rack is needed here. Templates over the scalar: double
// in production, 50 digits in the accuracy ledger.
#pragma once

#include <cmath>
#include <cstdlib>
#include <optional>

#include "gearwright/math/involute.hpp"

namespace gearwright {

/// Inputs of a mesh; lengths mm, angles rad. Ring: z2 < 0, radii positive.
template <class T>
struct ParallelMeshInput {
  int z1 = 0;
  int z2 = 0;
  T base_radius_1{}, base_radius_2{};          ///< r_b
  T base_thickness_1{}, base_thickness_2{};    ///< s_bt  transverse; a ring's extrapolated
  T base_helix_angle{};                        ///< |β_b|
  T tip_form_radius_1{}, tip_form_radius_2{};  ///< d_Fa/2
  std::optional<T> root_form_radius_1, root_form_radius_2;  ///< d_Ff/2, none: no such limit known
  T face_width{};                                           ///< common face b
  T center_distance{};                                      ///< a
};

template <class T>
struct ParallelMesh {
  T working_transverse_pressure_angle;               ///< α_wt
  T working_normal_pressure_angle;                   ///< α_wn
  T working_helix_angle;                             ///< |β_w|
  T working_pitch_radius_1, working_pitch_radius_2;  ///< r_w
  T base_tangent_distance;  ///< N = a sin α_wt, between the base tangent points
  T rho1_A, rho1_B, rho1_C, rho1_D,
      rho1_E;     ///< ρ_1 along the path, A … E; negative: beyond the base tangent
  T path_length;  ///< g_α = ρ_1E − ρ_1A
  T rho1_true_begin,
      rho1_true_end;           ///< the path clipped to the usable flanks; begin ≥ end: no contact
  T transverse_contact_ratio;  ///< ε_α
  T overlap_ratio;             ///< ε_β
  T transverse_contact_ratio_true;  ///< of the clipped path, ≥ 0
  T backlash_normal_base;           ///< j_bn  along the common normal; < 0 the teeth overlap
  T backlash_normal;                ///< j_n = j_bn / cos α_wn
  T backlash_circumferential;       ///< j_wt  at the working pitch circles
  T backlash_rotation_1, backlash_rotation_2;  ///< rad, the mate held
};

/// The pressure angle whose involute closes the backlash of the two thicknesses, as inv α_wt.
///
/// Formula   inv α_wt = σ (|z2| s_b2/d_b2 + z1 s_b1/d_b1 − π)/(|z2| + σ z1); [T2.20]
/// Domain    z1 > 0, z1 ≠ −z2 (contract). A negative result: there is no backlash-free distance
template <class T>
T backlash_free_involute(const ParallelMeshInput<T>& in) {
  using std::atan;
  GW_EXPECTS(in.z1 > 0 && in.z2 != 0 && in.z1 + in.z2 != 0);
  const T pi = atan(T(1)) * T(4);
  const T sigma = in.z2 > 0 ? T(1) : T(-1);
  const T n1 = T(in.z1);
  const T n2 = T(std::abs(in.z2));
  const T sum = n2 * in.base_thickness_2 / (T(2) * in.base_radius_2) +
                n1 * in.base_thickness_1 / (T(2) * in.base_radius_1) - pi;
  return sigma * sum / (n2 + sigma * n1);
}

/// Σ of the base radii (external) or their difference (internal): the least centre distance.
/// [T2.14]
template <class T>
T base_radius_sum(const ParallelMeshInput<T>& in) {
  return in.z2 > 0 ? T(in.base_radius_2 + in.base_radius_1)
                   : T(in.base_radius_2 - in.base_radius_1);
}

/// The mesh at the centre distance of the input.
///
/// Formula   [T2.14]…[T2.28]
/// Domain    a > |r_b2 ± r_b1| (contract)
/// Accuracy  ledger rows `mesh.*`
template <class T>
ParallelMesh<T> parallel_mesh(const ParallelMeshInput<T>& in) {
  using std::asin;
  using std::atan;
  using std::atan2;
  using std::cos;
  using std::sin;
  using std::sqrt;
  using std::tan;
  const T pi = atan(T(1)) * T(4);
  const bool external = in.z2 > 0;
  const T sigma = external ? T(1) : T(-1);
  const T r_b1 = in.base_radius_1;
  const T r_b2 = in.base_radius_2;
  const T a = in.center_distance;
  const T r_b_sum = base_radius_sum(in);
  GW_EXPECTS(r_b_sum > T(0) && a > r_b_sum);

  ParallelMesh<T> m;
  // N and α_wt by the right triangle (a, Σr_b): no arc cosine near 0. [T2.14]
  const T N = sqrt((a - r_b_sum) * (a + r_b_sum));
  m.base_tangent_distance = N;
  m.working_transverse_pressure_angle = atan2(N, r_b_sum);
  const T cos_wt = r_b_sum / a;
  const T cos_bb = cos(in.base_helix_angle);
  const T tan_bb = tan(in.base_helix_angle);
  m.working_normal_pressure_angle = asin(N / a * cos_bb);
  m.working_helix_angle = atan(tan_bb / cos_wt);
  m.working_pitch_radius_1 = r_b1 / cos_wt;
  m.working_pitch_radius_2 = r_b2 / cos_wt;

  const T n1 = T(in.z1);
  const T p_bt = T(2) * pi * r_b1 / n1;
  const auto rho = [](const T& radius, const T& base) {
    const T square = (radius - base) * (radius + base);
    return square > T(0) ? T(sqrt(square)) : T(0);
  };
  m.rho1_A = sigma * (N - rho(in.tip_form_radius_2, r_b2));
  m.rho1_E = rho(in.tip_form_radius_1, r_b1);
  m.rho1_B = m.rho1_E - p_bt;
  m.rho1_C = r_b1 * N / r_b_sum;
  m.rho1_D = m.rho1_A + p_bt;
  m.path_length = m.rho1_E - m.rho1_A;
  m.transverse_contact_ratio = m.path_length / p_bt;
  m.overlap_ratio = in.face_width * tan_bb / p_bt;

  // Clip to what both flanks have: ρ_1 above gear 1's form point and, on the other side, ρ_2 = N −
  // σρ_1 above gear 2's (a ring's form point limits from outside). [T2.19]
  T begin = m.rho1_A > T(0) ? m.rho1_A : T(0);
  T end = m.rho1_E;
  if (in.root_form_radius_1) {
    const T limit = rho(*in.root_form_radius_1, r_b1);
    if (limit > begin) begin = limit;
  }
  if (external) {
    T limit = N;
    if (in.root_form_radius_2) limit = N - rho(*in.root_form_radius_2, r_b2);
    if (limit < end) end = limit;
  } else if (in.root_form_radius_2) {
    const T limit = rho(*in.root_form_radius_2, r_b2) - N;
    if (limit < end) end = limit;
  }
  m.rho1_true_begin = begin;
  m.rho1_true_end = end;
  m.transverse_contact_ratio_true = end > begin ? T((end - begin) / p_bt) : T(0);

  // j_bt = p_bt − s_b1 − s_b2 + σ 2 (r_b2 + σ r_b1) inv α_wt, from the distance to the
  // backlash-free involute so that nothing large cancels. [T2.24]
  const T inv_w = involute(m.working_transverse_pressure_angle);
  const T j_bt = sigma * T(2) * r_b_sum * (inv_w - backlash_free_involute(in));
  m.backlash_normal_base = j_bt * cos_bb;
  m.backlash_normal = m.backlash_normal_base / cos(m.working_normal_pressure_angle);
  m.backlash_circumferential = j_bt / cos_wt;
  m.backlash_rotation_1 = j_bt / r_b1;
  m.backlash_rotation_2 = j_bt / r_b2;
  return m;
}

/// Specific sliding (ζ_1, ζ_2) at ρ_1; nothing at or beyond a base tangent point.
///
/// Formula   ζ_1 = 1 − ρ_2/(|u| ρ_1), ζ_2 = 1 − |u| ρ_1/ρ_2, |u| = |z2|/z1; [T2.22]
template <class T>
struct SpecificSliding {
  std::optional<T> zeta_1, zeta_2;
};

template <class T>
SpecificSliding<T> specific_sliding(const ParallelMeshInput<T>& in, const ParallelMesh<T>& mesh,
                                    const T& rho1) {
  const T sigma = in.z2 > 0 ? T(1) : T(-1);
  const T rho2 = mesh.base_tangent_distance - sigma * rho1;
  const T u = T(std::abs(in.z2)) / T(in.z1);
  SpecificSliding<T> s;
  if (!(rho1 > T(0)) || !(rho2 > T(0))) return s;
  s.zeta_1 = T(1) - rho2 / (u * rho1);
  s.zeta_2 = T(1) - u * rho1 / rho2;
  return s;
}

}  // namespace gearwright
