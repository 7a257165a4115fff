// The two curves every gear has: circles about its axis and involutes of its base circle.
//
//   r     radius, mm              W(t)   point as a complex number, mm      theory:
//   docs/theory/01-frames.md r_b   base radius, mm         ξ      roll angle, rad: the distance
//   rolled on the base circle is r_b ξ ψ_b   half angle of the tooth on the base circle, rad
#pragma once

#include "gearwright/curve/curve.hpp"

namespace gearwright {

/// Circle about the gear axis by its polar angle,  W(θ) = r e^{iθ}. [T1.3]
class AxisCircle final : public Curve {
 public:
  explicit AxisCircle(double radius) : radius_(radius) {}
  Vec2 point(double theta) const override;
  CurvePoint at(double theta) const override;
  double polar_angle(double theta) const override { return theta; }
  double radius() const { return radius_; }

 private:
  double radius_;
};

/// The flank on the side y > 0 of a tooth about the x axis,  W(ξ) = r_b (1 + iξ) e^{i(ψ_b − ξ)}.
/// [T2.4]
///
/// Laws  (1) |W| = r_b √(1 + ξ²)   (2) arg W = ψ_b − (ξ − atan ξ)   (3) curvature radius r_b ξ
/// Domain  any ξ; ξ < 0 is the branch behind the cusp, never a part of a tooth
class Involute final : public Curve {
 public:
  Involute(double base_radius, double base_half_angle)
      : base_radius_(base_radius), base_half_angle_(base_half_angle) {}
  Vec2 point(double xi) const override;
  CurvePoint at(double xi) const override;

  double base_radius() const { return base_radius_; }
  double base_half_angle() const { return base_half_angle_; }
  /// ξ ≥ 0 of the point at radius ρ; 0 for ρ ≤ r_b.
  double roll_at(double rho) const;

  double polar_angle(double xi) const override;
  double parameter_at_radius(double rho, double t_lo, double t_hi) const override;
  bool radius_is_closed_form() const override { return true; }

 private:
  double base_radius_;
  double base_half_angle_;
};

}  // namespace gearwright
