#include "gearwright/curve/basic_curves.hpp"

#include <algorithm>
#include <cmath>

namespace gearwright {

double Involute::parameter_at_radius(double rho, double t_lo, double t_hi) const {
  const double xi = t_lo + t_hi < 0.0 ? -roll_at(rho) : roll_at(rho);
  return std::clamp(xi, std::min(t_lo, t_hi), std::max(t_lo, t_hi));
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

}  // namespace gearwright
