#include "gearwright/report/crossed_figures.hpp"

#include <gtest/gtest.h>

#include "gearwright/report/testing/page_text.hpp"
#include "gearwright/report/testing/sample_reports.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

using testing::count_of;

TEST(RangePicture, ThreeCurvesAndTheirMarks) {
  const std::string text = range_figure(testing::crossed_pair());
  EXPECT_EQ(count_of(text, "<path class=\"curve ink\""), 3u);
  EXPECT_EQ(count_of(text, "class=\"band\""), 3u);
  EXPECT_EQ(count_of(text, "mark action-dot"), 3u);
  EXPECT_EQ(count_of(text, "mark ring"), 15u);  // five approximations in three panels
  EXPECT_NE(text.find(">50.0100<"), text.npos);
  EXPECT_NE(text.find(">90.0000<"), text.npos);
  EXPECT_NE(text.find(">1.731<"), text.npos);
  EXPECT_NE(text.find("mounted 18.684°"), text.npos);
  EXPECT_NE(text.find("least distance 18.702°"), text.npos);
}

TEST(RangePicture, IsWellFormedForEveryPair) {
  for (const CrossedPair& pair : testing::crossed_pairs()) {
    const auto facts =
        testing::StrictHtml::read("<!DOCTYPE html>\n<div>" + range_figure(pair) + "</div>");
    for (const std::string& fault : facts.faults) ADD_FAILURE() << fault;
  }
}

// If the tips are so short that the contact ratio is always below 1, nothing is shaded, but the
// curves are still drawn.
TEST(RangePicture, WithoutAnIntervalOfContact) {
  const CrossedPair pair = testing::crossed_sample_pair(
      testing::gear_as_itself(9, 37.4892228898867, 7.263, 47.408, 42.5, 24),
      testing::gear_as_itself(15, 52.6687933717901, 7.618, 36.595, 59.5, 24), 90);
  ASSERT_FALSE(pair.contact_ratio_range.has_value());
  const std::string text = range_figure(pair);
  EXPECT_EQ(count_of(text, "class=\"band\""), 0u);
  EXPECT_EQ(count_of(text, "<path class=\"curve ink\""), 3u);
  EXPECT_NE(text.find("is below 1 everywhere"), text.npos);
}

}  // namespace
}  // namespace gearwright
