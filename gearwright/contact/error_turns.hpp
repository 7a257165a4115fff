// The rotations by which errors of mounting tilt axis 1, and the derivative of each rotation matrix
// with respect to its angle. The angles refer to the frame N, so their signs may differ from Δγ and
// Δδ.
//
//   Δγ   crossing: rotation about x, the centre line, so that axis 1 tilts towards +y
//   Δδ   intersecting: rotation about y, so that axis 1 tilts towards gear 2, +x
//                                    theory: docs/theory/08-contact.md, [T8.12]
#pragma once

#include <cmath>

#include "gearwright/base/vector.hpp"
#include "gearwright/contact/gap_field.hpp"

namespace gearwright::detail {

inline Mat3 crossing_turn(double g) {
  Mat3 m;
  m << 1, 0, 0, 0, std::cos(g), std::sin(g), 0, -std::sin(g), std::cos(g);
  return m;
}

inline Mat3 crossing_turn_slope(double g) {
  Mat3 m;
  m << 0, 0, 0, 0, -std::sin(g), std::cos(g), 0, -std::cos(g), -std::sin(g);
  return m;
}

inline Mat3 intersecting_turn(double d) {
  Mat3 m;
  m << std::cos(d), 0, std::sin(d), 0, 1, 0, -std::sin(d), 0, std::cos(d);
  return m;
}

inline Mat3 intersecting_turn_slope(double d) {
  Mat3 m;
  m << -std::sin(d), 0, std::cos(d), 0, 0, 0, -std::cos(d), 0, -std::sin(d);
  return m;
}

/// The tilt of axis 1 by the angles g of crossing and d of intersecting.
inline LinearMap<World, Axis1> tilt(double g, double d) {
  return LinearMap<World, Axis1>(crossing_turn(g) * intersecting_turn(d));
}

/// `sign` times the derivative of tilt() with respect to g.
inline LinearMap<World, Axis1> tilt_per_crossing(double g, double d, double sign) {
  return LinearMap<World, Axis1>(sign * crossing_turn_slope(g) * intersecting_turn(d));
}

/// `sign` times the derivative of tilt() with respect to d.
inline LinearMap<World, Axis1> tilt_per_intersecting(double g, double d, double sign) {
  return LinearMap<World, Axis1>(sign * crossing_turn(g) * intersecting_turn_slope(d));
}

/// Rotates directions into the frame of gear 2 at rotation 0. Axis 2 has the direction (0, sin Σ,
/// cos Σ) in the frame N.
inline LinearMap<Axis2, World> shaft_turn(double sigma) {
  return LinearMap<Axis2, World>(crossing_turn(-sigma));
}

}  // namespace gearwright::detail
