#include "gearwright/pair/shift.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/pair/testing/spur_mesh.hpp"

namespace gearwright {
namespace {

using testing::kAlpha;
using testing::kEps;

ShiftProblem spur_problem(int z1, int z2) {
  ShiftProblem p;
  p.z1 = z1;
  p.z2 = z2;
  p.normal_module = 2.0;
  p.normal_pressure_angle = Angle::radians(kAlpha);
  return p;
}

ShiftSolution solved(const ShiftProblem& p) {
  const auto s = complete_shifts(p);
  EXPECT_TRUE(s) << s.error().message();
  return *s;
}

TEST(Shift, nothing_given_is_the_reference_distance) {
  const ShiftSolution s = solved(spur_problem(17, 43));
  EXPECT_EQ(s.x1, 0.0);
  EXPECT_EQ(s.x2, 0.0);
  EXPECT_EQ(s.center_distance, 60.0);
  EXPECT_EQ(solved(spur_problem(17, -43)).center_distance, 26.0);
}

TEST(Shift, opposite_shifts_leave_the_reference_distance) {
  ShiftProblem p = spur_problem(17, 43);
  p.x1 = 0.375;
  p.x2 = -0.375;
  EXPECT_EQ(solved(p).center_distance, 60.0);
}

// The shift is converted to a and back. dx/da is about 1/m_n. Near the least distance at which the
// flanks can mesh, where α_wt is near 0, α_wt is known only to ε a/N with N = a sin α_wt.
TEST(Shift, centre_distance_and_sum_are_inverse) {
  for (const int z2 : {11, 43, 150, -43, -150}) {
    for (const double sum : {-0.8, -0.1, 1e-6, 0.3, 1.5}) {
      const double inv = nominal_working_involute(11, z2, kAlpha, kAlpha, sum);
      if (inv <= 1e-4) continue;
      const double a = tight_center_distance(11, z2, 2.0, kAlpha, kAlpha, 1.0, sum);
      const double back = tight_shift_sum(11, z2, 2.0, kAlpha, kAlpha, 1.0, a);
      EXPECT_NEAR(back, sum, 200 * kEps * std::abs(11 + z2)) << z2 << " " << sum;
    }
  }
}

TEST(Shift, more_shift_moves_external_axes_apart_and_internal_ones_together) {
  for (const double sum : {0.1, 0.5}) {
    EXPECT_GT(tight_center_distance(17, 43, 2.0, kAlpha, kAlpha, 1.0, sum), 60.0);
    EXPECT_LT(tight_center_distance(17, -43, 2.0, kAlpha, kAlpha, 1.0, sum), 26.0);
    EXPECT_EQ(extended_center_distance(17, 43, 2.0, 1.0, sum), 60.0 + 2.0 * sum);
    EXPECT_EQ(extended_center_distance(17, -43, 2.0, 1.0, sum), 26.0 - 2.0 * sum);
    // Without backlash, the gears are closer together than their racks would be, so the tip
    // clearance is smaller.
    EXPECT_LT(tight_center_distance(17, 43, 2.0, kAlpha, kAlpha, 1.0, sum), 60.0 + 2.0 * sum);
  }
}

TEST(Shift, one_shift_follows_from_the_distance) {
  ShiftProblem p = spur_problem(17, 43);
  p.center_distance = 61.0;
  p.x1 = 0.2;
  const ShiftSolution s = solved(p);
  EXPECT_EQ(s.x1, 0.2);
  EXPECT_EQ(s.center_distance, 61.0);
  EXPECT_NEAR(tight_center_distance(17, 43, 2.0, kAlpha, kAlpha, 1.0, s.x1 + s.x2), 61.0, 1e-12);
  ShiftProblem other = spur_problem(17, 43);
  other.center_distance = 61.0;
  other.x2 = s.x2;
  EXPECT_NEAR(solved(other).x1, 0.2, 1e-15 * 10);
}

// If both shifts are computed, the pinion gets the greater one. The result does not depend on the
// order of the two gears.
TEST(Shift, both_follow_from_the_distance) {
  ShiftProblem p = spur_problem(17, 43);
  p.center_distance = 61.0;
  const ShiftSolution s = solved(p);
  EXPECT_GT(s.x1, s.x2);
  EXPECT_NEAR(s.x1, (0.625 * 43 + (s.x1 + s.x2 - 0.625) * 17) / 60, 1e-14);
  ShiftProblem swapped = spur_problem(43, 17);
  swapped.center_distance = 61.0;
  const ShiftSolution t = solved(swapped);
  EXPECT_NEAR(t.x1 + t.x2, s.x1 + s.x2, 1e-14);
  ShiftProblem ring = spur_problem(17, -43);
  ring.center_distance = 25.8;
  EXPECT_EQ(solved(ring).x2, 0.0);
  EXPECT_GT(solved(ring).x1, 0.0);
}

TEST(Shift, extended_mounting) {
  ShiftProblem p = spur_problem(17, 43);
  p.mounting = Mounting::extended;
  p.x1 = 0.3;
  p.x2 = 0.2;
  EXPECT_EQ(solved(p).center_distance, 61.0);
  ShiftProblem back = spur_problem(17, 43);
  back.mounting = Mounting::extended;
  back.center_distance = 61.0;
  back.x1 = 0.3;
  EXPECT_NEAR(solved(back).x2, 0.2, 1e-15);
}

TEST(Shift, what_has_no_answer_is_named) {
  ShiftProblem close = spur_problem(17, 43);
  close.center_distance = 60 * std::cos(kAlpha) - 0.1;
  const auto a = complete_shifts(close);
  ASSERT_FALSE(a);
  EXPECT_EQ(a.error().field, "pair.center_distance");
  ShiftProblem thin = spur_problem(17, 43);
  thin.x1 = -1.0;
  thin.x2 = -1.0;
  const auto b = complete_shifts(thin);
  ASSERT_FALSE(b);
  EXPECT_EQ(b.error().field, "profile_shift");
  ShiftProblem thick_ring = spur_problem(17, -43);
  thick_ring.x1 = 1.0;
  ASSERT_FALSE(complete_shifts(thick_ring));
  EXPECT_EQ(complete_shifts(thick_ring).error().field, "profile_shift");
  ShiftProblem extended = thin;
  extended.mounting = Mounting::extended;
  extended.x1 = -3.0;
  ASSERT_FALSE(complete_shifts(extended));
  EXPECT_EQ(complete_shifts(extended).error().field, "profile_shift");
}

}  // namespace
}  // namespace gearwright
