#include "gearwright/figure/free_labels.hpp"

#include <gtest/gtest.h>

#include <string>

namespace gearwright {
namespace {

constexpr PixelBox kSheetBox{0, 0, 400, 200};
using If = FreeLabels::If;

struct Drawing {
  Svg svg{"x", 400, 200, "t", "d"};
  FreeLabels labels{kSheetBox};
  bool draw(const std::vector<LabelPlace>& places, If when) {
    return labels.draw(svg, "word", "word", "", places, when);
  }
};

const LabelPlace kLeft{{100, 100}, {-10, 0}, Anchor::end};
const LabelPlace kRight{{100, 100}, {10, 0}, Anchor::start};

TEST(FreeLabels, TheFirstFreePlaceIsTaken) {
  Drawing d;
  EXPECT_TRUE(d.draw({kLeft, kRight}, If::free));
  EXPECT_NE(d.svg.str().find("class=\" e\" x=\"-10\""), std::string::npos);
  EXPECT_TRUE(d.draw({kLeft, kRight}, If::free));
  EXPECT_NE(d.svg.str().find("x=\"10\""), std::string::npos);
  EXPECT_FALSE(d.draw({kLeft, kRight}, If::free));
  EXPECT_FALSE(d.draw({kLeft, kRight}, If::over_a_line));
  EXPECT_TRUE(d.draw({kLeft, kRight}, If::always));
}

TEST(FreeLabels, LinesAreInTheWayButMayBeCrossed) {
  Drawing d;
  d.labels.keep_off(std::vector<Vec2>{{120, 0}, {120, 50}, {120, 200}});
  EXPECT_FALSE(d.draw({kRight}, If::free));
  EXPECT_TRUE(d.draw({kRight, kLeft}, If::free));  // the position on the left is free
  EXPECT_TRUE(d.draw({kRight}, If::over_a_line));
  Drawing two;
  for (const double x : {120.0, 125.0}) two.labels.keep_off(std::vector<Vec2>{{x, 0}, {x, 200}});
  EXPECT_FALSE(two.draw({kRight}, If::over_a_line));
  Drawing beside;  // The line ends before the words or runs above them.
  beside.labels.keep_off(std::vector<Vec2>{{120, 0}, {120, 85}});
  beside.labels.keep_off(std::vector<Vec2>{{0, 60}, {400, 88}});
  EXPECT_TRUE(beside.draw({kRight}, If::free));
}

TEST(FreeLabels, NoLabelLeavesThePage) {
  Drawing d;
  EXPECT_FALSE(d.draw({{{399, 100}, {0, 0}, Anchor::start}}, If::over_a_line));
  EXPECT_FALSE(d.draw({{{100, 3}, {0, 0}, Anchor::start}}, If::over_a_line));
  EXPECT_FALSE(d.draw({}, If::always));
}

TEST(FreeLabels, PlacesAroundADotBeginWhereItIsWanted) {
  const auto right = places_around({0, 0}, 10, {1, 0});
  EXPECT_EQ(right.size(), 8u);
  EXPECT_EQ(right.front().anchor, Anchor::start);
  EXPECT_EQ(right.front().offset, Vec2(10, 0));
  EXPECT_EQ(right.back().offset, Vec2(-10, 0));
  EXPECT_LT(places_around({0, 0}, 10, {0, -1}).front().offset.y(), 0.0);
}

TEST(Leaders, LeaveTheCircleAtTheEdgeOrBefore) {
  const Vec2 axis(200, 500);
  for (const double r : {40.0, 150.0, 220.0, 900.0}) {
    const Vec2 p = leaves_right(axis, r, 400.0);
    EXPECT_NEAR((p - axis).norm(), r, 1e-9);
    EXPECT_LE(p.x(), 400.0);
    EXPECT_LT(p.y(), axis.y());
  }
  EXPECT_DOUBLE_EQ(leaves_right(axis, 900.0, 400.0).x(), 400.0);
}

TEST(Leaders, LabelsKeepApart) {
  Svg svg("s", 500, 300, "t", "d");
  draw_leaders(svg, {{{100, 50}, "upper"}, {{100, 52}, "lower"}}, 420, 300);
  const std::string text = svg.str();
  // The labels are half a gap of 19 px on either side of 51.
  EXPECT_NE(text.find("translate(420 41.5)"), text.npos);
  EXPECT_NE(text.find("translate(420 60.5)"), text.npos);
  EXPECT_LT(text.find("upper"), text.find("lower"));
}

}  // namespace
}  // namespace gearwright
