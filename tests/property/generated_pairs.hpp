// Pairs of gears with few teeth and of gears that are cut by gears: the examples of the program,
// the sets S of tests/oracle/pinion_cutter_cases.hpp, pinions cut by wheels, and internal gears.
//
//   E    generating centre distance, mm. There is no backlash at E. If the gear was cut by its
//        mating gear, there is no clearance either
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/pair.hpp"
#include "tests/oracle/pinion_cutter_cases.hpp"

namespace gearwright::property {

inline constexpr double kPlay = 0.03;  // mm added to E to produce play

struct NamedPair {
  std::string name;
  InvolutePair pair;
};

inline Gear gear_of(const CylindricalSpec& spec) { return testing::taken(make_gear(spec)); }

inline double distance_for(const Gear& cutter, int teeth, double x) {
  const auto e = generating_distance(cutter, teeth, x);
  EXPECT_TRUE(e) << e.error().message();
  return *e;
}

inline Gear gear_cut(const Gear& cutter, int teeth, double e,
                     std::optional<double> tip_diameter = {}) {
  return testing::taken(make_pinion_cut_gear(cutter, {teeth, e, 10.0, tip_diameter}));
}

inline InvolutePair mounted_at(const Gear& one, const Gear& two, double a) {
  return testing::taken(mount_as<ParallelPair>(one, two, {a}));
}

inline CylindricalSpec spec_of(int teeth, double m, double beta_deg, double x) {
  return testing::plain_spec(
      {.teeth = teeth, .module = m, .beta_deg = beta_deg, .x = x, .face_width = 10.0});
}

inline CylindricalSpec filleted(CylindricalSpec s, double offset, TipFilletSpec tip) {
  s.root_fillet = RootFilletSpec{offset};
  s.tip_fillet = tip;
  return s;
}

inline CylindricalSpec with_addendum(CylindricalSpec s, double addendum) {
  s.straight_rack().addendum = addendum;
  return s;
}

inline constexpr auto kByRadius = TipFilletSpec::By::radius;

// The examples of the program.
inline NamedPair two_tooth_drive() {
  CylindricalSpec s = spec_of(2, 1.75, 30, 0.7);
  s.straight_rack().dedendum = 1.0;
  s.straight_rack().root_fillet_radius = 0.0;
  s = filleted(s, 0.01, {kByRadius, 0.332});
  const Gear cutter = gear_of(s);
  s.tip_diameter = 8.16;
  const Gear wheel = gear_cut(cutter, 60, distance_for(cutter, 60, -1.4), 119.665);
  return {"two teeth drive sixty", mounted_at(gear_of(s), wheel, 61.365)};
}

inline NamedPair printed_drive() {
  CylindricalSpec s = filleted(spec_of(3, 2, 30, 0.704), 0.02, {kByRadius, 0.4});
  const Gear cutter = gear_of(with_addendum(s, 1.25));
  s.tip_diameter = 12.279510312;
  const Gear wheel = gear_cut(cutter, 30, distance_for(cutter, 30, 0.376), 74.862413685);
  return {"printed, 3 teeth drive 30", mounted_at(gear_of(s), wheel, 40.20736198828017)};
}

inline NamedPair planetary_ring() {
  CylindricalSpec planet = spec_of(21, 1.5, 20, 0.35);
  planet.thickness_allowance = -0.04;
  CylindricalSpec s = with_addendum(spec_of(25, 1.5, 20, 0), 1.25);
  s.straight_rack().tip_fillet_radius = 0.2;
  const Gear cutter = gear_of(s);
  const Gear ring = gear_cut(cutter, -66, distance_for(cutter, -66, -0.35), 103.4);
  // Because x1 + x2 = 0, this is the reference centre distance.
  const double a = 1.5 * 45 / (2 * std::cos(Angle::degrees(20).rad()));
  return {"planet and ring", mounted_at(gear_of(planet), ring, a)};
}

// The sets S. The wheel is cut by the pinion that drives it.
inline Gear paper_pinion(const oracle::FilletedPinion& n) {
  CylindricalSpec s = spec_of(n.teeth, n.normal_module, n.helix_angle_deg, n.profile_shift);
  s.straight_rack().dedendum = 1.0;
  s.straight_rack().root_fillet_radius = 0.0;
  const double l_F = std::max(0.0, *gear_of(s).involute()->undercut_l);
  return gear_of(filleted(s, n.l_C - l_F, {TipFilletSpec::By::l, n.l_J}));
}

/// Adds the pair at E and at a distance greater by kPlay (for an internal gear: smaller by kPlay).
inline void add_with_play(std::vector<NamedPair>& pairs, const std::string& name, const Gear& one,
                          const Gear& two, double e) {
  pairs.push_back({name, mounted_at(one, two, e)});
  pairs.push_back(
      {name + ", with play", mounted_at(one, two, e + (two.internal() ? -kPlay : kPlay))});
}

inline std::vector<NamedPair> paper_sets() {
  std::vector<NamedPair> pairs;
  for (const auto& c : oracle::pinion_cutter_cases()) {
    const Gear pinion = paper_pinion(c.pinion);
    const double e = c.pinion.center_distance;
    add_with_play(pairs, c.name, pinion, gear_cut(pinion, c.pinion.gear_teeth, e), e);
  }
  return pairs;
}

// The wheel undercuts the pinion with six teeth.
inline std::vector<NamedPair> cut_pinions() {
  std::vector<NamedPair> pairs;
  for (const auto& [teeth, x] : {std::pair{10, 0.4}, std::pair{6, 0.1}}) {
    const Gear wheel = gear_of(with_addendum(spec_of(32, 2, -15, 0.2), 1.25));
    const double e = distance_for(wheel, teeth, x);
    add_with_play(pairs, fmt::format("{} teeth cut by 32", teeth), gear_cut(wheel, teeth, e), wheel,
                  e);
  }
  return pairs;
}

// Internal gears cut by the default cutter and by the pinion itself. One pinion has three teeth.
inline std::vector<NamedPair> rings() {
  std::vector<NamedPair> pairs;
  for (const double beta : {0.0, 20.0}) {
    CylindricalSpec ring = spec_of(-60, 2, beta, -0.3);
    ring.tip_diameter = 120 / std::cos(ring.helix_angle.rad()) - 2.4;
    const auto cut_ring = cut_by_default(gear_of(ring));
    EXPECT_TRUE(cut_ring);
    const Gear pinion = gear_of(spec_of(18, 2, beta, 0.3));
    add_with_play(pairs, fmt::format("ring with its default cutter, {} degrees", beta), pinion,
                  *cut_ring, 42 / std::cos(ring.helix_angle.rad()));
  }
  const Gear pinion = gear_of(with_addendum(spec_of(18, 2, 10, 0.3), 1.2));
  const double e = distance_for(pinion, -47, -0.1);
  add_with_play(pairs, "18 teeth in the ring that they cut", pinion, gear_cut(pinion, -47, e, 91.6),
                e);
  const Gear few = gear_of(filleted(spec_of(3, 2, 30, 0.6), 0.02, {kByRadius, 0.4}));
  const double e_few = distance_for(few, -12, -0.6);
  add_with_play(pairs, "3 teeth in the ring that they cut", few, gear_cut(few, -12, e_few), e_few);
  return pairs;
}

}  // namespace gearwright::property
