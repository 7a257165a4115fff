// The angle through which gear 2 must turn until its flank passes through a point of flank 1,
// with first and second derivatives.
//
//   World N: z along axis 1, x along the centre line, gear 2 driven counter-clockwise; the
//   clockwise side of the tooth of gear 2 touches. Other cases are transformed to the frame N
//   (contact/contact_pair.hpp).
//   φ1   rotation of gear 1          E = φ1 |z1/z2|, the expected rotation of gear 2
//   φ2*  rotation of gear 2 at which its flank contains the point (ρ, ψ, Z) of flank 1
//   ρ, ψ, Z      cylindrical coordinates of the point in the frame of gear 2;  u = ln ρ
//   θ2, m2, τ2   polar angle of flank 2, its rotation due to removed material, and its twist
//
//   φ2*(ρ, ψ, Z) = ψ − θ2(ρ) − m2(ρ, Z) − Z τ2,   T = φ2* − E, rad
//                                    theory: docs/theory/08-contact.md, [T8.1]…[T8.3], [T8.8]
//
//   If gear 2 is a rack, travel along the rack replaces the azimuth, and height above the datum
//   line replaces ln ρ, both divided by the reference radius r of the pinion:  u + iψ = −w/r
//   [T8.29].
//
// The flanks touch at the point of flank 1 at which T is greatest. Only the part of flank 1 that
// lies opposite flank 2 counts. One evaluation returns all data of a Newton step, without memory
// allocation or virtual calls.
#pragma once

#include <array>

#include "gearwright/base/vector.hpp"
#include "gearwright/contact/profile.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/kinematics/pose.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright {

struct World {};  ///< N
struct Axis1 {};  ///< the frame of gear 1: N before errors tilt and shift axis 1
struct Axis2 {};  ///< the frame of gear 2 at rotation 0

/// A vector in the frame of gear 1 with the part w in the transverse plane.
inline FreeVector<Axis1> along_1(const Complex& w, double z) { return {space(w, z)}; }

/// A patch of a flank in world N: one smooth piece of its profile over a part of the face.
struct FlankPatch {
  Profile profile;
  double center;  ///< rad, azimuth of the tooth's centre line at rotation 0 in the section z = 0
  double twist;   ///< τ  rad/mm, including the lead error
  double z_lo, z_hi;  ///< mm, ends of the patch along the face
  /// Material removed from this flank; null if no material is removed. The height z on the patch
  /// times removal_z (±1) is the height in the RemovalField.
  const RemovalField* removal = nullptr;
  RemovalField::Piece piece = {};
  double removal_z = 1.0;
  /// The kind of border at each end of a patch. At a ridge, the next patch continues with another
  /// slope. At a seam, it continues with the same slope. At any other border, the flank ends.
  enum class End { tip, form, seam, ridge, face };
  End s_lo_end = End::form, s_hi_end = End::tip, z_lo_end = End::face, z_hi_end = End::face;
  /// The part of the profile that the patch uses: its range of s, and its range of u = ln ρ.
  double s_lo = 0.0, s_hi = 0.0, u_lo = 0.0, u_hi = 0.0;
};

/// The transformation x_2 = rotation x_1 + shift from the frame of gear 1 to the frame of gear 2,
/// both at rotation 0.
struct RelativeMount {
  LinearMap<Axis2, Axis1> rotation;
  Point<Axis2> shift;
};

struct Jet2 {
  double v, s, z, ss, sz, zz;
};

/// The field at a point of flank 1.
struct GapJet {
  Jet2 t;                     ///< T   rad
  Jet2 u;                     ///< ln ρ of the point on gear 2
  Jet2 Z;                     ///< mm, height of the point on gear 2
  double slope2_u, slope2_Z;  ///< slopes of flank 2: θ2′ + ∂m2/∂u and τ2 + ∂m2/∂Z
  double bend2_uu, bend2_uZ, bend2_ZZ;  ///< derivatives of slope2_u and slope2_Z
  Complex w1, w1_s, w1_z;  ///< the point of gear 1 in the transverse plane, mm, before mounting
  Complex w1_ss, w1_sz, w1_zz;
  /// The derivative ∂w/∂(u + iψ), and its derivatives with respect to s and z. For a gear,
  /// ∂w/∂(u + iψ) is equal to w, the point in the frame of gear 2. For a rack, it is −r, and
  /// its derivatives are 0.
  Complex w, w_s, w_z;
};

class GapField {
 public:
  /// `rotation_sign` is −1 if increasing φ1 turns gear 1 clockwise, and +1 if counter-clockwise.
  /// `rack_radius` is r if gear 2 is a rack, and 0 otherwise.
  GapField(const FlankPatch& one, const FlankPatch& two, const RelativeMount& mount, double ratio,
           double rotation_sign, double rack_radius = 0.0);

  void set_rotation(double phi1);
  double rotation() const { return phi1_; }
  /// Computes the field at (s, z) of flank 1. The iteration starts at `s2`, the parameter on flank
  /// 2 from the last call, and sets `s2` to the parameter for this call.
  GapJet at(double s, double z, double& s2) const;
  /// The point at (s, z) of flank 1 in the transverse plane at rotation 0, mm, before mounting.
  Complex point_at_rest(double s, double z) const;
  /// The point `at_rest` after the rotation φ1.
  Complex rotated(const Complex& at_rest) const { return times(at_rest, rotation_factor_); }
  struct Place2 {
    Complex w;  ///< mm, in the transverse plane
    double Z;   ///< mm, along the axis
  };
  Place2 on_gear_2(const Complex& w1, double z) const;
  /// Returns T without derivatives at a point in the frame of gear 2. See at() for `s2`.
  double value(const Place2& place, double& s2) const;
  /// Normal distance of the flanks per radian of gap angle, 1/|∇φ2*|, mm. [T8.3], on a rack [T8.30]
  static double arm(const GapJet& j);

  const FlankPatch& one() const { return *one_; }
  const FlankPatch& two() const { return *two_; }
  const RelativeMount& mount() const { return mount_; }
  double rotation_sign() const { return rotation_sign_; }

 private:
  const FlankPatch* one_;
  const FlankPatch* two_;
  RelativeMount mount_;
  double ratio_, rotation_sign_, rack_radius_;
  Complex from_x_, from_y_, from_z_, from_0_;
  double phi1_ = 0.0, phase1_ = 0.0, expected_ = 0.0;
  Complex rotation_factor_{1.0, 0.0};
};

/// The gap of two flanks around a point, as a quadratic form: gap ≈ ½ (k1 x² + k2 y²), with
/// k1 ≤ k2 in 1/mm, and x and y in mm along the principal directions. [T8.15]
struct GapForm {
  SymmetricEigen principal;     ///< k1, k2 and their directions in (e1, e2)
  Eigen::Matrix2d of_distance;  ///< maps a step in (e1, e2) to (ds, dz) on flank 1
};

/// The quadratic form of the gap. `r_s` and `r_z` are the derivatives of the point of flank 1 with
/// respect to s and z, and `e1`, `e2` are an orthonormal basis of the tangent plane, in any frame.
GapForm gap_form(const GapJet& j, const Vec3& r_s, const Vec3& r_z, const Vec3& e1, const Vec3& e2);

}  // namespace gearwright
