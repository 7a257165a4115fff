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

}  // namespace
}  // namespace gearwright
