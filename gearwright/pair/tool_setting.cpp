#include "gearwright/pair/tool_setting.hpp"

#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"

namespace gearwright {

double tool_setting_change(const ArcMeshInput& in, Angle normal_angle, double delta_distance) {
  const double theta = normal_angle.rad();
  GW_EXPECTS(theta > 0.0 && theta < std::numbers::pi / 2);
  const double c0 = in.pitch_radius_convex + in.pitch_radius_concave;
  const double c = in.center_distance + delta_distance;
  // (C0 + w)² + (w cot θ sin λ)² = C²
  const double t = std::sin(in.lead_angle.rad()) / std::tan(theta);
  const double k = 1.0 + t * t;
  const double rest = (c - c0) * (c + c0);
  const double w = rest / (c0 + std::sqrt(c0 * c0 + k * rest));
  const double b = (in.convex.radius - in.concave.radius) * std::sin(theta) + in.concave.b - w;
  return b - in.convex.b;
}

double thickness_change(const WorkingArc& convex, Angle normal_angle, double delta_b) {
  const double theta = normal_angle.rad();
  const double rho = convex.radius;
  const double up = rho * std::sin(theta) + delta_b;  // x + b at the height of the original point
  GW_EXPECTS(std::abs(up) < rho);
  return 2.0 * (std::sqrt((rho - up) * (rho + up)) - rho * std::cos(theta));
}

}  // namespace gearwright
