#include "gearwright/curve/straight_curves.hpp"

#include <cmath>
#include <numbers>

namespace gearwright {

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
  // dW/dt = ρ (−sin t + i k cos t), divided by the tangent i e^{it} of the circle.
  const double turn = std::atan2((1.0 - k) * s * c, s * s + k * c * c);
  const double speed = std::hypot(s, k * c);
  return {point(t), t + std::numbers::pi / 2 + turn, k / (radius_ * speed * speed * speed)};
}

}  // namespace gearwright
