// Seeded pinion cutters, both realistic and unrealistic, and the gears that they cut.
//
//   z_0, x_0   of the cutter          E   generating centre distance, mm
//
// The shift of the gear is drawn, and E follows from it. In other cases, E is drawn independently,
// so that positions other than the backlash-free one are included.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "gearwright/gear/pinion_cut.hpp"
#include "tests/property/random_spec.hpp"

namespace gearwright::oracle {

using property::Random;

/// A rack without protuberance: a named rack, or one with sharp or rounded tips. Some racks have a
/// rounding, a ramp or a land at the bottom.
inline StraightRack random_cutter_rack(Random& random, Angle alpha) {
  if (random.chance(0.35)) {
    static constexpr const char* kNames[] = {"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D"};
    return *iso53_rack(kNames[random.integer(0, 3)]);
  }
  StraightRack rack;
  rack.dedendum = random.pick({1.0, 1.25, 1.4});
  const double full = std::max(0.0, full_radius(rack, alpha));
  switch (random.integer(0, 3)) {
    case 0: rack.root_fillet_radius = 0.0; break;
    case 1: rack.root_fillet_radius = full; break;
    default: rack.root_fillet_radius = random.uniform(0.0, std::min(full, 0.45)); break;
  }
  switch (random.integer(0, 5)) {
    case 0:
    case 1: rack.tip_fillet_radius = random.uniform(0.02, 0.35); break;
    case 2:
      rack.tool_addendum = random.uniform(0.6, 0.95);
      rack.semi_topping_angle = Angle::degrees(random.uniform(alpha.deg() + 5, 70.0));
      break;
    case 3: rack.tool_addendum = random.uniform(0.7, 1.0); break;
    default: break;
  }
  return rack;
}

inline CylindricalSpec random_cutter(Random& random) {
  CylindricalSpec spec;
  spec.teeth = random.chance(0.35) ? random.integer(1, 8) : random.integer(1, 40);
  spec.normal_module = random.uniform(1.0, 3.0);
  spec.normal_pressure_angle = Angle::degrees(random.pick({14.5, 20.0, 20.0, 20.0, 25.0, 30.0}));
  if (random.chance(0.5)) spec.helix_angle = Angle::degrees(random.uniform(-60.0, 60.0));
  spec.profile_shift = random.chance(0.2) ? 0.0 : random.uniform(-0.6, 1.0);
  spec.face_width = 10.0;
  spec.rack = random_cutter_rack(random, spec.normal_pressure_angle);
  const double m = spec.normal_module;
  if (random.chance(0.3)) {
    spec.root_fillet = RootFilletSpec{random.chance(0.3) ? 0.0 : random.uniform(0.001, 0.4) * m};
  }
  if (random.chance(0.3)) {
    spec.tip_fillet = TipFilletSpec{TipFilletSpec::By::radius, random.uniform(0.02, 0.45) * m};
  } else if (random.chance(0.25)) {
    const double r = spec.teeth / (2 * std::cos(spec.helix_angle.rad()));
    spec.tip_diameter = 2 * m * (r + spec.profile_shift + random.uniform(0.3, 1.6));
  }
  return spec;
}

/// Returns true if the swept pinion supports this cutter. Two kinds have points whose rounding
/// error exceeds the tolerance for smoothness: a root fillet that is almost straight, whose radius
/// is inaccurate, and the involute of a ramp that is almost perpendicular to the teeth, whose base
/// circle is very small.
inline bool smooth_to_the_oracle(const Gear& cutter) {
  constexpr double kMaxRadius = 50.0;  // mm
  constexpr double kMaxRamp = 85.0;    // degrees
  const auto& fillet = cutter.tooth->root_fillet;
  const auto& ramp = cutter.spec.straight_rack().semi_topping_angle;
  return !(fillet && fillet->radius > kMaxRadius) && !(ramp && ramp->deg() > kMaxRamp);
}

/// Returns nothing if the drawn shift is impossible.
inline std::optional<PinionCutSpec> random_cut(Random& random, const Gear& cutter) {
  const int z_0 = cutter.spec.teeth;
  const double m = cutter.spec.normal_module;
  PinionCutSpec gear;
  gear.face_width = 10.0;
  const bool ring = random.chance(0.5);
  if (!ring) {
    gear.teeth = random.integer(5, 120);
  } else {
    gear.teeth =
        random.chance(0.5) ? -random.integer(z_0 + 3, z_0 + 16) : -random.integer(z_0 + 3, 150);
  }
  const auto tight = generating_distance(cutter, gear.teeth, random.uniform(-1.0, 1.2));
  if (!tight) return std::nullopt;
  gear.distance = *tight;
  if (random.chance(0.5)) gear.distance += m * random.uniform(-0.3, 0.5);
  if (random.chance(0.65)) {
    const double side = ring ? -1.0 : 1.0;
    const double root = gear.distance - side * cutter.tooth->tip_radius;
    gear.tip_diameter = 2 * (root + side * m * random.uniform(0.6, 2.8));
  }
  return gear;
}

inline std::string describe(const PinionCutSpec& gear) {
  std::string text = fmt::format("cut: teeth = {}, distance = {}", gear.teeth, gear.distance);
  if (gear.tip_diameter) text += fmt::format(", tip_diameter_mm = {}", *gear.tip_diameter);
  return text;
}

}  // namespace gearwright::oracle
