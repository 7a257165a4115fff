#include "gearwright/report/named_circles.hpp"

#include <gtest/gtest.h>

#include "gearwright/report/testing/page_text.hpp"

namespace gearwright {
namespace {

using testing::has;

std::string drawn(double side, std::size_t gear, double radius) {
  Svg svg("s", 400, 400, "t", "d");
  const Viewport view{400, 400, Vec2::Zero(), 10.0};
  draw_named_circles(svg, view, {0, 0}, side, gear, {{"d_w1", radius, " dashdot"}});
  return svg.str();
}

TEST(NamedCircles, AtTheTopOrTheBottomWhereTheyLeave) {
  // r = 190 px leaves the line y = 30, 170 px above the axis, √(190² − 170²) = 84.85 px from it.
  EXPECT_TRUE(has(drawn(1, 0, 19.0), "M284.85 30L284.85 22"));
  EXPECT_TRUE(has(drawn(-1, 0, 19.0), "M115.15 30L"));
  EXPECT_TRUE(has(drawn(1, 1, 19.0), "M284.85 370L"));
}

TEST(NamedCircles, BesideAWholeCircleAwayFromTheMesh) {
  const std::string left = drawn(1, 0, 12.0);
  EXPECT_TRUE(has(left, "M104 128L"));  // (−0.8, 0.6) r
  EXPECT_TRUE(has(left, "class=\"halo g1 e\""));
  EXPECT_TRUE(has(drawn(-1, 0, 12.0), "M296 128L"));
  EXPECT_TRUE(has(drawn(-1, 1, 12.0), "M296 272L"));
}

TEST(NamedCircles, NoNameForWhatIsFarAway) {
  EXPECT_FALSE(has(drawn(1, 0, 60.0), "<text"));
  EXPECT_TRUE(has(drawn(1, 0, 60.0), "<circle"));
}

}  // namespace
}  // namespace gearwright
