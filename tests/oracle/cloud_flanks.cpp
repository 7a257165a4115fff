// The outlines that the point cloud (point_cloud.hpp) uses: θ(ρ) of a circular arc and of an
// involute.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/oracle/point_cloud.hpp"

namespace gearwright::oracle::tca {

ArcOutline::ArcOutline(const ArcFlank& flank, Real theta_low, Real theta_high) : flank_(flank) {
  constexpr int kNodes = 64;
  for (int i = 0; i <= kNodes; ++i) {
    nodes_.push_back(node(theta_low + (theta_high - theta_low) * i / kNodes));
  }
  if (nodes_.front().rho > nodes_.back().rho) std::reverse(nodes_.begin(), nodes_.end());
  const auto falls = [](const Node& a, const Node& b) { return a.rho >= b.rho; };
  if (std::adjacent_find(nodes_.begin(), nodes_.end(), falls) != nodes_.end()) {
    throw std::invalid_argument("ρ grows along the arc");
  }
}

Real ArcOutline::rho_low() const { return nodes_.front().rho; }
Real ArcOutline::rho_high() const { return nodes_.back().rho; }

ArcOutline::Node ArcOutline::node(Real theta) const {
  const Vector3 r = arc_surface(flank_)(theta, 0).r;
  return {theta, std::hypot(r.x(), r.y())};
}

Real ArcOutline::theta(Real rho) const {
  if (rho < rho_low() - 1e-12L * rho || rho > rho_high() + 1e-12L * rho) {
    throw std::invalid_argument("ρ beyond the ends of the arc");
  }
  const auto above = std::lower_bound(nodes_.begin() + 1, nodes_.end() - 1, rho,
                                      [](const Node& a, Real x) { return a.rho < x; });
  const Node &low = *(above - 1), &high = *above;
  Real theta = low.theta + (high.theta - low.theta) * (rho - low.rho) / (high.rho - low.rho);
  // Newton's method on A² + B² = ρ². Between two of 64 nodes the function is monotone.
  const Real sl = std::sin(flank_.lead_angle), side = flank_.gear == 1 ? 1 : -1;
  for (int i = 0; i < 12; ++i) {
    const Real s = std::sin(theta), c = std::cos(theta);
    const Real a = flank_.rho * s - flank_.b + side * flank_.pitch_radius;
    const Real b = (flank_.rho * c - flank_.b * c / s) * sl;
    const Real slope = a * flank_.rho * c + b * (-flank_.rho * s + flank_.b / (s * s)) * sl;
    const Real size = std::hypot(a, b);
    const Real step = (rho - size) * size / slope;
    theta += step;
    if (std::abs(step) < 1e-11L) break;  // the next step would be below 1e-19
  }
  return theta;
}

Real ArcOutline::operator()(Real rho) const {
  const Real theta = this->theta(rho), s = std::sin(theta), c = std::cos(theta);
  const Real a = flank_.rho * s - flank_.b;
  const Real b = (flank_.rho * c - flank_.b * c / s) * std::sin(flank_.lead_angle);
  const Real lag = -rack_rotation(flank_, theta, 0);
  if (flank_.gear == 1) return std::atan2(-b, flank_.pitch_radius + a) - lag;
  return std::numbers::pi_v<Real> + std::atan2(b, flank_.pitch_radius - a) + lag;
}

CloudFlank cloud_flank(const ArcFlank& flank, Real theta_low, Real theta_high, LeadTurn lead,
                       Real half_face) {
  const ArcOutline outline(flank, theta_low, theta_high);
  const Real turn = (flank.gear == 1 ? 1 : -1) *
                    (rack_rotation(flank, theta_low, 1) - rack_rotation(flank, theta_low, 0));
  return {outline,
          [turn, lead](Real z) { return (turn + lead.twist + lead.crowning * z) * z; },
          outline.rho_low(),
          outline.rho_high(),
          -half_face,
          half_face};
}

CloudFlank cloud_flank(const InvoluteFlank& flank, Real rho_low, Real rho_high, LeadTurn lead,
                       Real half_face) {
  const auto azimuth = [f = flank](Real rho) {
    const Real xi = std::sqrt((rho - f.base_radius) * (rho + f.base_radius)) / f.base_radius;
    return f.center + f.side * (f.half_angle - xi + std::atan(xi));
  };
  const Real turn = flank.turn_per_length;
  return {azimuth,    [turn, lead](Real z) { return (turn + lead.twist + lead.crowning * z) * z; },
          rho_low,    rho_high,
          -half_face, half_face};
}

}  // namespace gearwright::oracle::tca
