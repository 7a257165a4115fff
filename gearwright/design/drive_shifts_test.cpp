// Laws: (1) the least shift is 0 or the first multiple of 1e-4 without undercut; (2) balanced
// shifts lie on the line of [T2.18a], and their sum is 0 or one gear is at its limit; (3) all
// meshes of a stepped set share one centre distance without backlash, and no external gear is
// undercut; (4) a stage outside a band of centre distances gets the nearer end, all other stages
// keep their shifts, and a gear is undercut only if the least shifts give a greater distance.
#include "gearwright/design/drive_shifts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gearwright/drive/drive_geometry.hpp"
#include "gearwright/drive/short_forms.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {
namespace {

using M = SetMember;
constexpr double kRounded = 1e-4;  // shifts are rounded up to multiples of this

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

// Law (4). The trains have two stages, and the band is near the free centre distances.
TEST(DriveShifts, CentreDistancesAreMovedIntoABand) {
  std::mt19937 random(24);
  const auto whole = [&](int lo, int hi) {
    return std::uniform_int_distribution<int>(lo, hi)(random);
  };
  const auto with_shifts = [](DriveGraph graph, const GearShifts& shifts) {
    for (std::size_t g = 0; g < shifts.size(); ++g) graph.gears[g].shift = shifts[g];
    return drive_geometry(graph);
  };
  int raised = 0, reduced = 0, kept = 0, undercut = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double helix_deg = whole(0, 20);
    std::vector<StageSpec> stages(2);
    const int sum = whole(35, 80), more = whole(-1, 1);
    for (StageSpec& stage : stages) {
      const int z1 = whole(10, 17);
      stage.pair.teeth = {z1, sum - z1 + (&stage == &stages[0] ? 0 : more)};
      stage.pair.set_teeth({2.0, Angle::degrees(20), helix_deg, 20.0, {-0.05, -0.05}});
    }
    const auto train = train_of(stages);
    ASSERT_TRUE(train);
    const DriveGraph& graph = train->graph;
    const auto free = shift_trials(graph);
    const DriveGeometry least = with_shifts(graph, free.back());
    const double middle = (*least.distance[0] + *least.distance[1]) / 2 + whole(-1, 1);
    const std::array<double, 2> band{middle - whole(0, 2), middle + whole(0, 2)};
    const auto moved = shift_trials(graph, band);
    if (moved.empty()) {  // the end of the band is less than the sum of the base radii
      EXPECT_LT(band[1], std::max(*least.distance[0], *least.distance[1]));
      continue;
    }
    for (const bool balanced : {true, false}) {
      const GearShifts& own = balanced ? free.front() : free.back();
      const GearShifts& shifts = balanced ? moved.front() : moved.back();
      const DriveGeometry before = with_shifts(graph, own), after = with_shifts(graph, shifts);
      for (std::size_t m = 0; m < 2; ++m) {
        const auto [a, b] = graph.meshes[m].gears;
        const double expected = std::clamp(*before.distance[m], band[0], band[1]);
        EXPECT_NEAR(*after.distance[m], expected, 1e-9);
        if (expected == *before.distance[m]) {
          EXPECT_EQ(shifts[a], own[a]);
          EXPECT_EQ(shifts[b], own[b]);
          ++kept;
        }
        if (expected > *before.distance[m]) ++raised;
        if (expected < *before.distance[m]) ++reduced;
        const bool cut =
            is_undercut(graph.gears[a], *shifts[a]) || is_undercut(graph.gears[b], *shifts[b]);
        undercut += cut ? 1 : 0;
        EXPECT_FALSE(cut && band[1] >= *least.distance[m]);
      }
    }
  }
  EXPECT_GT(std::min({raised, reduced, kept}), 20);
  EXPECT_GT(undercut, 0);
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
