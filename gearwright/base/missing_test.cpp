#include "gearwright/base/error.hpp"

#include <gtest/gtest.h>

namespace gearwright {
namespace {

TEST(Missing, OneErrorNamesAll) {
  const Error load = absent_input("rating.torque", "; give it");
  const Error speed = absent_input("rating.speed", ": 1500 for example");
  const Error grade = absent_input("rating.quality");
  EXPECT_EQ(all_missing({load}).message(), "rating.torque: is missing; give it");
  EXPECT_EQ(all_missing({load, speed, grade, speed, load}).message(),
            "rating.torque: is missing; give it; also missing: rating.speed (1500 for example), "
            "rating.quality");
  const Error steel = absent_input("gear2.material", "; give it");
  EXPECT_EQ(all_missing({load, steel}).message(),
            "rating.torque: is missing; give it; also missing: gear2.material");
}

TEST(Missing, AnotherErrorIsToldAlone) {
  const Error wrong{"gear1.material", "x", "is no material"};
  EXPECT_EQ(all_missing({absent_input("rating"), wrong}).message(), wrong.message());
}

}  // namespace
}  // namespace gearwright
