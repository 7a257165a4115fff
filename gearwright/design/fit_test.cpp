#include "gearwright/design/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/numbers.hpp"

namespace gearwright {
namespace {

using namespace literals;

using testing::kDegree;

FitProblem problem(int z1, int z2) {
  FitProblem p;
  p.teeth = {z1, z2};
  p.normal_module = 1.5;
  p.normal_pressure_angle = 20_deg;
  return p;
}

FitProblem known(double beta_1, double beta_2) {
  FitProblem p = problem(12, 24);
  p.helix = {Angle::degrees(beta_1), Angle::degrees(beta_2)};
  p.shift = {0.0, 0.0};
  return p;
}

TEST(Fit, two_branches_at_ninety_degrees) {
  FitProblem p = problem(12, 24);
  p.center_distance = 40.0;
  p.shaft_angle = 90_deg;
  const auto f = fit(p);
  ASSERT_TRUE(f);
  ASSERT_EQ(f->branches.size(), 2u);
  EXPECT_NEAR(f->branches[0].helix[0].deg(), 39.412532328293, 1e-10);
  EXPECT_NEAR(f->branches[1].helix[0].deg(), 62.947616771370, 1e-10);
  EXPECT_EQ(f->branches[0].shift[0], 0.0);
  EXPECT_TRUE(f->reason.empty());
}

TEST(Fit, none_has_a_reason_and_a_neighbour) {
  FitProblem p = problem(13, 26);
  p.center_distance = 40.0;
  p.shaft_angle = 90_deg;
  const auto f = fit(p);
  ASSERT_TRUE(f);
  EXPECT_TRUE(f->branches.empty());
  const double least = 0.75 * std::pow(std::cbrt(169.0) + std::cbrt(676.0), 1.5);
  EXPECT_NEAR(*f->nearest_distance, least, 1e-12);
  // The nearest shaft angle is a limit. At this centre distance, the gears fit just below it, but
  // not just above it.
  p.shaft_angle = *f->nearest_shaft_angle - Angle::radians(1e-9);
  EXPECT_FALSE(fit(p)->branches.empty());
  p.shaft_angle = *f->nearest_shaft_angle + Angle::radians(1e-6);
  EXPECT_TRUE(fit(p)->branches.empty());
  // At this centre distance, even gears on parallel axes do not fit.
  p.center_distance = 25.0;
  p.shaft_angle = 30_deg;
  const auto none = fit(p);
  EXPECT_TRUE(none->branches.empty());
  EXPECT_FALSE(none->nearest_shaft_angle);
}

TEST(Fit, known_gears_take_their_places) {
  const auto least = fit(known(45, 45));
  ASSERT_TRUE(least);
  ASSERT_EQ(least->branches.size(), 1u);
  EXPECT_NEAR(least->branches[0].shaft_angle.rad(), 90 * kDegree, 1e-12);
  FitProblem p = known(45, 45);
  p.center_distance = least->branches[0].center_distance + 0.05;
  ASSERT_EQ(fit(p)->branches.size(), 2u);
  p.center_distance = least->branches[0].center_distance - 0.05;
  const auto none = fit(p);
  EXPECT_TRUE(none->branches.empty());
  EXPECT_NEAR(*none->nearest_distance, least->branches[0].center_distance, 1e-12);
  p.center_distance.reset();
  p.shaft_angle = 91_deg;
  const double a = fit(p)->branches.at(0).center_distance;
  EXPECT_GT(a, least->branches[0].center_distance);
  p.center_distance = a;
  EXPECT_EQ(fit(p)->branches.size(), 1u);
  p.center_distance = a + 0.01;
  EXPECT_TRUE(fit(p)->branches.empty());
  FitProblem q = known(45, 45);
  q.working_normal_pressure_angle = 20_deg;
  EXPECT_NEAR(fit(q)->branches.at(0).center_distance, least->branches[0].center_distance, 1e-12);
}

TEST(Fit, parallel_axes_come_out_of_it) {
  FitProblem p = problem(17, 43);
  p.center_distance = 47.0;
  p.shaft_angle = 0_deg;
  const auto f = fit(p);
  ASSERT_EQ(f->branches.size(), 2u);  // right and left hand
  EXPECT_NEAR(std::cos(f->branches[0].helix[0].rad()), 1.5 * 60 / 94, 1e-14);
  EXPECT_NEAR(f->branches[0].helix[0].rad(), -f->branches[0].helix[1].rad(), 1e-15);
  FitProblem ring = problem(17, -60);
  ring.center_distance = 33.0;
  ring.shaft_angle = 0_deg;
  const auto r = fit(ring);
  ASSERT_EQ(r->branches.size(), 2u);
  EXPECT_NEAR(std::cos(r->branches[0].helix[0].rad()), 1.5 * 43 / 66, 1e-13);
  EXPECT_NEAR(r->branches[0].helix[0].rad(), r->branches[0].helix[1].rad(), 1e-15);
  ring.shaft_angle = Angle::radians(0.1);
  EXPECT_EQ(fit(ring).error().field, "pair.shaft_angle");
  // With known helices, the shifts are computed.
  FitProblem s = problem(17, 43);
  s.helix = {0_deg, 0_deg};
  s.center_distance = 46.0;
  EXPECT_NEAR(fit(s)->branches.at(0).center_distance, 46.0, 0);
  EXPECT_GT(fit(s)->branches.at(0).shift[0] + fit(s)->branches.at(0).shift[1], 0.5);
}

// If the helix angles and the centre distance are given but the shaft angle is not, the result is
// the shaft angle and the shifts for which the given centre distance is the least possible one.
TEST(Fit, an_absent_angle_is_that_of_the_least_distance) {
  FitProblem p = problem(12, 24);
  p.helix = {45_deg, 45_deg};
  p.center_distance = 38.4;
  const auto f = fit(p);
  ASSERT_TRUE(f && f->branches.size() == 1u);
  FitProblem back = p;
  back.center_distance.reset();
  back.shift = {f->branches[0].shift[0], f->branches[0].shift[1]};
  const auto least = fit(back);
  ASSERT_TRUE(least && least->branches.size() == 1u);
  EXPECT_NEAR(least->branches[0].center_distance, 38.4, 1e-11);
  EXPECT_NEAR(least->branches[0].shaft_angle.rad(), f->branches[0].shaft_angle.rad(), 1e-12);
  p.center_distance = 30.0;
  EXPECT_FALSE(fit(p)->reason.empty());
  p.center_distance = 38.4;
  p.working_normal_pressure_angle = Angle::radians(0.3);
  EXPECT_EQ(fit(p).error().field, "fit.working_normal_pressure_angle");
}

TEST(Fit, too_much_or_too_little_is_named) {
  FitProblem p = problem(12, 24);
  EXPECT_EQ(fit(p).error().field, "pair.center_distance");
  p.center_distance = 40.0;
  EXPECT_EQ(fit(p).error().field, "pair.shaft_angle");
  p.shaft_angle = Angle::radians(1.5);
  p.helix[0] = Angle::radians(0.7);
  p.shift = {0.0, 0.0};
  EXPECT_EQ(fit(p).error().field, "gear1.helix_angle");
  p.shift[1].reset();
  p.working_normal_pressure_angle = Angle::radians(0.3);
  EXPECT_EQ(fit(p).error().field, "fit.working_normal_pressure_angle");
  FitProblem q = problem(12, 24);
  q.helix = {Angle::radians(0.7), Angle::radians(0.7)};
  EXPECT_EQ(fit(q).error().field, "pair.center_distance");
  q.center_distance = 40.0;
  q.shaft_angle = Angle::radians(0.1);
  EXPECT_EQ(fit(q).error().field, "pair.shaft_angle");
}

}  // namespace
}  // namespace gearwright
