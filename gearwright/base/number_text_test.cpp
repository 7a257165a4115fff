#include "gearwright/base/number_text.hpp"

#include <gtest/gtest.h>

namespace gearwright {
namespace {

TEST(NumberText, FixedDecimalsNeverSayMinusZero) {
  EXPECT_EQ(fixed_decimals(-0.00004, 4), "0.0000");
  EXPECT_EQ(fixed_decimals(-0.00006, 4), "-0.0001");
  EXPECT_EQ(fixed_decimals(-0.5, 0), "0");
  EXPECT_EQ(fixed_decimals(-10.0, 0), "-10");
  EXPECT_EQ(fixed_decimals(2.0, 3), "2.000");
}

TEST(NumberText, ShortDecimalsHaveNoZerosAtTheirEnd) {
  EXPECT_EQ(short_decimals(1.5, 4), "1.5");
  EXPECT_EQ(short_decimals(100.0, 4), "100");
  EXPECT_EQ(short_decimals(100.0, 0), "100");
  EXPECT_EQ(short_decimals(-1e-9, 4), "0");
  EXPECT_EQ(short_decimals(-0.0001, 4), "-0.0001");
}

TEST(NumberText, LimitsAreRoundedToTheSafeSide) {
  EXPECT_EQ(fixed_decimals(rounded_up(0.11831, 3), 3), "0.119");
  EXPECT_EQ(fixed_decimals(rounded_down(36.24999, 3), 3), "36.249");
  EXPECT_EQ(rounded_up(-0.1239, 3), -0.123);
  EXPECT_EQ(rounded_up(0.118, 3), 0.118);  // 0.118 · 1000 is not a whole number in double
  EXPECT_EQ(rounded_down(0.29, 2), 0.29);  // 0.29 · 100 is less than 29
  EXPECT_EQ(rounded_up(1.0 + 1e-9, 3), 1.001);
}

TEST(NumberText, RoughCountsHaveNoExponentBelowAMillion) {
  EXPECT_EQ(rough_count(1020.4), "1020");
  EXPECT_EQ(rough_count(123456.0), "123000");
  EXPECT_EQ(rough_count(12.34), "12.3");
  EXPECT_EQ(rough_count(2.5e10), "2.5e+10");
}

}  // namespace
}  // namespace gearwright
