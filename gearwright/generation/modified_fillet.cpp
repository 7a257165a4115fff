#include "gearwright/generation/modified_fillet.hpp"

#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/newton.hpp"

namespace gearwright {

namespace {

constexpr double kHalfPi = std::numbers::pi / 2;

}  // namespace

std::optional<FilletArc> root_fillet_at(const Involute& flank, int teeth, double xi) {
  GW_EXPECTS(teeth >= 1 && xi >= 0.0);
  const double r_b = flank.base_radius();
  const double u = xi + std::numbers::pi / teeth - flank.base_half_angle();
  if (!(u > -kHalfPi && u < kHalfPi)) return std::nullopt;
  const double radius = r_b * (std::tan(u) - xi);
  if (!(radius > 0.0)) return std::nullopt;
  // D − r_r = r_b (1/cos u − tan u + ξ), the difference as tan((π/2 − u)/2).
  const double end = r_b * (std::tan((kHalfPi - u) / 2) + xi);
  return FilletArc{radius, r_b / std::cos(u), kHalfPi - u, end};
}

std::optional<FilletArc> tip_fillet_at(const Involute& flank, double xi) {
  GW_EXPECTS(xi >= 0.0);
  const double r_b = flank.base_radius();
  const double delta = flank.base_half_angle() - xi;
  if (!(delta > -kHalfPi && delta < kHalfPi)) return std::nullopt;
  const double radius = r_b * (xi + std::tan(delta));
  if (!(radius > 0.0)) return std::nullopt;
  const double distance = r_b / std::cos(delta);
  return FilletArc{radius, distance, kHalfPi + delta, distance + radius};
}

std::optional<double> roll_of_tip_fillet(const Involute& flank, double radius) {
  GW_EXPECTS(radius > 0.0);
  const double r_b = flank.base_radius();
  const double psi_b = flank.base_half_angle();
  const auto f = [&](double xi) {
    const double t = std::tan(psi_b - xi);
    return Slope<double>{r_b * (xi + t) - radius, -r_b * t * t};
  };
  const double lo = std::max(0.0, psi_b - kHalfPi);
  const double hi = psi_b + kHalfPi;
  if (psi_b < kHalfPi && f(0.0).value < 0.0) return std::nullopt;
  const auto root = newton_in_bracket(f, lo, hi, 0.5 * (lo + hi), false);
  GW_ENSURES(root.found());
  return root.x;
}

}  // namespace gearwright
