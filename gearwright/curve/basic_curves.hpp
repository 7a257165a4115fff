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
#include "gearwright/math/involute.hpp"

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

/// A jet in polar form.
///
/// Domain  a jet with the members factor(), phase() and log_slopes()
template <class Jet>
PolarJet polar_jet(const Jet& jet) {
  const auto [d1, d2] = jet.log_slopes();
  const auto factor = jet.factor();
  return {{factor.x, factor.y}, jet.phase(), {d1.x, d1.y}, {d2.x, d2.y}};
}

namespace jets {

template <class T>
struct AxisCircle {
  T radius, theta;
  Plane<T> point() const { return {radius * cos(theta), radius * sin(theta)}; }
  T polar_angle() const { return theta; }
  T tangent_angle() const { return theta + half_turn<T>() / 2; }
  T curvature() const { return T(1) / radius; }
};

/// Accuracy  ledger rows `involute.point` and `involute.jet`
template <class T>
struct Involute {
  T base_radius, base_half_angle, xi;

  Plane<T> factor() const { return {base_radius, base_radius * xi}; }
  T phase() const { return base_half_angle - xi; }
  Plane<T> point() const {
    const Plane<T> unit = turned({T(1), xi}, phase());
    return {base_radius * unit.x, base_radius * unit.y};
  }
  // This form has no cancellation. The argument of the point would lose digits near ξ = 0.
  T polar_angle() const { return base_half_angle - involute_of_roll(xi); }
  // dW/dξ = r_b ξ e^{i(ψ_b − ξ)}, so the tangent turns clockwise by one radian per radian of roll.
  // Unlike a tangent angle computed from ℓ′, this angle has no rounding at the cusp ξ = 0. For
  // ξ < 0, the direction of growing ξ is opposite to e^{i(ψ_b − ξ)}.
  T tangent_angle() const { return phase() + (xi < T(0) ? half_turn<T>() : T(0)); }
  T curvature() const { return T(-1) / (base_radius * abs(xi)); }
  LogSlopes<T> log_slopes() const {
    const T square = T(1) + xi * xi;
    const Plane<T> inverse{T(1) / square, -xi / square};
    return {{xi / square, -xi * xi / square}, times(inverse, inverse)};
  }
  /// The derivatives θ′ and θ″ of the polar angle with respect to ln |W|. [T8.5]
  T theta1() const { return -xi; }
  T theta2() const { return -(T(1) + xi * xi) / xi; }
};

template <class T>
struct OffsetCircle {
  T distance, direction, radius, t;

  Plane<T> point() const {
    return {distance * cos(direction) + radius * cos(t),
            distance * sin(direction) + radius * sin(t)};
  }
  T polar_angle() const {
    const T x = distance + radius * cos(t - direction);
    return direction + atan2(radius * sin(t - direction), x);
  }
  T tangent_angle() const { return t + half_turn<T>() / 2; }
  T curvature() const { return T(1) / radius; }
};

template <class T>
struct StraightLine {
  Plane<T> start, way;
  T t;
  Plane<T> point() const { return {start.x + t * way.x, start.y + t * way.y}; }
  T tangent_angle() const { return atan2(way.y, way.x); }
  T curvature() const { return T(0); }
};

template <class T>
struct StretchedCircle {
  Plane<T> center;
  T radius, k, t, c, s;  // cos t and sin t

  Plane<T> point() const { return {center.x + radius * c, center.y + radius * (k * s)}; }
  /// The tangent angle lies within half a turn of t + π/2, so it is continuous along the curve.
  T tangent_angle() const {
    // The angle from the tangent i e^{it} of the circle to dW/dt = ρ (−sin t + i k cos t).
    return t + half_turn<T>() / 2 + atan2((T(1) - k) * s * c, s * s + k * c * c);
  }
  T curvature() const {
    const T speed = hypot(s, k * c);
    return k / (radius * speed * speed * speed);
  }
};

}  // namespace jets

/// Circle about the gear axis as a function of the polar angle,  W(θ) = r e^{iθ}. [T1.3]
class AxisCircle final : public JetCurve<AxisCircle> {
 public:
  explicit AxisCircle(double radius) : radius_(radius) {}
  jets::AxisCircle<double> jet(double theta) const { return {radius_, theta}; }
  double radius() const { return radius_; }

 private:
  double radius_;
};

/// The involute flank on the side y > 0 of a tooth that is symmetric about the x axis,
/// W(ξ) = r_b (1 + iξ) e^{i(ψ_b − ξ)}. [T2.4]
///
/// Laws  (1) |W| = r_b √(1 + ξ²)   (2) arg W = ψ_b − (ξ − atan ξ)
///       (3) the radius of curvature is r_b |ξ|
/// Domain  any ξ. The branch ξ > 0 is the flank of an external tooth. The branch ξ < 0, behind the
///         cusp, is the flank of an internal tooth. The half angle of an internal tooth, ψ_b +
///         inv α, grows with the radius
class Involute final : public JetCurve<Involute> {
 public:
  Involute(double base_radius, double base_half_angle)
      : base_radius_(base_radius), base_half_angle_(base_half_angle) {}
  jets::Involute<double> jet(double xi) const { return {base_radius_, base_half_angle_, xi}; }

  double base_radius() const { return base_radius_; }
  double base_half_angle() const { return base_half_angle_; }
  /// |ξ| at the radius ρ; 0 for ρ ≤ r_b.
  double roll_at(double rho) const { return roll_length(rho, base_radius_) / base_radius_; }

  double parameter_at_radius(double rho, double t_lo, double t_hi) const override;
  bool radius_is_closed_form() const override { return true; }

 private:
  double base_radius_;
  double base_half_angle_;
};

/// Circle about a point at the distance D from the gear axis and the polar angle γ,
/// W(t) = D e^{iγ} + r e^{it}. [T6.1]
///
/// Laws  (1) |W|² = D² + r² + 2 D r cos(t − γ), so |W| is least at t = γ ± π and greatest at t = γ
/// Domain  D > 0, r > 0; a range of t must lie in [γ − π, γ] or in [γ, γ + π], so that |W| is
///         monotone
class OffsetCircle final : public JetCurve<OffsetCircle> {
 public:
  OffsetCircle(double distance, double direction, double radius)
      : distance_(distance), direction_(direction), radius_(radius) {}
  jets::OffsetCircle<double> jet(double t) const { return {distance_, direction_, radius_, t}; }
  double parameter_at_radius(double rho, double t_lo, double t_hi) const override;
  bool radius_is_closed_form() const override { return true; }

  double distance() const { return distance_; }
  double direction() const { return direction_; }
  double radius() const { return radius_; }
  /// |t − γ| at the two points where rays from the gear axis are tangent to the circle. At these
  /// points, cos(t − γ) = −r/D, and the polar angle is stationary. None if the axis lies inside or
  /// on the circle.
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
class StraightLine final : public JetCurve<StraightLine> {
 public:
  StraightLine(const Vec2& a, const Vec2& b) : start_(a), way_(b - a) { GW_EXPECTS(a != b); }
  jets::StraightLine<double> jet(double t) const {
    return {{start_.x(), start_.y()}, {way_.x(), way_.y()}, t};
  }

 private:
  Vec2 start_, way_;
};

/// Ellipse with its axes along x and y,  W(t) = c + ρ (cos t + i k sin t).
///
/// Laws    (1) for k = 1, the ellipse is a circle about c   (2) the points (x, y/k) lie on a circle
///         about (c_x, c_y/k)
/// Domain  ρ > 0, k > 0 (contract)
class StretchedCircle final : public JetCurve<StretchedCircle> {
 public:
  StretchedCircle(const Vec2& center, double radius, double stretch)
      : center_(center), radius_(radius), stretch_(stretch) {
    GW_EXPECTS(radius > 0.0 && stretch > 0.0);
  }
  jets::StretchedCircle<double> jet(double t) const {
    return {{center_.x(), center_.y()}, radius_, stretch_, t, std::cos(t), std::sin(t)};
  }

 private:
  Vec2 center_;
  double radius_, stretch_;
};

}  // namespace gearwright
