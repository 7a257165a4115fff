#include "gearwright/curve/basic_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/math/involute.hpp"

namespace gearwright {

Vec2 AxisCircle::point(double theta) const {
  return {radius_ * std::cos(theta), radius_ * std::sin(theta)};
}

CurvePoint AxisCircle::at(double theta) const {
  return {point(theta), theta + std::numbers::pi / 2, 1.0 / radius_};
}

Vec2 Involute::point(double xi) const {
  const auto [x, y] = point_of(involute_jet(base_radius_, base_half_angle_, xi));
  return {x, y};
}

CurvePoint Involute::at(double xi) const {
  // dW/dξ = r_b ξ e^{i(ψ_b − ξ)}, so the tangent turns clockwise by one radian per radian of roll.
  // Unlike a tangent angle computed from the jet, this angle has no rounding at the cusp ξ = 0.
  // For ξ < 0, the direction of growing ξ is opposite to e^{i(ψ_b − ξ)}.
  const double back = xi < 0.0 ? std::numbers::pi : 0.0;
  return {point(xi), base_half_angle_ - xi + back, -1.0 / (base_radius_ * std::abs(xi))};
}

double Involute::roll_at(double rho) const { return roll_length(rho, base_radius_) / base_radius_; }

// This formula has no cancellation. The argument of the complex point would lose digits near ξ = 0.
double Involute::polar_angle(double xi) const { return base_half_angle_ - involute_of_roll(xi); }

double Involute::parameter_at_radius(double rho, double t_lo, double t_hi) const {
  const double xi = t_lo + t_hi < 0.0 ? -roll_at(rho) : roll_at(rho);
  return std::clamp(xi, std::min(t_lo, t_hi), std::max(t_lo, t_hi));
}

Vec2 OffsetCircle::point(double t) const {
  return {distance_ * std::cos(direction_) + radius_ * std::cos(t),
          distance_ * std::sin(direction_) + radius_ * std::sin(t)};
}

CurvePoint OffsetCircle::at(double t) const {
  return {point(t), t + std::numbers::pi / 2, 1.0 / radius_};
}

double OffsetCircle::polar_angle(double t) const {
  const double x = distance_ + radius_ * std::cos(t - direction_);
  return direction_ + std::atan2(radius_ * std::sin(t - direction_), x);
}

double OffsetCircle::parameter_at_radius(double rho, double t_lo, double t_hi) const {
  const double lo = std::min(t_lo, t_hi);
  const double hi = std::max(t_lo, t_hi);
  const double c =
      (rho * rho - distance_ * distance_ - radius_ * radius_) / (2.0 * distance_ * radius_);
  const double angle = std::acos(std::clamp(c, -1.0, 1.0));
  const double side = 0.5 * (lo + hi) < direction_ ? -1.0 : 1.0;
  return std::clamp(direction_ + side * angle, lo, hi);
}

std::optional<double> OffsetCircle::tangent_ray() const {
  if (!(radius_ < distance_)) return std::nullopt;
  return std::acos(-radius_ / distance_);
}

StraightLine::StraightLine(const Vec2& a, const Vec2& b) : start_(a), way_(b - a) {
  GW_EXPECTS(a != b);
}

Vec2 StraightLine::point(double t) const { return start_ + t * way_; }

CurvePoint StraightLine::at(double t) const {
  return {point(t), std::atan2(way_.y(), way_.x()), 0.0};
}

StretchedCircle::StretchedCircle(const Vec2& center, double radius, double stretch)
    : center_(center), radius_(radius), stretch_(stretch) {
  GW_EXPECTS(radius > 0.0 && stretch > 0.0);
}

Vec2 StretchedCircle::point(double t) const {
  return center_ + radius_ * Vec2(std::cos(t), stretch_ * std::sin(t));
}

CurvePoint StretchedCircle::at(double t) const {
  const double c = std::cos(t), s = std::sin(t), k = stretch_;
  // The angle from the tangent i e^{it} of the circle to dW/dt = ρ (−sin t + i k cos t).
  const double turn = std::atan2((1.0 - k) * s * c, s * s + k * c * c);
  const double speed = std::hypot(s, k * c);
  return {point(t), t + std::numbers::pi / 2 + turn, k / (radius_ * speed * speed * speed)};
}

}  // namespace gearwright
