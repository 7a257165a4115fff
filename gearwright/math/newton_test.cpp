#include "gearwright/math/root.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <limits>

namespace gearwright {
namespace {

Slope<double> cubic(double x) { return {x * x * x - 2, 3 * x * x}; }

TEST(Newton, FindsARootToTheLastBitInFewSteps) {
  const auto root = newton_in_bracket(cubic, 0.0, 10.0, 1.5, true);
  EXPECT_TRUE(root.found());
  EXPECT_NEAR(root.x, std::cbrt(2.0), 4e-16);
  EXPECT_LE(root.iterations, 8);
}

TEST(Newton, StaysInsideWhenTheDerivativeLies) {
  // From 30, a plain Newton step on atan leaves the bracket.
  const auto f = [](double x) { return Slope<double>{std::atan(x), 1 / (1 + x * x)}; };
  const auto root = newton_in_bracket(f, -40.0, 50.0, 30.0, true);
  EXPECT_TRUE(root.found());
  EXPECT_NEAR(root.x, 0.0, 1e-15);
}

TEST(Newton, FallingFunctionsAndInfiniteEnds) {
  const auto f = [](double x) { return Slope<double>{1 / x - 7, -1 / (x * x)}; };
  const auto root = newton_in_bracket(f, 0.0, 1.0, 0.9, false);
  EXPECT_TRUE(root.found());
  EXPECT_NEAR(root.x, 1.0 / 7, 1e-16);
}

TEST(Newton, AZeroDerivativeIsNotTheEnd) {
  const auto f = [](double x) { return Slope<double>{x > 0.3 ? 1.0 : -1.0, 0.0}; };
  const auto root = newton_in_bracket(f, 0.0, 1.0, 0.5, true);
  EXPECT_EQ(root.stop, NewtonStop::bracket);
  EXPECT_NEAR(root.x, 0.3, 1e-15);
}

TEST(Newton, MoreDigitsForAWiderScalar) {
  using Wide = boost::multiprecision::cpp_dec_float_50;
  const auto f = [](const Wide& x) { return Slope<Wide>{x * x - 2, 2 * x}; };
  const auto root = newton_in_bracket<Wide>(f, Wide(0), Wide(2), Wide(1), true);
  EXPECT_TRUE(root.found());
  EXPECT_LT(abs(root.x * root.x - 2), Wide("1e-48"));
}

}  // namespace
}  // namespace gearwright
