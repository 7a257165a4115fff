// The bore of a gear's body and its keyway. The bore of an internal gear is the outside of its rim.
//
//   r  bore radius     w, t  keyway width and depth     all mm
//
// The keyway's floor lies at y = r + t, its walls at x = ±w/2. There is no keyway if w = 0.
#pragma once

#include <optional>

#include "gearwright/base/error.hpp"

namespace gearwright {

struct Bore {
  double diameter;            ///< mm
  double keyway_width = 0.0;  ///< mm, 0 without a keyway
  double keyway_depth = 0.0;  ///< mm, into the hub from the bore, along +y of the gear frame

  bool has_keyway() const { return keyway_width > 0.0; }
};

/// Largest distance of the bore's wall from the axis, mm: the keyway's corner, or the circle.
double bore_reach(const Bore& bore);

/// Empty if there is no error; otherwise the key and the allowed range.
///
/// Domain    `room` mm: the radius that the bore and its keyway must not exceed
std::optional<Error> bore_error(const Bore& bore, double room);

/// The cylinders of a gear that limit its bore or its rim.
struct HoleLimits {
  bool internal;                   ///< true if the bore is the rim of an internal gear
  double root;                     ///< mm, the radius of the roots
  std::optional<double> groove{};  ///< mm, the radius of the groove of a double-helical gear
};

/// The error of a bore or a rim with less than `wall` mm to the roots or to the groove. The rim of an
/// internal gear must exist and has no keyway.
std::optional<Error> hole_error(const std::optional<Bore>& bore, const HoleLimits& limits,
                                double wall);

}  // namespace gearwright
