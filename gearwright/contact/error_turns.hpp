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

struct Crossed {};  ///< the frame N after the rotation Δγ

/// Returns the matrix of a rotation about x, with `along` = 1 and the cosine c and the sine s of
/// the angle. If `along` = 0, c = −sin and s = cos, the result is the derivative of this matrix.
/// intersecting_turn() has the same arguments.
template <class To, class From>
LinearMap<To, From> crossing_turn(double along, double c, double s) {
  Mat3 m;
  m << along, 0, 0, 0, c, s, 0, -s, c;
  return LinearMap<To, From>(m);
}

inline LinearMap<Crossed, Axis1> intersecting_turn(double along, double c, double s) {
  Mat3 m;
  m << c, 0, s, 0, along, 0, -s, 0, c;
  return LinearMap<Crossed, Axis1>(m);
}

/// The tilt of axis 1 by the angles g of crossing and d of intersecting.
inline LinearMap<World, Axis1> tilt(double g, double d) {
  return crossing_turn<World, Crossed>(1, std::cos(g), std::sin(g)) *
         intersecting_turn(1, std::cos(d), std::sin(d));
}

/// `sign` times the derivative of tilt() with respect to g.
inline LinearMap<World, Axis1> tilt_per_crossing(double g, double d, double sign) {
  return crossing_turn<World, Crossed>(0, -sign * std::sin(g), sign * std::cos(g)) *
         intersecting_turn(1, std::cos(d), std::sin(d));
}

/// `sign` times the derivative of tilt() with respect to d.
inline LinearMap<World, Axis1> tilt_per_intersecting(double g, double d, double sign) {
  return crossing_turn<World, Crossed>(1, std::cos(g), std::sin(g)) *
         intersecting_turn(0, -sign * std::sin(d), sign * std::cos(d));
}

/// Rotates directions into the frame of gear 2 at rotation 0. Axis 2 has the direction (0, sin Σ,
/// cos Σ) in the frame N.
inline LinearMap<Axis2, World> shaft_turn(double sigma) {
  return crossing_turn<Axis2, World>(1, std::cos(-sigma), std::sin(-sigma));
}

}  // namespace gearwright::detail
