// The bore of a gear's body and its keyway.
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

}  // namespace gearwright
