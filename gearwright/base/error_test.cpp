// Values in errors have as many digits as a user needs, or as many as distinguish a value from its
// limit.
#include "gearwright/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gearwright/base/testing/named_limit.hpp"

namespace gearwright {
namespace {

TEST(Error, has_one_shape) {
  EXPECT_EQ((Error{"rack.dedendum", "9", "is too deep"}).message(),
            "rack.dedendum = 9: is too deep");
  EXPECT_EQ((Error{"gear2", "", "is missing"}).message(), "gear2: is missing");
  EXPECT_EQ((Error{"", "", "line 3: a comma"}).message(), "line 3: a comma");
  EXPECT_EQ((Error{"rack.dedendum", "9", "is too deep"}).quoted(),
            "`rack.dedendum` = 9: is too deep");
}

TEST(Error, of_a_part_is_one_of_the_whole) {
  EXPECT_EQ(within("gear1", {"rack.dedendum", "9", "no"}).field, "gear1.rack.dedendum");
  EXPECT_EQ(within("gear1", {"", "", "no"}).field, "gear1");
  const Error e = following_from("pair.center_distance", "30", "it requires",
                                 {"gear1.profile_shift", "-3", "the tooth is severed"});
  EXPECT_EQ(e.message(),
            "pair.center_distance = 30: it requires `gear1.profile_shift` = -3: the tooth is "
            "severed");
}

TEST(Spoken, has_six_digits_or_as_many_as_it_takes) {
  EXPECT_EQ(format_number(20.0), "20");
  EXPECT_EQ(format_number(29.999821636830927), "29.9998");
  EXPECT_EQ(format_number(20.000000000000004), "20");
  EXPECT_EQ(format_number(60.0000001, 60.0), "60.0000001");
  EXPECT_EQ(format_number(60.0, 60.0000001), "60");
  EXPECT_EQ(format_number(1.0, 2.0), "1");
  EXPECT_EQ(format_number(2e6), "2000000");
  EXPECT_EQ(format_number(5e-324), "5e-324");
  EXPECT_EQ(format_number(0.1 + 0.2, 0.3), "0.30000000000000004");
}

TEST(Refused, tells_a_value_from_its_limits) {
  EXPECT_EQ(refused("a", 70.0, {1.0, 60.0}, "must lie between {} and {}").message(),
            "a = 70: must lie between 1 and 60");
  EXPECT_EQ(refused("a", 60.0000001, {1.0, 60.0}, "must lie between {} and {}").message(),
            "a = 60.0000001: must lie between 1 and 60");
  EXPECT_EQ(refused("a", 7.0, {}, "no").message(), "a = 7: no");
  EXPECT_EQ(refused("teeth", 0, "must not be 0").message(), "teeth = 0: must not be 0");
}

// A value that the message names as allowed is allowed.
TEST(Refused, does_not_round_a_limit_past_itself) {
  const double limit = 57.74956291590773;
  EXPECT_EQ(refused("a", 50.0, {limit}, "at least {}").rule, "at least 57.7496");
  EXPECT_EQ(refused("a", 60.0, {limit}, "at most {}").rule, "at most 57.7495");
  EXPECT_EQ(refused("a", 60.0, {limit, limit + 1e-3}, "{} to {}").rule, "57.7496 to 57.7505");
  EXPECT_EQ(refused("a", 1.0, {0.001}, "at most {}").rule, "at most 0.001");
  EXPECT_EQ(refused("a", -1.0, {-limit}, "at most {}").rule, "at most -57.7496");
  EXPECT_EQ(refused("a", -60.0, {-limit}, "at least {}").rule, "at least -57.7495");
  EXPECT_EQ(refused("a", 1.0, {0.0}, "at most {}").rule, "at most 0");
  EXPECT_EQ(refused("a", 1.0, {std::numeric_limits<double>::infinity()}, "{}").rule, "inf");
  EXPECT_EQ(refused("a", -1.0, {5e-324}, "at least {}").rule, "at least 5e-324");
  EXPECT_EQ(refused("a", std::nan(""), {1.0, 60.0}, "{} to {}").message(), "a = nan: 1 to 60");
  for (const double sharp : {57.74956291590773, 0.3320007, 1.0 / 3, 1e-7 / 3, 12345.678901}) {
    const auto below = [&](double x) {
      return x <= sharp ? std::string() : refused("a", x, {sharp}, "at most {}").message();
    };
    EXPECT_NEAR(named_limit(below, 1e6, "at most "), sharp, 1e-11 * sharp);
    const auto above = [&](double x) {
      return x >= sharp ? std::string() : refused("a", x, {sharp}, "at least {}").message();
    };
    EXPECT_NEAR(named_limit(above, -1.0, "at least "), sharp, 1e-11 * sharp);
  }
}

}  // namespace
}  // namespace gearwright
