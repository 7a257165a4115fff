#include "gearwright/pair/partners.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gearwright {
namespace {

using namespace literals;

CylindricalSpec spec(int teeth, Angle beta, double module = 2.0) {
  CylindricalSpec s = testing::plain_spec({.teeth = teeth, .module = module, .face_width = 20.0});
  s.helix_angle = beta;
  s.rack = *iso53_rack("ISO53-A");
  return s;
}

std::string refused(const CylindricalSpec& a, const CylindricalSpec& b,
                    std::optional<Angle> sigma = std::nullopt) {
  const auto error = check_partners(a, b, sigma);
  return error ? error->message() : std::string();
}

bool has(const std::string& text, const char* word) { return text.find(word) != std::string::npos; }

TEST(Partners, crossed_axes_need_an_angle_within_reach) {
  EXPECT_EQ(refused(spec(20, 45_deg), spec(30, 45_deg)), "");
  EXPECT_EQ(refused(spec(20, 45_deg), spec(30, 45_deg), 90_deg), "");
  EXPECT_TRUE(
      has(refused(spec(20, 45_deg), spec(30, 45_deg), 60_deg), "outside the possible range by"));
  EXPECT_TRUE(has(refused(spec(20, 45_deg), spec(30, 45_deg), -90_deg), "two left-hand gears"));
  EXPECT_EQ(refused(spec(20, -45_deg), spec(30, -45_deg), -90_deg), "");
  EXPECT_TRUE(has(refused(spec(20, 45_deg), spec(30, -45_deg), 90_deg), "parallel"));
  EXPECT_TRUE(has(refused(spec(20, 45_deg), spec(30, 45_deg), 0_deg), "-45"));
  // At the end of a range no gears exist. The message gives a helix angle that permits this shaft
  // angle.
  const std::string end = refused(spec(20, 30_deg), spec(40, 0_deg), 90_deg);
  EXPECT_TRUE(has(end, "is the end of the possible range") && !has(end, " by 0°")) << end;
  EXPECT_TRUE(has(end, "the helix angle 60° of gear 2")) << end;
  EXPECT_EQ(refused(spec(20, 30_deg), spec(40, 60_deg), 90_deg), "");
  // A spur gear meshes with a helical gear at a shaft angle equal to its helix angle.
  EXPECT_EQ(refused(spec(20, 0_deg), spec(30, 30_deg), 30_deg), "");
  EXPECT_TRUE(has(refused(spec(20, 0_deg), spec(30, 0_deg), 30_deg), "must be 0"));
}

TEST(Partners, unequal_base_pitches_say_what_would_fit) {
  const std::string why = refused(spec(20, 0_deg), spec(30, 0_deg, 2.1));
  EXPECT_TRUE(has(why, "gear2.normal_module = 2.1"));
  EXPECT_TRUE(has(why, "0.29521")) << why;  // the difference, 0.1 π cos 20°
  EXPECT_TRUE(has(why, "2\u00a0mm at its pressure angle")) << why;
}

TEST(Partners, rings_run_on_parallel_axes) {
  EXPECT_EQ(refused(spec(20, 15_deg), spec(-60, 15_deg)), "");
  EXPECT_TRUE(has(refused(spec(20, 15_deg), spec(-60, 20_deg)), "same hand"));
  EXPECT_TRUE(has(refused(spec(20, 15_deg), spec(-60, 15_deg), 10_deg), "must be 0"));
  EXPECT_TRUE(has(refused(spec(-60, 15_deg), spec(20, 15_deg)), "exchange"));
  EXPECT_TRUE(has(refused(spec(-60, 15_deg), spec(-20, 15_deg)),
                  "gear1.teeth = -60: both gears are internal"));
}

TEST(CompletePlace, takes_the_least_distance_where_nothing_is_said) {
  const auto gears = nominal_base_pair(spec(20, 45_deg), spec(30, 45_deg));
  const auto place = complete_place(gears, std::nullopt, std::nullopt);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->shaft_angle->rad(), (90_deg).rad(), 1e-14);
  EXPECT_NEAR(place->center_distance, 50 / std::cos((45_deg).rad()), 1e-12);
  EXPECT_EQ(complete_place(gears, 80.0, std::nullopt)->center_distance, 80.0);
  auto thin = spec(20, 45_deg);
  thin.profile_shift = -3.0;
  const auto none =
      complete_place(nominal_base_pair(thin, spec(30, 45_deg)), std::nullopt, std::nullopt);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().field, "pair.shaft_angle");
  EXPECT_TRUE(has(none.error().message(), "too thin by"));
}

}  // namespace
}  // namespace gearwright
