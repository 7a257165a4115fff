// The solution of the small problem of each step satisfies the conditions for a maximum.
#include "gearwright/contact/feasible_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gearwright::detail {
namespace {

StepProblem box(double lo_s, double hi_s, double lo_z, double hi_z) {
  StepProblem p{};
  p.h_ss = p.h_zz = -1.0;
  p.bounds = {{{-lo_s, 1, 0},
               {hi_s, -1, 0},
               {-lo_z, 0, 1},
               {hi_z, 0, -1},
               {9, 1, 1},
               {9, -1, -1},
               {9, 1, -1},
               {9, -1, 1}}};
  return p;
}

bool allowed(const StepProblem& p, double s, double z, double slack) {
  for (const Bound& b : p.bounds)
    if (b.c + b.a_s * s + b.a_z * z < -slack) return false;
  return true;
}

TEST(FeasibleStep, inside_edge_and_corner) {
  StepProblem p = box(-1, 1, -1, 1);
  p.g_s = 0.5, p.g_z = -0.25;
  FeasibleStep s = solve_step(p, {});
  EXPECT_TRUE(s.active.inside());
  EXPECT_EQ(s.d_s, 0.5);
  EXPECT_EQ(s.d_z, -0.25);
  p.g_s = 3;
  s = solve_step(p, {});
  EXPECT_EQ(s.active, (ActiveSet{1, -1}));
  EXPECT_EQ(s.d_s, 1.0);
  EXPECT_EQ(s.multiplier[0], 2.0);
  p.g_z = -4;
  s = solve_step(p, {});
  EXPECT_EQ(s.active, (ActiveSet{1, 2}));
  EXPECT_EQ(s.d_z, -1.0);
  EXPECT_EQ(s.multiplier[0], 2.0);
  EXPECT_EQ(s.multiplier[1], 3.0);
}

// A wrong initial guess changes the computing time, but not the result.
TEST(FeasibleStep, any_guess_gives_the_same) {
  StepProblem p = box(-1, 0.2, -0.5, 1);
  p.g_s = 1, p.g_z = -0.2, p.h_sz = 0.4;
  const FeasibleStep want = solve_step(p, {});
  for (std::int8_t i = 0; i < 8; ++i) {
    for (std::int8_t k = -1; k < 8; ++k) {
      if (k == i) continue;
      const FeasibleStep got = solve_step(p, {i, k});
      EXPECT_NEAR(got.d_s, want.d_s, 1e-14);
      EXPECT_NEAR(got.d_z, want.d_z, 1e-14);
    }
  }
}

// (1) the step is feasible   (2) slope + Σ μ a = 0 and μ ≥ 0. The objective is concave, so this
// proves a maximum.
TEST(FeasibleStep, random_problems) {
  std::mt19937_64 bits(5);
  const auto unit = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  int kinds[3] = {};
  for (int i = 0; i < 20000; ++i) {
    StepProblem p{};
    const double turn = 3 * unit(), big = -std::pow(10.0, 3 * unit() - 3), c = std::cos(turn),
                 s = std::sin(turn), small = big * std::pow(10.0, -6 * unit());
    p.h_ss = big * c * c + small * s * s, p.h_zz = big * s * s + small * c * c;
    p.h_sz = (big - small) * c * s;
    p.g_s = 2 * unit() - 1, p.g_z = 2 * unit() - 1;
    for (Bound& b : p.bounds) b = {unit(), 2 * unit() - 1, 2 * unit() - 1};
    const FeasibleStep got = solve_step(p, {});
    ASSERT_TRUE(got.feasible);  // d = 0 is feasible
    const double far = 1 + std::hypot(got.d_s, got.d_z);
    EXPECT_TRUE(allowed(p, got.d_s, got.d_z, 1e-12 * far));  // (1)
    double r_s = p.g_s + p.h_ss * got.d_s + p.h_sz * got.d_z;
    double r_z = p.g_z + p.h_sz * got.d_s + p.h_zz * got.d_z;
    const std::int8_t set[] = {got.active.first, got.active.second};
    for (int m : {0, 1}) {
      if (set[m] < 0) continue;
      EXPECT_GE(got.multiplier[m], 0.0);
      r_s += got.multiplier[m] * p.bounds[set[m]].a_s;
      r_z += got.multiplier[m] * p.bounds[set[m]].a_z;
    }
    const double size = far + got.multiplier[0] + got.multiplier[1];
    EXPECT_LT(std::hypot(r_s, r_z), 1e-12 * size);  // (2)
    ++kinds[got.active.inside() ? 0 : got.active.corner() ? 2 : 1];
  }
  for (const int n : kinds) EXPECT_GT(n, 100);
}

TEST(FeasibleStep, says_when_there_is_no_room) {
  StepProblem p = box(-1, 1, -1, 1);
  p.bounds[4] = {-3.5, 1, 0};  // s ≥ 3.5 contradicts s ≤ 1
  const FeasibleStep s = solve_step(p, {});
  EXPECT_FALSE(s.feasible);
  EXPECT_GE(s.d_s, 1.0);  // between the two bounds
  EXPECT_LE(s.d_s, 3.5);
}

}  // namespace
}  // namespace gearwright::detail
