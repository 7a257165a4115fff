// Contact of a convex and a concave circular-arc flank on parallel axes, in closed form.
//
//   F, P   the racks that cut the convex (v) and the concave (c) flank
//   ρ, a, b   radius of a rack's arc and position of its centre, as in tool/arc_rack.hpp, mm
//   λ      lead angle, 90° − |β|       r   pitch radius, mm
//   θ      normal angle of both racks at the contact
//   μ      rotation of the convex gear between the cutting of the point and its contact
//   t, u   axes in the tangent plane: t along the profile of the rack, u along its tooth
//                                              theory: docs/theory/07-circular-arc.md, 7.5, 7.6
//
// Frame: z runs along the axis of the convex gear, and x points towards the other axis. The convex
// gear is right handed and drives clockwise. At rotation 0, tooth 0 of this gear and a space of the
// mating gear lie on the x axis. The normal n of the surfaces points out of the convex flank. The
// curvature K is defined by dn = −K dr.
#pragma once

#include <array>
#include <optional>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/vector.hpp"

namespace gearwright {

using Mat2 = Eigen::Matrix2d;

/// A rack's arc, mm.
struct WorkingArc {
  double radius;  ///< ρ
  double a, b;    ///< position of the centre
};

struct ArcMeshInput {
  WorkingArc convex, concave;
  double pitch_radius_convex, pitch_radius_concave;  ///< r_v, r_c  mm
  Angle lead_angle;                                  ///< λ
  double center_distance;                            ///< mm
};

struct ArcContact {
  Angle theta;  ///< θ
  Angle mu;     ///< μ
  Vec3 point;   ///< at rotation 0, mm
  Vec3 normal;
  double advance;             ///< dz/dφ of the point for a rotation φ of the convex gear, mm/rad
  Angle rotation_offset;      ///< rotation by which the concave gear leads the convex gear; < 0 if
                              ///< there is play
  double radius_convex;       ///< distance of the point from the axis of the convex gear, mm
  double radius_concave;      ///< distance of the point from the axis of the concave gear, mm
  Mat2 curvature_convex;      ///< K of the convex flank in (t, u), 1/mm
  Mat2 curvature_concave;     ///< K of the concave flank in (t, u), 1/mm
  std::array<double, 2> gap;  ///< eigenvalues of K_c − K_v, 1/mm, k1 ≤ k2; interference if ≤ 0
  Angle angle;                ///< from the projection of the axis on the tangent plane to the
                              ///< direction of k1, in the tangent plane
  double
      transverse_radius_convex;  ///< radius of curvature of the convex transverse profile, mm; > 0
                                 ///< if the centre of curvature lies on the side of the convex gear
  double transverse_radius_concave;  ///< radius of curvature of the concave profile, mm; > 0 if the
                                     ///< centre of curvature lies on the side of the convex gear
  double line_contact_difference;  ///< ρ_2 − ρ_1 of the transverse profiles in line contact, mm
};

/// Returns the curvature K, at the normal angle θ, of a surface cut by a circular arc of a rack. ρ
/// and b are signed. `turn` is +1 for the convex gear (gear 1 of the frame), and otherwise −1.
///
/// Units     mm, rad
/// Formula   [T7.14]
Mat2 cut_curvature(double rho, double b, double theta, double lead_angle, double pitch_radius,
                   double turn);

/// Returns the normal angle of the contact at the centre distance of `in`. Returns none if the arcs
/// have no common normal at this centre distance.
///
/// Formula   exact, [T7.16]; the root is bracketed by steps from the first-order angle [T7.17]
/// Domain    the concave arc has the greater radius (contract)
std::optional<Angle> contact_angle(const ArcMeshInput& in);

ArcContact arc_contact(const ArcMeshInput& in, Angle theta);

// The tool setting is b_F, the b of the rack that cuts the convex teeth of circular-arc gears. The
// first function computes the change of b_F that restores the contact after a change of the centre
// distance. The second function computes the effect of this change on the tooth thickness.
//
//   θ   normal angle at the contact       C   centre distance       C0 = r_F + r_P
//   w = (ρ_F − ρ_P) sin θ − (b_F − b_P)   distance along the centre line between the points of
//                                         both racks that have the normal angle θ, mm
//                                         theory: docs/theory/08-contact.md, [T8.20], [T8.21]

/// Returns the change Δb_F that moves the contact to the angle θ at `in.center_distance` + ΔC.
///
/// Formula   exact, a quadratic equation in w; the first order is −ΔC (Litvin and Tsay, Eq. 34)
/// Units     mm
/// Domain    0 < θ < π/2 (contract)
double tool_setting_change(const ArcMeshInput& in, Angle theta, double delta_distance);

/// Returns the change of the normal thickness of the convex tooth that Δb_F causes, mm. The change
/// is < 0 if the tooth becomes thinner. The thickness is measured at the height of the point with
/// the normal angle θ.
///
/// Formula   2 (√(ρ² − (x + b)²) − ρ cos θ) with x + b = ρ sin θ + Δb_F, exact; slope [T8.23]
/// Domain    |x + b| < ρ (contract)
double thickness_change(const WorkingArc& convex, Angle theta, double delta_b);

}  // namespace gearwright
