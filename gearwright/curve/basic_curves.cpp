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
  const double c = std::cos(base_half_angle_ - xi);
  const double s = std::sin(base_half_angle_ - xi);
  return {base_radius_ * (c - xi * s), base_radius_ * (s + xi * c)};
}

CurvePoint Involute::at(double xi) const {
  // dW/dξ = r_b ξ e^{i(ψ_b − ξ)}: the tangent turns clockwise, one radian per radian of roll.
  return {point(xi), base_half_angle_ - xi, -1.0 / (base_radius_ * xi)};
}

double Involute::roll_at(double rho) const {
  const double square = (rho - base_radius_) * (rho + base_radius_);
  return std::sqrt(std::max(0.0, square)) / base_radius_;
}

double Involute::polar_angle(double xi) const { return base_half_angle_ - involute_of_roll(xi); }

double Involute::parameter_at_radius(double rho, double t_lo, double t_hi) const {
  return std::clamp(roll_at(rho), std::min(t_lo, t_hi), std::max(t_lo, t_hi));
}

}  // namespace gearwright
