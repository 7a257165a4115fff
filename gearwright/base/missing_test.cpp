#include "gearwright/base/missing.hpp"

#include <gtest/gtest.h>

namespace gearwright {
namespace {

TEST(Missing, OneErrorNamesAll) {
  const Error load{"rating.torque", "", "is missing; give it"};
  const Error speed{"rating.speed", "", "is missing: 1500 for example"};
  const Error grade{"rating.quality", "", "is missing"};
  EXPECT_EQ(all_missing({load}).message(), "rating.torque: is missing; give it");
  EXPECT_EQ(all_missing({load, speed, grade, speed, load}).message(),
            "rating.torque: is missing; give it; also missing: rating.speed (1500 for example), "
            "rating.quality");
  const Error steel{"gear2.material", "", "is missing; give it"};
  EXPECT_EQ(all_missing({load, steel}).message(),
            "rating.torque: is missing; give it; also missing: gear2.material");
}

TEST(Missing, AnotherErrorIsToldAlone) {
  const Error wrong{"gear1.material", "x", "is no material"};
  EXPECT_FALSE(is_missing(wrong));
  EXPECT_EQ(all_missing({{"rating", "", "is missing"}, wrong}).message(), wrong.message());
}

}  // namespace
}  // namespace gearwright
