#include "gearwright/report/crossed_range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

TEST(CrossedRangePicture, SamplesAreThePairAtItsPlaces) {
  for (const CrossedPair& pair : testing::crossed_pairs()) {
    const auto samples = crossed_samples(pair);
    ASSERT_GT(samples.size(), 100u);
    const Angle here = Angle::radians(pair.mesh.rack.normal_pressure_angle);
    EXPECT_LT(samples.front().place.normal_pressure_angle, here);
    EXPECT_GT(samples.back().place.normal_pressure_angle, here);
    for (std::size_t i = 1; i < samples.size(); ++i) {
      EXPECT_LT(samples[i - 1].place.normal_pressure_angle, samples[i].place.normal_pressure_angle);
    }
    // The sample at the pair's own α_wn has the shaft angle of the pair and its centre distance
    // without backlash.
    const auto s = crossed_sample(pair, here);
    ASSERT_TRUE(s.has_value());
    EXPECT_NEAR(s->place.shaft_angle.rad(), pair.shaft_angle.rad(), 1e-12);
    EXPECT_NEAR(s->place.center_distance, *pair.backlash_free_center_distance, 1e-9);
    ASSERT_TRUE(pair.min_distance.has_value());
    for (const CrossedSample& each : samples)
      EXPECT_GE(each.place.center_distance, pair.min_distance->center_distance - 1e-10);
  }
}

TEST(CrossedRangePicture, ContactRatioIsOneAtTheEndsOfTheRange) {
  const CrossedPair pair = testing::crossed_pair();
  ASSERT_TRUE(pair.contact_ratio_range.has_value());
  const CrossedPlaces& range = *pair.contact_ratio_range;
  for (const CrossedPlace& end : {range.lo, range.hi}) {
    const auto s = crossed_sample(pair, end.normal_pressure_angle);
    ASSERT_TRUE(s.has_value());
    EXPECT_NEAR(s->contact_ratio, 1.0, 1e-9);
  }
  const auto least = crossed_sample(pair, pair.min_distance->normal_pressure_angle);
  EXPECT_NEAR(least->contact_ratio, 1.7309, 1e-4);
}

TEST(CrossedRangePicture, NoRackBeyondTheLimit) {
  const CrossedPair pair = testing::worm_pair();
  const double limit = std::numbers::pi / 2 - pair.input.gears[0].helix_angle;
  EXPECT_TRUE(crossed_sample(pair, Angle::radians(limit - 1e-6)).has_value());
  EXPECT_FALSE(crossed_sample(pair, Angle::radians(limit + 1e-6)).has_value());
  EXPECT_FALSE(crossed_sample(pair, Angle()).has_value());
  EXPECT_LT(crossed_samples(pair).back().place.normal_pressure_angle.rad(), limit);
}

// A spur gear in mesh with a gear with a helix angle of 0.3°. In the limit in which the working
// helix angle of the second gear is 90°, the shaft angle is nearly 90°.
TEST(CrossedRangePicture, NearTheLimitItself) {
  const CrossedPair pair = testing::crossed_sample_pair(
      testing::sample_gear(17, 2, 0.3, 0.6), testing::sample_gear(17, 2, 0, 0.6), 90 - 0.11, 0.0);
  const auto s = crossed_sample(pair, Angle::radians(pair.mesh.rack.normal_pressure_angle));
  ASSERT_TRUE(s.has_value());
  // The samples end at least 1e-8 rad before the limit. There, a changes by r_b per rad.
  EXPECT_NEAR(s->place.center_distance, *pair.backlash_free_center_distance,
              1e-8 * pair.input.gears[0].radius);
  EXPECT_GT(crossed_samples(pair).size(), 100u);
}

TEST(CrossedRangePicture, ApproximationsOfTheExample) {
  const CrossedPair pair = testing::crossed_pair();
  const auto all = approximations(pair);
  ASSERT_EQ(all.size(), 5u);
  // According to the data table of the example, three terms give 18° 42' 13.9", the virtual spur
  // pair gives 18° 43' 15.4", and the corrected virtual spur pair gives 18° 42' 18.6".
  EXPECT_NEAR(all[2].normal_pressure_angle.deg(), 18 + (42 + 13.9 / 60) / 60, 0.05 / 3600);
  EXPECT_NEAR(all[3].normal_pressure_angle.deg(), 18 + (43 + 15.4 / 60) / 60, 0.05 / 3600);
  EXPECT_NEAR(all[4].normal_pressure_angle.deg(), 18 + (42 + 18.6 / 60) / 60, 0.05 / 3600);
  EXPECT_TRUE(
      approximations(
          testing::crossed_sample_pair(
              testing::gear_as_itself(9, 37.4892228898867, 7.263, 47.408, 46.65, 24),
              testing::gear_as_itself(15, 52.6687933717901, 7.618, 36.595, 65.27, 24, 21), 90))
          .empty());
}

}  // namespace
}  // namespace gearwright
