#include "gearwright/report/crossed_figures.hpp"

#include <gtest/gtest.h>

#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

TEST(MinDistancePicture, ExactAndApproximateOfTheExample) {
  const std::string table = min_distance_table(testing::crossed_pair());
  // The exact values are 18° 42' 8.0", 90° 0' 45.8" and 50.0100 mm. The series of three terms
  // deviates by 5.9".
  EXPECT_NE(table.find(">18.70222<"), table.npos);
  EXPECT_NE(table.find(">90.01272<"), table.npos);
  EXPECT_NE(table.find(">5.9<"), table.npos);
  EXPECT_NE(min_distance_figure(testing::crossed_pair()).find("id=\"least\""), std::string::npos);
}

TEST(MinDistancePicture, NothingToCompare) {
  // If the shifts add up to 0, every approximation gives the pressure angle of the racks.
  const CrossedPair zero = testing::crossed_sample_pair(testing::sample_gear(20, 2, 45, 0.2),
                                                        testing::sample_gear(30, 2, 45, -0.2), 90);
  EXPECT_EQ(min_distance_figure(zero), "");
  EXPECT_NE(min_distance_table(zero).find("add up to zero"), std::string::npos);
  // The series does not exist for gears with different racks.
  const CrossedPair two = testing::crossed_sample_pair(
      testing::gear_as_itself(9, 37.4892228898867, 7.263, 47.408, 46.65, 24),
      testing::gear_as_itself(15, 52.6687933717901, 7.618, 36.595, 65.27, 24, 21), 90);
  EXPECT_EQ(min_distance_figure(two), "");
  EXPECT_EQ(min_distance_table(two), "");
}

}  // namespace
}  // namespace gearwright
