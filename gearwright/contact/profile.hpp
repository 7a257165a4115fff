// One smooth piece of a flank's transverse outline, written as one complex number.
//
//   W(s)   point ρ e^{iθ}, mm; s the piece's own parameter         ℓ = log W,  u = ln ρ = Re ℓ
//   c      +1 the side y > 0 of a tooth about the x axis, −1 its mirror image, the side y < 0
//   θ′, θ″ derivatives of θ by u, which determine the contact with a mating gear
//                                    theory: docs/theory/08-contact.md, [T8.4]…[T8.6]
//
//   involute       s = ξ   roll angle (an internal gear's is negative)
//   rack circle    s = τ   normal angle of the generating rack
//   by radius      s = u   every other curve of an outline
//
// Along a piece the radius is monotone, so that θ(u) is a function.
#pragma once

#include <optional>

#include "gearwright/base/vector.hpp"
#include "gearwright/curve/polar_jet.hpp"
#include "gearwright/generation/outline.hpp"
#include "gearwright/generation/rack_envelope.hpp"

namespace gearwright {

/// A point of the transverse plane, at the height z.
inline Vec3 space(const Complex& w, double z) { return {w.real(), w.imag(), z}; }

/// The outline at a radius:  θ = arg(factor) + phase.
struct RadialJet {
  Complex factor;  ///< any length
  double phase;    ///< rad
  double d1, d2;   ///< θ′, θ″ by u
};

/// The turn of a flank per normal removal of material, k = 1/arm, and its derivatives by u.
struct TurnPerRemoval {
  double k, d1, d2;  ///< rad/mm
};

class Profile {
 public:
  /// The piece of an outline's arc from parameter lo to hi (of the arc's curve), on the side c.
  /// `twist` is 1/p of the gear, rad/mm, which the normal of a surface needs.
  Profile(const Arc& arc, double side, double twist);

  double s_lo() const { return s_lo_; }  ///< s_lo < s_hi
  double s_hi() const { return s_hi_; }
  double u_lo() const { return u_lo_; }  ///< least ln ρ
  double u_hi() const { return u_hi_; }
  bool grows() const { return grows_; }  ///< true if the radius grows with s
  double side() const { return side_; }

  /// Domain  any s near the piece; the formulas continue beyond its ends.
  PolarJet at(double s) const;
  /// The outline at ln ρ = u. Beyond the ends of the piece a Taylor series of second order is used.
  /// `s` is the parameter of the last call and is updated (circles of a rack iterate from it).
  RadialJet at_radius(double u, double& s) const;
  /// The turn per removal at the parameter s (not far beyond the ends). [T8.7]
  TurnPerRemoval turn_per_removal(double s) const;
  double s_of(double u) const;                ///< solved to rounding; u is moved into the piece
  double s_of(double u, double start) const;  ///< the same, starting nearby
  bool is_involute() const { return involute_ != nullptr; }
  /// Normal angle of the generating rack's circle; none if no such circle cut the piece.
  std::optional<double> rack_angle(double s) const;

 private:
  RadialJet involute_at_radius(double u) const;
  RadialJet circle_at_radius(double u, double& s) const;
  RadialJet curve_at_radius(double u) const;

  CurvePtr curve_;
  const Involute* involute_ = nullptr;    // the curve, if it is one
  const RackTrochoid* circle_ = nullptr;  // the curve, if a circle of a rack cut it
  double side_;
  double s_lo_, s_hi_, u_lo_, u_hi_;
  bool grows_;
  double xi_sign_ = 1.0;
  double t_lo_ = 0.0, t_hi_ = 0.0;
  double arm_per_cos_ = 0.0;  // r cos β, or r_b cos β_b
};

}  // namespace gearwright
