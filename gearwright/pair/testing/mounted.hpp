// Makes gears with a face width of 20 mm, gears cut by a pinion cutter, and involute pairs.
#pragma once

#include <optional>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright::testing {

inline CylindricalSpec spec(int teeth, double module, double x = 0.0, double beta_deg = 0.0) {
  return plain_spec(
      {.teeth = teeth, .module = module, .beta_deg = beta_deg, .x = x, .face_width = 20.0});
}

/// Returns the gear that `cutter` cuts. The distance is chosen so that the profile shift is x. The
/// tip diameter is in mm.
inline Gear cut(const Gear& cutter, int teeth, double x, std::optional<double> tip_diameter = {}) {
  const double distance = taken(generating_distance(cutter, teeth, x));
  return taken(make_pinion_cut_gear(cutter, {teeth, distance, 20.0, tip_diameter}));
}

/// Mounts two gears on parallel axes; a in mm.
inline ParallelPair mounted(const Gear& one, const Gear& two, double a) {
  return taken(mount_as<ParallelPair>(one, two, {a}));
}

}  // namespace gearwright::testing
