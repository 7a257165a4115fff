// The curves that occur in all gears: circles about the axis, involutes of the base circle, and
// circular fillets about another point.
//
//   r     radius, mm              W(t)   point as a complex number, mm
//   r_b   base radius, mm         ξ      roll angle, rad; r_b ξ is an arc length on the base circle
//   ψ_b   half angle of the tooth on the base circle, rad
//                                                          theory: docs/theory/01-frames.md
#pragma once

#include <cmath>
#include <complex>
#include <optional>

#include "gearwright/curve/curve.hpp"

namespace gearwright {

// A point of a plane curve in polar coordinates about the gear axis, with derivatives.
//
//   W(t)   point ρ e^{iθ}, mm          ℓ = log W = u + iθ,  u = ln ρ
//   ℓ′, ℓ″ derivatives with respect to the parameter t of the curve
//                                                         theory: docs/theory/08-contact.md, [T8.4]

using Complex = std::complex<double>;

/// The product of two complex numbers without the library's treatment of infinities, which is slow.
inline Complex times(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// A point W = factor · e^{i phase} of a curve. Factor and phase are stored separately, so that the
/// phases of flank, lead and rotation can be added before sine and cosine are computed.
struct PolarJet {
  Complex factor;  ///< mm
  double phase;    ///< rad
  Complex d1, d2;  ///< ℓ′ and ℓ″, the derivatives with respect to t

  /// The jet of the curve itself if side = 1, or of its mirror image about the x axis if side = −1.
  PolarJet on_side(double side) const {
    const auto turned = [side](const Complex& w) { return Complex{w.real(), side * w.imag()}; };
    return {turned(factor), side * phase, turned(d1), turned(d2)};
  }
};

/// A complex number x + iy of any scalar type.
template <class T>
struct Plane {
  T x, y;
};

template <class T>
Plane<T> times(const Plane<T>& a, const Plane<T>& b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

/// A PolarJet of any scalar type, W = scale · unit · e^{i phase}. The scale is a separate factor,
/// so that point_of() can multiply by it after the rotation.
template <class T>
struct CurveJet {
  T scale;
  Plane<T> unit;
  T phase;          ///< rad
  Plane<T> d1, d2;  ///< ℓ′ and ℓ″, the derivatives with respect to t
};

template <class T>
Plane<T> point_of(const CurveJet<T>& j) {
  using std::cos;
  using std::sin;
  const T c = cos(j.phase), s = sin(j.phase);
  return {j.scale * (j.unit.x * c - j.unit.y * s), j.scale * (j.unit.x * s + j.unit.y * c)};
}

inline PolarJet polar(const CurveJet<double>& j) {
  return {{j.scale * j.unit.x, j.scale * j.unit.y}, j.phase, {j.d1.x, j.d1.y}, {j.d2.x, j.d2.y}};
}

/// Circle about the gear axis as a function of the polar angle,  W(θ) = r e^{iθ}. [T1.3]
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

/// The jet of an involute, W(ξ) = r_b (1 + iξ) e^{i(ψ_b − ξ)}. [T2.4]
///
/// Accuracy  ledger rows `involute.point` and `involute.jet`
template <class T>
CurveJet<T> involute_jet(const T& base_radius, const T& base_half_angle, const T& xi) {
  const T square = T(1) + xi * xi;
  const Plane<T> inverse{T(1) / square, -xi / square};
  return {base_radius,
          {T(1), xi},
          base_half_angle - xi,
          {xi / square, -xi * xi / square},
          times(inverse, inverse)};
}

/// The involute flank on the side y > 0 of a tooth that is symmetric about the x axis,
/// W(ξ) = r_b (1 + iξ) e^{i(ψ_b − ξ)}. [T2.4]
///
/// Laws  (1) |W| = r_b √(1 + ξ²)   (2) arg W = ψ_b − (ξ − atan ξ)
///       (3) the radius of curvature is r_b |ξ|
/// Domain  any ξ. The branch ξ > 0 is the flank of an external tooth. The branch ξ < 0, behind the
///         cusp, is the flank of an internal tooth. The half angle of an internal tooth, ψ_b +
///         inv α, grows with the radius
class Involute final : public Curve {
 public:
  Involute(double base_radius, double base_half_angle)
      : base_radius_(base_radius), base_half_angle_(base_half_angle) {}
  Vec2 point(double xi) const override;
  CurvePoint at(double xi) const override;
  PolarJet polar_jet(double xi) const;

  double base_radius() const { return base_radius_; }
  double base_half_angle() const { return base_half_angle_; }
  /// |ξ| at the radius ρ; 0 for ρ ≤ r_b.
  double roll_at(double rho) const;

  double polar_angle(double xi) const override;
  double parameter_at_radius(double rho, double t_lo, double t_hi) const override;
  bool radius_is_closed_form() const override { return true; }

 private:
  double base_radius_;
  double base_half_angle_;
};

// This function is inline, because the inner loop of contact/ calls it.
inline PolarJet Involute::polar_jet(double xi) const {
  return polar(involute_jet(base_radius_, base_half_angle_, xi));
}

/// Circle about a point at the distance D from the gear axis and the polar angle γ,
/// W(t) = D e^{iγ} + r e^{it}. [T6.1]
///
/// Laws  (1) |W|² = D² + r² + 2 D r cos(t − γ), so |W| is least at t = γ ± π and greatest at t = γ
/// Domain  D > 0, r > 0; a range of t must lie on one side of γ, so that |W| is monotone
class OffsetCircle final : public Curve {
 public:
  OffsetCircle(double distance, double direction, double radius)
      : distance_(distance), direction_(direction), radius_(radius) {}
  Vec2 point(double t) const override;
  CurvePoint at(double t) const override;
  double polar_angle(double t) const override;
  double parameter_at_radius(double rho, double t_lo, double t_hi) const override;
  bool radius_is_closed_form() const override { return true; }

  double distance() const { return distance_; }
  double direction() const { return direction_; }
  double radius() const { return radius_; }
  /// |t − γ| of the two points at which a ray from the gear axis is tangent to the circle. There,
  /// cos(t − γ) = −r/D, and the polar angle is stationary. None if the axis lies inside or on the
  /// circle.
  std::optional<double> tangent_ray() const;

 private:
  double distance_, direction_, radius_;
};

// The curves of a rack in a plane section: straight lines, and circles of the normal section, which
// are ellipses in the transverse section.
//
//   W(t)  point as a complex number x + iy, mm      ρ  radius in the normal section, mm
//   k     stretch along y, 1/cos β            theory: docs/theory/02-involute-and-pair.md, 2.10

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
/// Laws    (1) for k = 1, the ellipse is a circle about c   (2) the points (x, y/k) lie on a circle
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
