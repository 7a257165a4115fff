// A point on a cutter's edge, rolled into the gear by the law of gearing: the common normal passes
// through the pitch point. It provides points for the tests of the oracle. The oracle itself works
// in the opposite direction, from a point of the gear to the nearest position of the cutter.
//
//   h, u    the point: height over the datum line, distance from the middle of the cutter's tooth
//   τ       normal angle of the edge there: α on the flank, π/2 on the tip land
//   x_a     height over the pitch line, h + x m;      P   half a pitch of the normal section
#pragma once

#include <cmath>
#include <numbers>

#include "tests/oracle/swept_rack.hpp"

namespace gearwright::oracle {

struct EdgePoint {
  double h, u, tau;
};

/// The point of the gear (side y > 0, tooth 0) at which the point of the edge touches.
/// Formula   the pitch-line coordinate at contact is x_a cot τ cos β; docs/theory/03
inline PlanePoint rolled(const RackNumbers& n, EdgePoint e) {
  const double cos_beta = std::cos(n.helix_angle);
  const double r = n.teeth * n.normal_module / (2 * cos_beta);
  const double x_a = e.h + n.profile_shift * n.normal_module;
  const double across = (std::numbers::pi * n.normal_module / 2 - e.u) / cos_beta;
  const double y = x_a / std::tan(e.tau) * cos_beta;
  const double phi = (y - across) / r;
  const double c = std::cos(phi), s = std::sin(phi);
  return {(x_a + r) * c + y * s, y * c - (x_a + r) * s};
}

/// The point of the tip rounding with the normal angle τ. The rounding is tangent to the flank that
/// the protuberance sets off.
inline EdgePoint on_tip_rounding(const RackNumbers& n, double tau) {
  const double m = n.normal_module, a = n.normal_pressure_angle;
  const double rho = n.root_fillet_radius * m;
  const double h = rho - n.dedendum * m;
  const double u =
      std::numbers::pi * m / 4 + h * std::tan(a) + (n.protuberance * m - rho) / std::cos(a);
  return {h - rho * std::sin(tau), u + rho * std::cos(tau), tau};
}

/// The point of the main flank at the height h.
inline EdgePoint on_flank(const RackNumbers& n, double h) {
  const double a = n.normal_pressure_angle;
  return {h, std::numbers::pi * n.normal_module / 4 + h * std::tan(a), a};
}

}  // namespace gearwright::oracle
