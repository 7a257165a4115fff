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

std::string_view to_string(ArcName name) {
  switch (name) {
    case ArcName::root_land: return "root_land";
    case ArcName::root_fillet: return "root_fillet";
    case ArcName::flank: return "flank";
    case ArcName::tip_fillet: return "tip_fillet";
    case ArcName::tip_land: return "tip_land";
  }
  contract_failed("postcondition", "known arc name", __FILE__, __LINE__);
}

}  // namespace gearwright
