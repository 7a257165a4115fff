#include "gearwright/report/pair_figures.hpp"

#include <gtest/gtest.h>

#include "gearwright/report/testing/page_text.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

using testing::has;
using testing::sample_gear;
using testing::sample_pair;

TEST(CentrodePicture, OnlyWhereTheShiftIsSeen) {
  EXPECT_TRUE(centrodes_are_worth_a_picture(testing::two_and_sixty()));
  EXPECT_TRUE(centrodes_are_worth_a_picture(testing::helical_pair()));
  EXPECT_TRUE(centrodes_are_worth_a_picture(testing::pinion_in_cut_ring()));
  EXPECT_FALSE(centrodes_are_worth_a_picture(testing::undercut_pair()));
  // The first pair has no profile shifts and a larger centre distance. The second pair has profile
  // shifts that add up to zero, so its centre distance is the reference one.
  const ParallelPair apart = sample_pair(sample_gear(20, 2, 0, 0), sample_gear(40, 2, 0, 0), 60.5);
  EXPECT_FALSE(centrodes_are_worth_a_picture(apart));
  const ParallelPair against =
      sample_pair(sample_gear(20, 2, 0, 0.3), sample_gear(40, 2, 0, -0.3), 60);
  EXPECT_FALSE(centrodes_are_worth_a_picture(against));
  EXPECT_EQ(centrode_figures(against), "");
}

TEST(CentrodePicture, SaysWhatHappensToTheReferenceCircles) {
  const std::string closer = centrode_figures(testing::two_and_sixty());
  EXPECT_TRUE(has(closer, "overlap by 1.3074 mm"));
  EXPECT_TRUE(has(closer, "= 62.6425 mm"));
  EXPECT_TRUE(has(closer, "= 61.3351 mm"));
  EXPECT_TRUE(has(centrode_figures(testing::helical_pair()), "are apart by"));
  // The centre distance of this internal pair is smaller than the reference one, so the reference
  // circle of the pinion does not reach the reference circle of the internal gear.
  EXPECT_TRUE(has(centrode_figures(testing::pinion_in_cut_ring()), "are apart by 0.9245 mm"));
}

}  // namespace
}  // namespace gearwright
