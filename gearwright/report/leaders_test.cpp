#include "gearwright/report/leaders.hpp"

#include <gtest/gtest.h>

namespace gearwright {
namespace {

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
  // Half a gap of 19 px on either side of 51.
  EXPECT_NE(text.find("translate(420 41.5)"), text.npos);
  EXPECT_NE(text.find("translate(420 60.5)"), text.npos);
  EXPECT_LT(text.find("upper"), text.find("lower"));
}

}  // namespace
}  // namespace gearwright
