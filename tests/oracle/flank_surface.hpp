// Tooth flanks as points in space, in long double, for the slow method of tooth contact: five
// equations (five_equation.hpp) that use only the points and normals of a flank.
//
//   s, z      a point of a flank: s along its transverse outline, z along the gear's axis
//   r, n      the point and its unit normal; for both gears, n points out of the material of gear 1
//             and into that of gear 2
//   r_s, r_z, n_s, n_z   derivatives of r and n with respect to s and z
//   K         curvature tensor of the tangent plane, dn = −K dr
//
// Circular arc, s = θ.  In the normal section of a rack, x_a is measured from the pitch line in the
// direction from axis 1 to axis 2. The arc is x_a = ρ sin θ − b, y_a = −(ρ cos θ − a) with the
// normal (sin θ, −cos θ). The tooth of the rack has the lead angle λ, and the rack rolls on the
// pitch radius r. At the rack rotation φ, it touches the gear at
//
//   A = ρ sin θ − b ± r,  B = (ρ cos θ − b cot θ) sin λ,  z = ζ(θ) + r φ tan λ                  (1)
//   ζ = ρ cos θ cos λ − a / cos λ + b cot θ tan λ sin λ
//
// The point of the gear is (A, −B), with +x pointing away from axis 1. It is turned by +φ on gear 1
// (upper sign) and by −φ on gear 2. φ is computed from z, so λ = 90° is possible too. In these
// formulas, gear 1 is right-hand and gear 2 left-hand. The opposite hands are the mirror image z →
// −z. The same formulas hold for fillets, with ρ < 0 or ρ > 0.
//
// Involute, s = ξ = tan α.  W = r_b (1 + i σ ξ) e^{i(θ_c + σ(η − ξ))} as x + iy, turned by τ z;
// σ = −1 is the clockwise side of the tooth, which leads. External gears.
//
// Lead.  The section z of either gear is turned about the axis of this gear by κ z + c z²,
// counter-clockwise seen from +z. κ is the lead error. c > 0 is a crowning, which removes material
// from a leading flank towards both ends.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace gearwright::oracle::tca {

using Real = long double;
using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Matrix2 = Eigen::Matrix<Real, 2, 2>;

/// A point of a flank with its first derivatives, in the gear's frame.
struct FlankPlace {
  Vector3 r, r_s, r_z;
  Vector3 n, n_s, n_z;
};

using Surface = std::function<FlankPlace(Real s, Real z)>;

/// The rack arc that cuts a gear, and the pitch cylinder of the gear; in any unit of length, rad.
struct ArcFlank {
  int gear = 1;  ///< 1 or 2: determines the side of the pitch line on which the axis lies, and the
                 ///< direction of φ
  Real rho = 0;  ///< ρ  signed
  Real a = 0, b = 0;      ///< the arc's centre is (−b, a)
  Real lead_angle = 0;    ///< λ  0 < λ ≤ π/2
  Real pitch_radius = 0;  ///< r
  bool mirrored = false;  ///< true for the opposite hand
};

/// One flank of an external involute gear; mm, rad.
struct InvoluteFlank {
  int gear = 1;              ///< 1 if n points out of this gear's tooth; 2 if it points into the
                             ///< tooth
  Real base_radius = 0;      ///< r_b
  Real half_angle = 0;       ///< η  half of the angle of the tooth on the base circle
  Real center = 0;           ///< θ_c  azimuth of the tooth's centre line in the section z = 0
  Real turn_per_length = 0;  ///< τ = 2π/lead, > 0 right hand, 0 spur
  int side = -1;             ///< σ
};

/// Additional turns of the sections.
struct LeadTurn {
  Real twist = 0;     ///< κ  rad per length
  Real crowning = 0;  ///< c  rad per length²
};

/// Units     as given        Domain    0 < θ < π, lead angle in (0, π/2]
/// Throws    std::invalid_argument outside
Surface arc_surface(const ArcFlank& flank);

/// Domain    ξ > 0: at the base circle itself the surface has an edge of regression
Surface involute_surface(const InvoluteFlank& flank);

/// The flank with turned sections: points are transformed by the rotation, normals by its inverse
/// transpose.
Surface turned(Surface flank, LeadTurn lead);

/// φ of (1): the position of the rack for the point (θ, z) of the flank without lead errors.
Real rack_rotation(const ArcFlank& flank, Real theta, Real z);

/// z of (1) for given θ and φ.
Real rack_height(const ArcFlank& flank, Real theta, Real phi);

/// K in the orthonormal basis e_1, e_2 of the tangent plane.
Matrix2 curvature(const FlankPlace& place, const Vector3& e_1, const Vector3& e_2);

/// Rotation about z, counter-clockwise for angle > 0.
Matrix3 turn_about_z(Real angle);

}  // namespace gearwright::oracle::tca
