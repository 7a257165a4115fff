// Seeded pairs that can mesh: common module, pressure angle and |β|, matching hands, and usual
// shifts.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "gearwright/pair/pair.hpp"
#include "tests/property/random_spec.hpp"

namespace gearwright::property {

struct SpecPair {
  CylindricalSpec first, second;
};

inline SpecPair random_pair(Random& random, bool internal) {
  SpecPair pair;
  CylindricalSpec& a = pair.first;
  a.normal_module =
      random.chance(0.5) ? random.pick({1.0, 2.0, 4.0}) : random.logarithmic(0.2, 10.0);
  a.normal_pressure_angle = Angle::degrees(
      random.chance(0.7) ? random.pick({14.5, 20.0, 20.0, 25.0}) : random.uniform(12.0, 28.0));
  if (random.chance(0.6)) a.helix_angle = Angle::degrees(random.uniform(-45.0, 45.0));
  static constexpr const char* kNames[] = {"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D"};
  a.rack = *iso53_rack(kNames[random.integer(0, 3)]);
  a.face_width = a.normal_module * random.uniform(2.0, 20.0);
  CylindricalSpec& b = pair.second;
  b = a;
  a.teeth = random.integer(8, 60);
  b.teeth = internal ? -(a.teeth + random.integer(4, 120)) : random.integer(8, 150);
  if (!internal) b.helix_angle = -a.helix_angle;
  a.profile_shift = random.uniform(-0.3, 0.8);
  b.profile_shift = random.uniform(-0.3, 0.6);
  if (random.chance(0.3)) a.thickness_allowance = -0.02 * a.normal_module * random.unit();
  if (random.chance(0.3)) b.thickness_allowance = -0.02 * b.normal_module * random.unit();
  return pair;
}

/// Mounts both gears at the distance `a`, or at the backlash-free distance if `a` is absent.
/// Returns nothing if this is impossible.
inline std::optional<ParallelPair> mounted(const SpecPair& specs,
                                           std::optional<double> a = std::nullopt) {
  auto g1 = make_gear(specs.first);
  auto g2 = make_gear(specs.second);
  if (!g1 || !g2 || !g1->exists() || !g2->exists()) return std::nullopt;
  if (!a) {
    const double far = 2 * (std::abs(specs.first.teeth) + std::abs(specs.second.teeth)) *
                       specs.first.normal_module / std::cos(specs.first.helix_angle.rad());
    const auto anywhere = mount_as<ParallelPair>(*g1, *g2, {far});
    if (!anywhere || !anywhere->backlash_free_center_distance) return std::nullopt;
    a = *anywhere->backlash_free_center_distance;
  }
  auto pair = mount_as<ParallelPair>(std::move(g1).take(), std::move(g2).take(), {*a});
  if (!pair) return std::nullopt;
  return std::move(pair).take();
}

inline std::string describe(const SpecPair& specs) {
  return "\n  gear1: " + describe(specs.first) + "\n  gear2: " + describe(specs.second);
}

}  // namespace gearwright::property
