#include "gearwright/math/root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

TEST(Root, closes_its_bracket_on_a_simple_root) {
  const Root root = find_root([](double x) { return std::cos(x) - x; }, 0.0, 1.0);
  EXPECT_TRUE(root.found());
  EXPECT_NEAR(root.x, 0.73908513321516064166, 4 * std::numeric_limits<double>::epsilon());
  EXPECT_LE(std::abs(root.residual), 4 * std::numeric_limits<double>::epsilon());
}

// TOMS 748 needs 6 to 9 evaluations for a smooth root, in addition to those of both ends.
// Root::evaluations may exceed the calls of f, because it also counts values that are stored.
TEST(Root, work_on_smooth_functions) {
  int calls = 0;
  const Root root = find_root([&](double x) { return ++calls, std::exp(x) - 2.0; }, 0.0, 1.0);
  EXPECT_TRUE(root.found());
  EXPECT_LE(calls, 12);
  EXPECT_GE(root.evaluations, calls - 4);
  EXPECT_LE(root.evaluations, calls + 4);
}

TEST(Root, an_end_that_is_the_root) {
  const Root lo = find_root([](double x) { return x; }, 0.0, 1.0);
  EXPECT_EQ(lo.stop, RootStop::exact);
  EXPECT_EQ(lo.x, 0.0);
  EXPECT_EQ(lo.evaluations, 1);
  const Root hi = find_root([](double x) { return x - 1.0; }, 0.0, 1.0);
  EXPECT_EQ(hi.stop, RootStop::exact);
  EXPECT_EQ(hi.x, 1.0);
  EXPECT_EQ(hi.evaluations, 2);
}

TEST(Root, without_a_bracket_it_solves_nothing_and_says_so) {
  const Root root = find_root([](double x) { return x * x + 1.0; }, -1.0, 0.5);
  EXPECT_EQ(root.stop, RootStop::no_bracket);
  EXPECT_FALSE(root.found());
  EXPECT_EQ(root.x, 0.5);
  EXPECT_EQ(root.residual, 1.25);
}

// The function is flat at the root, so the bracket closes where rounding determines the sign.
TEST(Root, a_triple_root_ends_all_the_same) {
  const Root root = find_root([](double x) { return (x - 0.3) * (x - 0.3) * (x - 0.3); }, 0.0, 1.0);
  EXPECT_TRUE(root.found());
  EXPECT_NEAR(root.x, 0.3, 1e-9);
  EXPECT_LE(root.evaluations, 260);
}

// Without the final bisection, TOMS 748 would cycle here, two ulp from an end of its bracket.
TEST(Root, closes_the_last_ulps_by_halving) {
  const double sigma = std::acos(-1.0) / 4;
  int found = 0;
  for (int k = 0; k < 200; ++k) {
    const double t = 45.0 + 0.1 * k;
    const auto h = [&](double b) { return 12 / std::cos(b) + 24 / std::cos(sigma - b) - t; };
    for (const auto& [lo, hi] : {std::pair{-0.78, 0.55}, std::pair{0.55, 1.569}}) {
      if (std::signbit(h(lo)) == std::signbit(h(hi))) continue;
      const Root root = find_root(h, lo, hi);
      EXPECT_TRUE(root.found()) << t;
      EXPECT_LE(root.evaluations, 30);
      ++found;
    }
  }
  EXPECT_GT(found, 200);
}

TEST(Root, a_step_is_bracketed_to_two_ulp) {
  const Root root = find_root([](double x) { return x < 0.7 ? -1.0 : 1.0; }, 0.0, 1.0);
  EXPECT_EQ(root.stop, RootStop::bracket);
  EXPECT_NEAR(root.x, 0.7, 4 * std::numeric_limits<double>::epsilon());
}

TEST(RootDeathTest, the_interval_runs_upward) {
  GW_EXPECT_VIOLATION(find_root([](double x) { return x; }, 1.0, 0.0));
}

}  // namespace
}  // namespace gearwright
