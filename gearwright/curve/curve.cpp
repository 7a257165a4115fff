#include "gearwright/curve/curve.hpp"

#include <cmath>

#include "gearwright/math/root.hpp"

namespace gearwright {

double Curve::polar_angle(double t) const {
  const Vec2 p = point(t);
  return std::atan2(p.y(), p.x());
}

double Curve::parameter_at_radius(double rho, double t_lo, double t_hi) const {
  const auto excess = [&](double t) { return point(t).norm() - rho; };
  if (excess(t_lo) >= 0.0) return t_lo;
  if (excess(t_hi) <= 0.0) return t_hi;
  return t_lo < t_hi ? find_root(excess, t_lo, t_hi).x : find_root(excess, t_hi, t_lo).x;
}

}  // namespace gearwright
