// Seeded pairs on crossed axes, with any hands, independent racks, and shifts and helix angles of
// every size.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/pair/pair.hpp"
#include "tests/property/random_spec.hpp"

namespace gearwright::property {

struct CrossedSpecs {
  CylindricalSpec first, second;
  Angle shaft_angle;  ///< Σ
};

/// Gears with a common base pitch. The sum of their reference helix angles differs from 0 by at
/// least `least` degrees. `racks`: if true, the racks have two pressure angles. Σ is drawn from the
/// middle of its range.
inline CrossedSpecs random_crossed(Random& random, double least, bool racks = true) {
  for (;;) {
    CrossedSpecs s;
    CylindricalSpec& a = s.first;
    a.normal_module = random.pick({1.0, 2.0, 3.0});
    a.normal_pressure_angle = Angle::degrees(random.pick({14.5, 20.0, 20.0, 25.0}));
    a.teeth = random.integer(5, 50);
    a.helix_angle = Angle::degrees(random.uniform(-60.0, 60.0));
    a.face_width = 40.0 * a.normal_module;
    a.rack = *iso53_rack("ISO53-A");
    a.profile_shift = random.uniform(-0.1, 0.6);
    CylindricalSpec& b = s.second;
    b = a;
    if (racks && random.chance(0.3)) b.normal_pressure_angle = Angle::degrees(22.5);
    b.normal_module = a.normal_module * std::cos(a.normal_pressure_angle.rad()) /
                      std::cos(b.normal_pressure_angle.rad());
    b.teeth = random.integer(8, 70);
    b.helix_angle = Angle::degrees(random.uniform(-60.0, 60.0));
    b.profile_shift = random.uniform(-0.1, 0.6);
    const BasePair<double> gears = nominal_base_pair(a, b);
    const auto range = shaft_angle_range(gears);
    if (std::abs(range.from) < least * std::numbers::pi / 180) continue;
    const auto alpha = transverse_angle_at_min_distance(gears);
    if (!alpha) continue;
    const double middle = crossed_place(gears, *alpha).shaft_angle.rad();
    s.shaft_angle = Angle::radians(middle + random.uniform(-0.3, 0.3) * (middle - range.from));
    return s;
  }
}

/// A pinion and an internal gear with one rack, whose reference helix angles differ by 2° to 25°. Σ
/// is drawn near the value of the minimum distance, at which the line of action passes near the
/// middle of the faces.
inline CrossedSpecs random_crossed_internal(Random& random, int least_more = 14,
                                            int most_more = 70) {
  for (;;) {
    CrossedSpecs s;
    CylindricalSpec& a = s.first;
    a.normal_module = random.pick({1.0, 2.0, 3.0});
    a.normal_pressure_angle = Angle::degrees(random.pick({20.0, 20.0, 25.0}));
    a.teeth = random.integer(12, 40);
    a.helix_angle = Angle::degrees(random.chance(0.15) ? 0.0 : random.uniform(-35.0, 35.0));
    a.face_width = a.normal_module * random.uniform(4.0, 10.0);
    a.rack = *iso53_rack("ISO53-A");
    a.profile_shift = random.uniform(-0.1, 0.5);
    CylindricalSpec& b = s.second;
    b = a;
    b.teeth = -(a.teeth + random.integer(least_more, most_more));
    const double apart = random.uniform(2.0, 25.0) * (random.chance(0.5) ? 1.0 : -1.0);
    b.helix_angle = Angle::degrees(random.chance(0.15) ? 0.0 : a.helix_angle.deg() + apart);
    b.face_width = a.face_width * random.uniform(0.7, 1.3);
    b.profile_shift = -a.profile_shift + random.uniform(-0.15, 0.15);
    const BasePair<double> gears = nominal_base_pair(a, b);
    const auto range = shaft_angle_range(gears);
    if (std::abs(range.from) < 1.5 * std::numbers::pi / 180) continue;
    const auto alpha = transverse_angle_at_min_distance(gears);
    if (!alpha) continue;
    const double middle = crossed_place(gears, *alpha).shaft_angle.rad();
    s.shaft_angle = Angle::radians(middle + random.uniform(-0.02, 0.02) * (middle - range.from));
    return s;
  }
}

/// Mounts the gears with the distance of the pitch planes increased by `play` mm over the
/// backlash-free one. Returns nothing if a gear is impossible.
inline std::optional<CrossedPair> mounted(const CrossedSpecs& s, double play = 0.0) {
  auto g1 = make_gear(s.first);
  auto g2 = make_gear(s.second);
  if (!g1 || !g2 || !g1->exists() || !g2->exists()) return std::nullopt;
  const auto tight =
      complete_place(nominal_base_pair(s.first, s.second), std::nullopt, s.shaft_angle);
  if (!tight) return std::nullopt;
  auto pair = mount_as<CrossedPair>(
      std::move(g1).take(), std::move(g2).take(),
      {tight->center_distance + side_of(s.second.teeth) * play, tight->shaft_angle, 0.05});
  if (!pair) return std::nullopt;
  return std::move(pair).take();
}

/// A random internal pair on crossed axes, whose ring is cut by its default cutter. Returns nothing
/// if the flanks do not meet.
inline std::optional<CrossedPair> crossed_pair_with_ring(Random& random, double play,
                                                         CrossedSpecs& specs) {
  specs = random_crossed_internal(random);
  const auto plain = mounted(specs, play);
  if (!plain || !plain->flanks_meet()) return std::nullopt;
  const auto ring = cut_by_default(plain->gears[1]);
  if (!ring || !ring->root_form_radius() || !plain->gears[0].root_form_radius())
    return std::nullopt;
  auto pair = mount_as<CrossedPair>(plain->gears[0], *ring,
                                    {plain->center_distance, plain->shaft_angle, {}});
  if (!pair) return std::nullopt;
  return std::move(pair).take();
}

inline std::string describe(const CrossedSpecs& s) {
  return fmt::format("\n  gear1: {}\n  gear2: {}\n  shaft angle {} rad", describe(s.first),
                     describe(s.second), s.shaft_angle.rad());
}

}  // namespace gearwright::property
