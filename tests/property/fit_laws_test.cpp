// Tests laws of fit over seeded problems: each solution is a pair at its minimum centre distance,
// and no solution is lost if the problem is mirrored or its gears are exchanged.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gearwright/design/fit.hpp"
#include "gearwright/pair/pair.hpp"
#include "tests/property/random_spec.hpp"

namespace gearwright::property {
namespace {

// Every solution of fit has no backlash and is mounted at its own minimum centre distance.
TEST(FitLaws, branches_stand_at_their_least_distance) {
  Random random(411);
  int branches = 0;
  for (int i = 0; i < 300; ++i) {
    FitProblem problem;
    problem.teeth = {random.integer(5, 40), random.integer(8, 60)};
    problem.normal_module = random.pick({1.0, 2.5});
    problem.normal_pressure_angle = Angle::radians(20 * std::numbers::pi / 180);
    problem.shaft_angle = Angle::radians(random.uniform(-2.0, 2.0));
    const double least = problem.normal_module *
                         std::pow(std::cbrt(std::pow(problem.teeth[0], 2)) +
                                      std::cbrt(std::pow(problem.teeth[1], 2)),
                                  1.5) /
                         2;
    problem.center_distance = least * random.uniform(0.8, 1.6);
    const int kind = random.integer(0, 3);
    if (kind == 1)
      problem.working_normal_pressure_angle = Angle::radians(random.uniform(0.25, 0.45));
    if (kind == 2) problem.shift = {random.uniform(-0.2, 0.4), random.uniform(-0.2, 0.4)};
    if (kind == 3) problem.helix[0] = Angle::radians(random.uniform(-1.0, 1.0));
    const auto found = fit(problem);
    ASSERT_TRUE(found) << found.error().message();
    EXPECT_EQ(found->branches.empty(), !found->reason.empty());
    for (const FitBranch& b : found->branches) {
      ++branches;
      BasePair<double> g;
      for (int k : {0, 1}) {
        g[k] = base_gear(problem.teeth[k],
                         reference_geometry<double>({problem.teeth[k], problem.normal_module,
                                                     problem.normal_pressure_angle.rad(),
                                                     b.helix[k].rad(), b.shift[k], 0.0}));
      }
      const auto alpha = transverse_angle_at_min_distance(g);
      ASSERT_TRUE(alpha);
      const CrossedPlace place = crossed_place(g, *alpha);
      EXPECT_NEAR(place.center_distance, *problem.center_distance, 1e-10 * place.center_distance);
      EXPECT_NEAR(place.shaft_angle.rad(), problem.shaft_angle->rad(), 1e-9);
      EXPECT_NEAR(place.normal_pressure_angle.rad(), b.working_normal_pressure_angle.rad(), 1e-9);
      if (kind == 2) {
        EXPECT_NEAR(b.shift[0] + b.shift[1], *problem.shift[0] + *problem.shift[1], 1e-12);
      }
      if (kind == 3) {
        EXPECT_NEAR(b.helix[0].rad(), problem.helix[0]->rad(), 1e-12);
      }
    }
  }
  EXPECT_GT(branches, 150);
}

// The mirrored problem, and the one with exchanged gears, must have the same number of solutions.
TEST(FitLaws, branches_mirrored_and_exchanged) {
  Random random(412);
  int branches = 0;
  for (int i = 0; i < 1500; ++i) {
    FitProblem p;
    p.teeth = {random.integer(5, 60), random.integer(5, 80)};
    p.normal_module = random.pick({1.0, 1.5, 2.5});
    p.normal_pressure_angle = Angle::degrees(random.pick({14.5, 20.0, 25.0}));
    p.shaft_angle = Angle::radians(random.chance(0.2) ? 0.0 : random.uniform(-2.5, 2.5));
    p.center_distance =
        0.5 * p.normal_module * (p.teeth[0] + p.teeth[1]) * random.uniform(0.95, 2.5);
    const int kind = random.integer(0, 3);
    if (kind == 1) p.working_normal_pressure_angle = Angle::radians(random.uniform(0.2, 0.5));
    if (kind == 2) p.shift = {random.uniform(-0.2, 0.4), random.uniform(-0.2, 0.4)};
    if (kind == 3) p.helix[1] = Angle::radians(random.uniform(-1.0, 1.0));
    FitProblem mirrored = p;
    mirrored.shaft_angle = -*p.shaft_angle;
    if (kind == 3) mirrored.helix[1] = -*p.helix[1];
    FitProblem exchanged = p;
    std::swap(exchanged.teeth[0], exchanged.teeth[1]);
    std::swap(exchanged.helix[0], exchanged.helix[1]);
    std::swap(exchanged.shift[0], exchanged.shift[1]);
    const auto f = fit(p), m = fit(mirrored), x = fit(exchanged);
    ASSERT_TRUE(f && m && x);
    branches += static_cast<int>(f->branches.size());
    ASSERT_EQ(f->branches.size(), m->branches.size())
        << p.teeth[0] << "/" << p.teeth[1] << " kind " << kind << " a " << *p.center_distance
        << " sigma " << p.shaft_angle->rad();
    ASSERT_EQ(f->branches.size(), x->branches.size())
        << p.teeth[0] << "/" << p.teeth[1] << " kind " << kind << " a " << *p.center_distance
        << " sigma " << p.shaft_angle->rad();
    for (const FitBranch& b : f->branches) {
      const bool seen = std::any_of(m->branches.begin(), m->branches.end(), [&](const auto& c) {
        return abs(b.helix[0] + c.helix[0]) < Angle::radians(1e-7);
      });
      EXPECT_TRUE(seen);
    }
  }
  EXPECT_GT(branches, 1000);
}

}  // namespace
}  // namespace gearwright::property
