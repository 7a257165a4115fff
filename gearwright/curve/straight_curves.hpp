// The curves of a rack in a plane section: straight lines, and circles of the normal section, which
// are ellipses in the transverse section.
//
//   W(t)  point as a complex number x + iy, mm      ρ  radius in the normal section, mm
//   k     stretch along y, 1/cos β                  theory: docs/theory/02-involute-and-pair.md, 2.10
#pragma once

#include "gearwright/curve/curve.hpp"

namespace gearwright {

/// Straight line through a and b,  W(t) = a + t (b − a).
///
/// Domain  a ≠ b (contract)
class StraightLine final : public Curve {
 public:
  StraightLine(const Vec2& a, const Vec2& b);
  Vec2 point(double t) const override;
  CurvePoint at(double t) const override;

 private:
  Vec2 start_, way_;
};

/// Ellipse with its axes along x and y,  W(t) = c + ρ (cos t + i k sin t).
///
/// Laws    (1) for k = 1, the ellipse is a circle about c   (2) the points (x, y/k) lie on the circle
///         about (c_x, c_y/k)
/// Domain  ρ > 0, k > 0 (contract)
class StretchedCircle final : public Curve {
 public:
  StretchedCircle(const Vec2& center, double radius, double stretch);
  Vec2 point(double t) const override;
  /// The tangent angle lies within half a turn of t + π/2, so it is continuous along the curve.
  CurvePoint at(double t) const override;

 private:
  Vec2 center_;
  double radius_, stretch_;
};

}  // namespace gearwright
