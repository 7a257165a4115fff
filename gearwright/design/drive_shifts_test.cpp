// Laws: (1) the least shift is 0 or the first multiple of 1e-4 without undercut; (2) balanced
// shifts lie on the line of [T2.18a], and their sum is 0 or one gear is at its limit; (3) all
// meshes of a stepped set share one centre distance without backlash, and no external gear is
// undercut.
#include "gearwright/design/drive_shifts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gearwright/drive/drive_geometry.hpp"
#include "gearwright/drive/short_forms.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {
namespace {

using M = SetMember;
constexpr double kRounded = 1e-4;  // to which shifts are rounded up

PlanetarySpec shifted_set(const std::vector<std::pair<M, int>>& teeth, double helix_deg) {
  PlanetarySpec set;
  for (const auto& [member, z] : teeth) set.z(member) = z;
  set.planets = 3;
  set.normal_module = 2.0;
  set.allowance.all = -0.08;
  set.helix_deg.all = helix_deg;
  return set;
}

bool is_undercut(const DriveGear& gear, double x) {
  CylindricalSpec spec = *gear.spec;
  spec.teeth = gear.teeth;
  spec.profile_shift = x;
  const auto made = make_gear(spec);
  EXPECT_TRUE(made);
  return made->undercut;
}

bool is_least(const DriveGear& gear, double x) {
  return !is_undercut(gear, x) && (x == 0.0 || is_undercut(gear, x - kRounded));
}

TEST(DriveShifts, AreTheLeastOrLieOnTheLine) {
  std::mt19937 random(36);
  const auto whole = [&](int lo, int hi) {
    return std::uniform_int_distribution<int>(lo, hi)(random);
  };
  int at_zero = 0, at_limit = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int z1 = whole(8, 40), z2 = whole(8, 60);
    const auto graph = graph_of(shifted_set(
        {{M::sun, z1}, {M::planet, z2}, {M::ring, z1 + 2 * z2 + whole(-1, 1)}}, whole(0, 25)));
    ASSERT_TRUE(graph);
    const auto trials = shift_trials(*graph);
    ASSERT_GE(trials.size(), 1u);
    const GearShifts& balanced = trials.front();
    const GearShifts& least = trials.back();
    for (const std::size_t g : {0, 1}) EXPECT_TRUE(is_least(graph->gears[g], *least[g])) << z1;
    EXPECT_FALSE(least[2] || balanced[2]);  // the ring follows from the centre distance
    const double sum = *balanced[0] + *balanced[1];
    const auto line = divided_shift_sum(z1, z2, sum);
    EXPECT_NEAR(*balanced[0], line[0], kRounded);
    bool limited = false;
    for (const std::size_t g : {0, 1}) {
      EXPECT_FALSE(is_undercut(graph->gears[g], *balanced[g]));
      limited = limited || is_undercut(graph->gears[g], *balanced[g] - kRounded);
    }
    EXPECT_TRUE(limited || sum == 0.0) << z1 << " " << z2 << " " << sum;
    ++(limited ? at_limit : at_zero);
  }
  EXPECT_GT(at_zero, 50);
  EXPECT_GT(at_limit, 50);
}

TEST(DriveShifts, SecondPlanetGearsAreRaised) {
  int raised = 0;
  for (int z2 = 12; z2 <= 20; ++z2)
    for (const int more : {-1, 0, 1}) {
      auto set = graph_of(shifted_set(
          {{M::sun, 14}, {M::planet, 31}, {M::planet2, z2}, {M::ring2, 45 + z2 + more}}, 0.0));
      ASSERT_TRUE(set);
      DriveGraph graph = std::move(set).take();
      for (const GearShifts& shifts : shift_trials(graph)) {
        for (std::size_t g = 0; g < shifts.size(); ++g) graph.gears[g].shift = shifts[g];
        const DriveGeometry made = drive_geometry(graph);
        EXPECT_NEAR(*made.distance[0], *made.distance[1], 1e-12);
        for (std::size_t m = 0; m < 2; ++m) {
          const auto& [a, b] = graph.meshes[m].gears;
          EXPECT_NEAR(tight_center_distance(graph.gears[a].teeth, graph.gears[b].teeth, 2.0,
                                            Angle::degrees(20).rad(), Angle::degrees(20).rad(), 1.0,
                                            *made.shift[a] + *made.shift[b]),
                      *made.distance[m], 1e-9);
          EXPECT_FALSE(made.gears[a]->undercut || made.gears[b]->undercut) << z2;
        }
        raised += shifts[2].has_value() ? 1 : 0;
      }
    }
  EXPECT_GT(raised, 20);
}

}  // namespace
}  // namespace gearwright
