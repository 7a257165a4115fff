#include "gearwright/figure/free_labels.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "gearwright/figure/figure_svg.hpp"

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

TEST(Leaders, LabelsKeepApart) {
  Figure f = plane_figure("s", "t", "d", {{0, 0}, {400, 300}});
  f.leaders = {{{100, 250}, "upper"}, {{100, 248}, "lower"}};
  const std::string text = figure_svg(f, 500);
  const auto height = [&](const char* words) {
    const std::size_t at = text.rfind("translate(", text.find(words));
    return std::atof(text.c_str() + text.find(' ', at));
  };
  EXPECT_NEAR(height(">lower<") - height(">upper<"), 19.0, 0.02);
  EXPECT_NE(text.find("<g clip-path=\"url(#s-c1)\">"), text.npos);
}

}  // namespace
}  // namespace gearwright
