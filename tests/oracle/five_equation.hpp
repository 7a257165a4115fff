// Tooth contact by the five equations of textbooks, in long double: two flanks share a point and a
// normal. This is a slow, independent method, which uses no angular gap, no maximum and no edge.
// The notation of a flank is in flank_surface.hpp, and that of housing and errors in mounting.hpp.
//
//   r_1f(s_1, z_1; φ_1) = r_2f(s_2, z_2; φ_2)       three, over the length scale L
//   n_1f · t = n_1f · t′ = 0                        two, t and t′ span the tangent plane of flank 2
//
// for s_1, z_1, s_2, z_2, φ_2 at given φ_1. The method is Newton's with step halving. Deviations
// from a pair whose contact is known are introduced in eight equal steps.
//
// A solution is a contact only if the gap opens on all sides (K_2 − K_1 positive definite) and the
// point lies within both outlines and both faces. Of several tooth pairs, the one with the greatest
// φ_2 carries the load.
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "tests/oracle/flank_surface.hpp"
#include "tests/oracle/mounting.hpp"

namespace gearwright::oracle::tca {

inline constexpr Real kUnbounded = std::numeric_limits<Real>::infinity();

/// The existing part of a flank.
struct Ends {
  Real s_low = -kUnbounded, s_high = kUnbounded;
  Real z_low = -kUnbounded, z_high = kUnbounded;
};

struct FlankPair {
  Surface flank_1, flank_2;
  Ends ends_1, ends_2;
  Mounting mounting;
  Real ratio = 1;  ///< N_1/N_2
  Real scale = 1;  ///< L  the size of gear 1
};

/// The five unknowns.
struct Unknowns {
  Real s_1 = 0, z_1 = 0, s_2 = 0, z_2 = 0;
  Real rotation_2 = 0;  ///< φ_2
};

struct FiveEquationTouch {
  bool solved = false;  ///< residual < kSolved
  Unknowns at;
  Real transmission_error = 0;  ///< φ_2 − φ_1 N_1/N_2
  Vector3 point_f, normal_f;
  Vector3 point_1, point_2;  ///< in the gears' frames

  /// K_2 − K_1 in e_1, e_2: e_1 the projection of the nominal axis 1 (z), e_2 = n × e_1.
  Matrix2 gap_curvature;
  Real k_1 = 0, k_2 = 0;  ///< its eigenvalues, k_1 ≤ k_2; semi-axes √(2 δ/k)
  Real major_angle = 0;   ///< from e_1 to the direction of k_1, towards e_2, in (−π/2, π/2]

  bool opens = false;            ///< k_1 > 0
  bool within_outlines = false;  ///< s inside both ends
  bool within_faces = false;     ///< z inside both ends
  Real residual = 0;             ///< norm of the five
  int iterations = 0;

  bool holds() const { return solved && opens && within_outlines && within_faces; }
};

/// Residual below which a solution is accepted: a thousand units in the last place for numbers of
/// size 1.
inline constexpr Real kSolved = 1000 * std::numeric_limits<Real>::epsilon();

/// Newton's method for the pair itself, from a start value.
FiveEquationTouch solve(const FlankPair& pair, Real rotation_1, const Unknowns& start);

/// Solves the pair that `deviates` returns for part = 1. The solution starts at part = 0, which
/// `start` solves.
FiveEquationTouch follow(const std::function<FlankPair(Real part)>& deviates, Real rotation_1,
                         const Unknowns& start, int steps = 8);

/// An arc in the normal section of a rack, and the part of this arc that makes the flank.
struct RackArc {
  Real rho = 0, a = 0, b = 0;
  Real theta_low = 0, theta_high = std::numeric_limits<Real>::infinity();
};

/// A circular-arc pair. Gear 1 is right-hand and cut by F; gear 2 is left-hand and cut by P.
struct ArcPair {
  int teeth_1 = 0, teeth_2 = 0;  ///< N_1, N_2
  RackArc f, p;
  Real lead_angle_f = 0, lead_angle_p = 0;      ///< λ_F, λ_P
  Real pitch_radius_1 = 0, pitch_radius_2 = 0;  ///< r_1, r_2
  Mounting mounting;                            ///< its center_distance is C_0
  LeadTurn lead_1, lead_2;                      ///< κ_1, κ_2, crownings
  Real half_face_1 = kUnbounded, half_face_2 = kUnbounded;
};

ArcFlank flank_1(const ArcPair& pair);
ArcFlank flank_2(const ArcPair& pair);

/// Part 1 is the pair itself. Part 0 has no errors, Σ = 0, λ_F = λ_P, and a b_F for which θ =
/// `theta` is the common rack angle.
FlankPair flank_pair(const ArcPair& pair, Real theta, Real part = 1);

/// The θ at which flanks without errors touch, sin θ = (b_P − b_F)/(ρ_P − ρ_F). If there is no
/// solution between 5° and 60°, 30° is used and the difference counts as an error.
Real nominal_theta(const ArcPair& pair);

/// The contact of one tooth pair at φ_1, from the closed form of part 0.
FiveEquationTouch arc_touch(const ArcPair& pair, Real rotation_1);

/// The tooth pair with |k| ≤ reach that carries the load. Only valid contacts count. φ_2 and the
/// rotation errors refer to the gears, the position refers to tooth pair k.
struct CarryingPair {
  int pair = 0;  ///< k
  FiveEquationTouch touch;
};
std::optional<CarryingPair> carrying_arc_touch(const ArcPair& pair, Real rotation_1, int reach);

}  // namespace gearwright::oracle::tca
