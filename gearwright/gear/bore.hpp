// The bore of a gear body and its keyway. For an internal gear, the bore is the outside of the rim.
//
//   r  bore radius, mm     w, t  width and depth of the keyway, mm
//
// The floor of the keyway is at y = r + t, and its walls are at x = ±w/2. If w = 0, there is no
// keyway.
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

/// Returns the largest distance from the axis to the edge of the bore, mm. This is the distance to
/// a corner of the keyway, or the bore radius if there is no keyway.
double bore_reach(const Bore& bore);

struct Gear;

/// Returns the bore of the body, or the rim of an internal gear. A rim that is not given is kRim
/// modules thick outside the root circle. Returns none for an external gear without a bore.
std::optional<Bore> body_bore(const Gear& gear);
inline constexpr double kRim = 2.5;

inline double default_rim(double root_diameter, double normal_module) {
  return root_diameter + 2 * kRim * normal_module;
}

/// Least thickness of material between a bore or a rim and the roots or the groove, mm. It is a
/// fifth of the default chord tolerance of a triangulated surface.
inline constexpr double kLeastWall = 1e-3;

/// The cylinders of a gear that limit its bore or its rim.
struct HoleLimits {
  bool internal;                   ///< true if the bore is the rim of an internal gear
  double root;                     ///< mm, the radius of the roots
  std::optional<double> groove{};  ///< mm, the radius of the groove of a double-helical gear
};

/// Returns the error of a bore or rim, or none if it is valid. It is an error if less than
/// kLeastWall of material remains to the roots or to the groove, or if the bore itself is invalid.
/// For an internal gear, an absent rim diameter and a keyway are also errors.
std::optional<Error> hole_error(const std::optional<Bore>& bore, const HoleLimits& limits);

}  // namespace gearwright
