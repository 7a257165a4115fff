// Computes all closed-form quantities of two involute gears in mesh, at any shaft angle.
//
//   n    common normal of the leading flanks, along which the contact moves
//   ρ_1  curvature radius of flank 1 in its transverse section, the parameter of the line of action
//   N    distance of the base tangent points in terms of ρ_1
//   c_i = cos β_bi     ρ_2 = (N − σ ρ_1) c_2/c_1 (parallel axes: c_2 = c_1)
//   X    distance of the pitch planes
//   z_L  offset of the line of action along the teeth of the rack, mm
//   s_i  axial position of the contact on gear i, mm, measured from the common perpendicular of the
//        axes. The common perpendicular passes through the middle of the face
//                                              theory: docs/theory/04-conjugate-action.md
//
// Every pair is described by the α_n of the rack and the distance X. On crossed axes, α_n follows
// from Σ, and X follows from a. On parallel axes, α_n follows from a, and X is 0.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "gearwright/pair/common_rack.hpp"
#include "gearwright/pair/leaf_formulas.hpp"
#include "gearwright/pair/working_angles.hpp"

namespace gearwright {

/// Inputs of a mesh; lengths in mm, angles in rad. An internal gear has z2 < 0 and positive radii.
template <class T>
struct MeshInput {
  BasePair<T> gears;
  std::array<T, 2> tip_form_radius{};                  ///< d_Fa/2
  std::array<std::optional<T>, 2> root_form_radius{};  ///< d_Ff/2; none if there is no known limit
  std::array<T, 2> face_width{};                       ///< b
  T center_distance{};                                 ///< a
  std::optional<T> shaft_angle;                        ///< Σ of crossed axes; none if parallel
};

template <class T>
struct Backlash {
  T normal_base;                     ///< j_bn  along the common normal; < 0 if the teeth overlap
  T normal;                          ///< j_n = j_bn/cos α_wn
  std::array<T, 2> circumferential;  ///< j_wt  at the working pitch circles
  std::array<T, 2> rotation;         ///< rad, of each gear while the other gear is held
};

template <class T>
struct Mesh {
  CommonRack<T> rack;       ///< working angles, pitch radii
  T pitch_plane_distance;   ///< X     mm
  T line_offset;            ///< z_L   mm; the trailing line lies at −z_L
  T base_tangent_distance;  ///< N     between the base tangent points, in terms of ρ_1
  T base_cosine_ratio;      ///< c_2/c_1
  T line_cosine;            ///< c_1 on crossed axes, where the line of action is not in the
                            ///< transverse section; 1 on parallel axes
  T rho1_A, rho1_B, rho1_C, rho1_D, rho1_E;  ///< ρ_1 at A (tip 2), B = E − step, C (pitch point),
                                             ///< D = A + step, E (tip 1); < 0 beyond the base
                                             ///< tangent point
  T path_length;  ///< ρ_1E − ρ_1A: g_α on parallel axes, AE cos β_b1 on crossed axes
  T step;         ///< increase of ρ_1 per pitch: p_bt on parallel axes, p_bn cos β_b1 on crossed
                  ///< axes
  T path_ratio;   ///< path_length/step: ε_α on parallel axes, AE/p_bn on crossed axes
  T overlap_ratio;                   ///< ε_β; 0 on crossed axes
  T rho1_true_begin, rho1_true_end;  ///< the path clipped to the usable flanks and, on crossed
                                     ///< axes, also to the faces; no contact if begin ≥ end
  T true_ratio;                      ///< contact ratio of the clipped path, ≥ 0, without ε_β
  Backlash<T> backlash;

  T sigma;                                 ///< σ
  std::array<T, 2> tan_base_helix;         ///< tan β_bi
  std::array<T, 2> pitch_point_curvature;  ///< ρ_iC

  T rho2(const T& rho1) const {
    return leaf::rho_2_where(base_tangent_distance, sigma, rho1) * base_cosine_ratio;
  }
};

/// s_i(ρ_1), mm: position of the contact on gear i's face, from its middle.
///
/// Formula   s_i = z_L/cos β_i + (ρ_i − ρ_iC) tan β_bi; [T4.20]
template <class T>
std::array<T, 2> axial_place(const Mesh<T>& mesh, const T& rho1) {
  const std::array<T, 2> rho{rho1, mesh.rho2(rho1)};
  std::array<T, 2> s;
  for (int i : {0, 1}) {
    s[i] = mesh.line_offset / mesh.rack.sides[i].cos_helix +
           (rho[i] - mesh.pitch_point_curvature[i]) * mesh.tan_base_helix[i];
  }
  return s;
}

namespace detail {

// Clips the path to the usable flanks. The flank of each gear begins at the form point. On an
// internal gear, the form point is the point of the flank with the greatest radius. [T2.19]
template <class T>
void clip_to_flanks(const MeshInput<T>& in, Mesh<T>& m) {
  const auto start = [&](int i) {
    const auto& radius = in.root_form_radius[i];
    return radius ? leaf::curvature_at(*radius, in.gears[i].radius) : T(0);
  };
  m.rho1_true_begin = leaf::usable_begin(m.rho1_A, start(0));
  m.rho1_true_end = m.rho1_E;
  // If flank 2 has no form point, the end of the flank depends on the gear. On an external gear, it
  // is the base circle. On an internal gear, the end is unknown.
  if (in.root_form_radius[1] || m.sigma > T(0)) {
    const T rho2 = start(1) / m.base_cosine_ratio;
    m.rho1_true_end =
        leaf::usable_end(m.rho1_E, leaf::rho_1_where(m.base_tangent_distance, m.sigma, rho2));
  }
}

// Clips the path to −b/2 ≤ s_i ≤ b/2. On a spur gear, s_i is constant along the path.
template <class T>
void clip_to_faces(const MeshInput<T>& in, Mesh<T>& m) {
  using std::abs;
  const T zero(0);
  const auto s_0 = axial_place(m, zero);
  for (int i : {0, 1}) {
    const T slope =
        i == 0 ? m.tan_base_helix[0] : T(-m.sigma * m.base_cosine_ratio * m.tan_base_helix[1]);
    const T half = in.face_width[i] / T(2);
    if (slope == T(0)) {
      if (abs(s_0[i]) > half) m.rho1_true_end = m.rho1_true_begin;
      continue;
    }
    const T one = (-half - s_0[i]) / slope;
    const T other = (half - s_0[i]) / slope;
    const T lo = one < other ? one : other;
    const T hi = one < other ? other : one;
    if (lo > m.rho1_true_begin) m.rho1_true_begin = lo;
    if (hi < m.rho1_true_end) m.rho1_true_end = hi;
  }
}

template <class T>
Backlash<T> backlash_of(const MeshInput<T>& in, const Mesh<T>& m) {
  using std::cos;
  Backlash<T> j;
  // 2 X sin α_n − Q, computed from the difference of a and the backlash-free centre distance. Near
  // β_w = 90°, the pitch radii in X grow without bound and cancel, but a remains finite. [T4.17];
  // on parallel axes [T2.24]
  const T more = m.sigma * (in.center_distance - conjugate_center_distance(in.gears, m.rack));
  j.normal_base = T(2) * more * m.rack.angles.sin_alpha;
  j.normal = j.normal_base / m.rack.angles.cos_alpha;
  for (int i : {0, 1}) {
    j.rotation[i] = j.normal_base / (in.gears[i].radius * cos(in.gears[i].helix_angle));
    j.circumferential[i] = j.rotation[i] * m.rack.sides[i].pitch_radius;
  }
  return j;
}

}  // namespace detail

/// The angles of the common rack of the mounted gears.
template <class T>
RackAngles<T> working_angles(const MeshInput<T>& in) {
  return in.shaft_angle ? angles_at_shaft_angle(in.gears, *in.shaft_angle)
                        : angles_at_parallel_distance(in.gears, in.center_distance);
}

/// Computes all quantities of the mesh.
///
/// Formula   X = σ (a − r_2) − r_1 or 0, j_bn = 2 X sin α_n − Q, [T4.17]; L, [T4.19];
///           path, [T4.18]…[T4.21]
/// Domain    parallel: a > |r_b2 + σ r_b1|; crossed: Σ within shaft_angle_range (contract)
/// Accuracy  ledger rows `mesh.*`, `crossed.*`
template <class T>
Mesh<T> mesh_of(const MeshInput<T>& in) {
  using std::atan;
  using std::cos;
  using std::tan;
  const T pi = atan(T(1)) * T(4);
  const BasePair<T>& gears = in.gears;
  Mesh<T> m;
  m.sigma = side_of(gears);
  m.rack = common_rack(gears, working_angles(in));
  const auto& sides = m.rack.sides;
  for (int i : {0, 1}) {
    m.tan_base_helix[i] = tan(gears[i].helix_angle);
    m.pitch_point_curvature[i] = sides[i].pitch_point_curvature;
  }
  const T p_bt = T(2) * pi * gears[0].radius / T(gears[0].teeth);
  const T face = in.face_width[0] < in.face_width[1] ? in.face_width[0] : in.face_width[1];
  if (in.shaft_angle) {
    const T c_1 = cos(gears[0].helix_angle);
    const T c_2 = cos(gears[1].helix_angle);
    m.base_cosine_ratio = c_2 / c_1;
    m.line_cosine = c_1;
    m.step = p_bt * c_1 * c_1;
    m.overlap_ratio = T(0);
    m.pitch_plane_distance =
        m.sigma * (in.center_distance - sides[1].pitch_radius) - sides[0].pitch_radius;
    m.line_offset = -m.pitch_plane_distance * m.rack.angles.cos_alpha /
                    (m.rack.angles.sin_alpha * (sides[0].tan_helix + m.sigma * sides[1].tan_helix));
    // N = L c_1, where L = ρ_2C/c_2 + σ (ρ_1C/c_1 + X/sin α_n) is measured along n.
    m.base_tangent_distance = m.sigma * m.pitch_point_curvature[0] +
                              m.pitch_point_curvature[1] * c_1 / c_2 +
                              m.sigma * m.pitch_plane_distance * c_1 / m.rack.angles.sin_alpha;
  } else {
    m.base_cosine_ratio = T(1);
    m.line_cosine = T(1);
    m.step = p_bt;
    m.overlap_ratio = leaf::overlap_of(face, m.tan_base_helix[0], p_bt);
    m.pitch_plane_distance = T(0);
    m.line_offset = T(0);
    m.base_tangent_distance = sides[0].tan_transverse * base_radius_sum(gears);  // N = a sin α_wt
  }

  const T rho2_A = leaf::curvature_at(in.tip_form_radius[1], gears[1].radius);
  m.rho1_A = leaf::rho_1_where(m.base_tangent_distance, m.sigma, T(rho2_A / m.base_cosine_ratio));
  m.rho1_E = leaf::curvature_at(in.tip_form_radius[0], gears[0].radius);
  m.rho1_B = m.rho1_E - m.step;
  m.rho1_C = m.pitch_point_curvature[0];
  m.rho1_D = m.rho1_A + m.step;
  m.path_length = m.rho1_E - m.rho1_A;
  m.path_ratio = leaf::contact_ratio(m.rho1_A, m.rho1_E, m.step);
  detail::clip_to_flanks(in, m);
  if (in.shaft_angle) detail::clip_to_faces(in, m);
  const T true_ratio = leaf::contact_ratio(m.rho1_true_begin, m.rho1_true_end, m.step);
  m.true_ratio = leaf::max_of(true_ratio, T(0));
  m.backlash = detail::backlash_of(in, m);
  return m;
}

/// Two face widths of each gear on crossed axes, mm. A face of the width f contains the line of
/// action of one flank. A face of the width f' contains the lines of action of both flanks if the
/// middle of the face is on the common perpendicular.
///
/// Formula   f_i = AE |sin β_bi|, f'_i = 2 max |s_i|; [T4.21]
template <class T>
struct FaceWidths {
  std::array<T, 2> one_flank, both_flanks;
  std::array<std::array<T, 2>, 2> interval;  ///< s_i at A and at E
};

template <class T>
FaceWidths<T> face_widths(const Mesh<T>& mesh) {
  using std::abs;
  const auto s_A = axial_place(mesh, mesh.rho1_A);
  const auto s_E = axial_place(mesh, mesh.rho1_E);
  FaceWidths<T> f;
  for (int i : {0, 1}) {
    f.interval[i] = {s_A[i], s_E[i]};
    f.one_flank[i] = abs(s_E[i] - s_A[i]);
    f.both_flanks[i] = T(2) * (abs(s_A[i]) > abs(s_E[i]) ? abs(s_A[i]) : abs(s_E[i]));
  }
  return f;
}

/// Speed of the contact over each flank, across the teeth and along them, in mm per radian of gear
/// 1. On parallel axes, the speed refers to the transverse section.
///
/// Formula   crossed: ω_i (cos β_i (r_i sin α_n + λ_i), ± sin β_i (r_i + λ_i sin α_n)), with + on
///           gear 1 and −σ on gear 2; [T4.24]
///           parallel: ω_i ρ_i, [T2.22]
template <class T>
struct FlankSpeeds {
  std::array<T, 2> across, along;
};

template <class T>
FlankSpeeds<T> flank_speeds(const MeshInput<T>& in, const Mesh<T>& mesh, const T& rho1) {
  const T omega2 = T(in.gears[0].teeth) / T(std::abs(in.gears[1].teeth));
  const std::array<T, 2> omega{T(1), omega2};
  const std::array<T, 2> rho{rho1, mesh.rho2(rho1)};
  FlankSpeeds<T> w;
  for (int i : {0, 1}) {
    if (!in.shaft_angle) {
      w.across[i] = omega[i] * rho[i];
      w.along[i] = T(0);
      continue;
    }
    using std::cos;
    const RackSide<T>& side = mesh.rack.sides[i];
    const T lambda = (rho[i] - mesh.pitch_point_curvature[i]) / cos(in.gears[i].helix_angle);
    const T sin_a = mesh.rack.angles.sin_alpha;
    const T sign = i == 0 ? T(1) : T(-mesh.sigma);
    w.across[i] = omega[i] * side.cos_helix * (side.pitch_radius * sin_a + lambda);
    w.along[i] =
        sign * omega[i] * side.cos_helix * side.tan_helix * (side.pitch_radius + lambda * sin_a);
  }
  return w;
}

constexpr double kNoSpeed = 1e-12;  // relative to the sum of both speeds; smaller speeds are
                                    // rounding errors

/// Specific sliding (ζ_1, ζ_2) at ρ_1: the sliding distance of the flanks per mm that the contact
/// moves over the flank. On parallel axes, ζ is < 0 on the flank over which the contact moves more
/// slowly. At a base tangent point and beyond it, both ζ are empty. On crossed axes, ζ is the ratio
/// of the magnitudes of the speeds, so ζ ≥ 0.
///
/// Formula   parallel: ζ_1 = 1 − w_2/w_1, ζ_2 = 1 − w_1/w_2, [T2.22];
///           crossed: ζ_i = |w_1 − w_2|/|w_i|, [T4.25]
template <class T>
struct SpecificSliding {
  std::optional<T> zeta_1, zeta_2;
};

template <class T>
SpecificSliding<T> specific_sliding(const MeshInput<T>& in, const Mesh<T>& mesh, const T& rho1) {
  using std::sqrt;
  const FlankSpeeds<T> w = flank_speeds(in, mesh, rho1);
  SpecificSliding<T> s;
  if (!in.shaft_angle) {
    // At a base tangent point, the speed is 0, but rounding may give it either sign.
    const T least = T(kNoSpeed) * (w.across[0] + w.across[1]);
    if (!(w.across[0] > least) || !(w.across[1] > least)) return s;
    s.zeta_1 = leaf::sliding_of(w.across[0], w.across[1]);
    s.zeta_2 = leaf::sliding_of(w.across[1], w.across[0]);
    return s;
  }
  const auto speed = [](const T& x, const T& y) { return T(sqrt(x * x + y * y)); };
  const T sliding = speed(w.across[0] - w.across[1], w.along[0] - w.along[1]);
  const std::array<T, 2> run{speed(w.across[0], w.along[0]), speed(w.across[1], w.along[1])};
  if (run[0] > T(0)) s.zeta_1 = sliding / run[0];
  if (run[1] > T(0)) s.zeta_2 = sliding / run[1];
  return s;
}

}  // namespace gearwright
