// One smooth piece of a flank's transverse outline, as a complex function of one parameter.
//
//   W(s)   point ρ e^{iθ}, mm; s is the parameter of the piece     ℓ = log W,  u = ln ρ = Re ℓ
//   c      +1 for the side y > 0 of a tooth on the x axis, −1 for the mirror image at y < 0
//   θ′, θ″ derivatives of θ with respect to u, which determine the contact with a mating gear
//                                    theory: docs/theory/08-contact.md, [T8.4]…[T8.6]
//
//   involute       s = ξ   roll angle (negative for an internal gear)
//   rack circle    s = τ   normal angle of the generating rack
//   other curves   s = u
//   flank of a rack  s = u, the height above the datum line divided by r  [T8.29]
//
// The radius is monotone along a piece, so that θ is a function of u.
#pragma once

#include <optional>
#include <variant>

#include "gearwright/base/vector.hpp"
#include "gearwright/curve/basic_curves.hpp"
#include "gearwright/generation/outline.hpp"
#include "gearwright/generation/rack_envelope.hpp"

namespace gearwright {

/// Returns the point w of the transverse plane at the height z.
inline Vec3 space(const Complex& w, double z) { return {w.real(), w.imag(), z}; }

/// The outline at a radius:  θ = arg(factor) + phase.
struct RadialJet {
  Complex factor;  ///< may have any magnitude; only its argument is used
  double phase;    ///< rad
  double d1, d2;   ///< θ′, θ″
};

/// The rotation of a flank per mm of material removed along the normal, k = 1/arm, and the
/// derivatives of k with respect to u. The derivatives are exact for involutes and rack circles,
/// and are set to 0 for other curves.
struct TurnPerRemoval {
  double k, d1, d2;  ///< rad/mm
};

class Profile {
 public:
  /// Makes the piece from one arc of an outline. `side` is c. `twist` is the twist of the gear,
  /// rad/mm. The normal of the surface depends on the twist.
  Profile(const Arc& arc, double side, double twist);

  /// The straight flank of a rack, θ(u) = side (half − slope u) for u_lo ≤ u ≤ u_hi.
  struct RackFlank {
    double u_lo, u_hi, half, slope;
  };
  Profile(const RackFlank& flank, double side);

  double s_lo() const { return s_lo_; }  ///< s_lo < s_hi
  double s_hi() const { return s_hi_; }
  double u_lo() const { return u_lo_; }  ///< least ln ρ
  double u_hi() const { return u_hi_; }
  bool grows() const { return grows_; }  ///< true if the radius grows with s
  double side() const { return side_; }

  /// The point at the parameter s, with derivatives.
  ///
  /// Domain    on the piece and near it, because the formulas continue beyond the ends. The flank
  ///           of a rack is excluded (contract)
  PolarJet at(double s) const;
  /// Returns the outline at ln ρ = u, continued by a Taylor series of second order beyond the ends.
  /// For rack circles, the iteration starts at `s` from the last call and updates `s`.
  RadialJet at_radius(double u, double& s) const;
  /// Returns the rotation per mm of removed material at s. s must not lie far beyond the ends.
  /// [T8.7]
  ///
  /// Domain    not the flank of a rack (contract)
  TurnPerRemoval turn_per_removal(double s) const;
  /// Returns s at u, to rounding. If u lies beyond the piece, returns s at the nearer end. The
  /// iteration of the second function starts at `start`.
  double s_of(double u) const;
  double s_of(double u, double start) const;
  const Involute* involute() const {  ///< null for another curve
    const auto* piece = std::get_if<InvolutePiece>(&piece_);
    return piece ? piece->curve : nullptr;
  }
  /// Returns the normal angle of the generating rack, or none if the piece is not cut by a circular
  /// arc of a rack.
  std::optional<double> rack_angle(double s) const;

 private:
  struct InvolutePiece {
    const Involute* curve;
    double sign;  // sign of ξ
    double arm;   // r_b cos β_b  mm
  };
  struct TrochoidPiece {
    const RackTrochoid* curve;
    double arm_per_cos;  // r cos β  mm
  };
  struct RadialPiece {
    const Curve* curve;
    double t_lo, t_hi;  // the curve's own parameter at u_lo and u_hi
    double twist;       // rad/mm
  };
  using Piece = std::variant<InvolutePiece, TrochoidPiece, RadialPiece, RackFlank>;

  // Implements at_radius() for one kind of piece, between the ends of the piece.
  RadialJet between_ends(const InvolutePiece& piece, double u, double& s) const;
  RadialJet between_ends(const TrochoidPiece& piece, double u, double& s) const;
  RadialJet between_ends(const RadialPiece& piece, double u, double& s) const;
  RadialJet between_ends(const RackFlank& piece, double u, double& s) const;

  CurvePtr curve_;  // keeps the curve to which the piece points; none for the flank of a rack
  double side_;
  double s_lo_, s_hi_, u_lo_, u_hi_;
  bool grows_;
  Piece piece_;
};

}  // namespace gearwright
