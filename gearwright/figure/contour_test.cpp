#include "gearwright/figure/contour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearwright/base/numbers.hpp"

namespace gearwright {
namespace {

template <typename F>
ContourField field_of(std::size_t columns, std::size_t rows, const F& f) {
  ContourField field{columns, rows, {}};
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c)
      field.value.push_back(f(static_cast<double>(c), static_cast<double>(r)));
  return field;
}

TEST(Contour, ALinearFieldHasAStraightBorder) {
  // The region is c + 2 r < 7.3. Its border meets the edges of the raster at exact points.
  const auto loops =
      regions_below(field_of(6, 4, [](double c, double r) { return c + 2 * r; }), 7.3);
  ASSERT_EQ(loops.size(), 1u);
  for (const Vec2& p : loops[0]) {
    const bool edge = p.x() < 1e-9 || p.y() < 1e-9 || p.x() > 5 - 1e-9 || p.y() > 3 - 1e-9;
    EXPECT_TRUE(edge || std::abs(p.x() + 2 * p.y() - 7.3) < 1e-12) << p.transpose();
  }
  // The region is the rectangle 5 × 3 minus the triangle with the corner (5, 3) and the legs 3.7
  // and 1.85.
  EXPECT_NEAR(area_of(loops), 15.0 - 0.5 * 3.7 * 1.85, 1e-12);
}

TEST(Contour, ACircleAndItsHole) {
  const auto ring = [](double c, double r) {
    return std::abs(std::hypot(c - 30.0, r - 30.0) - 20.0);
  };
  const auto loops = regions_below(field_of(61, 61, ring), 4.0);
  ASSERT_EQ(loops.size(), 2u);
  // The chords of a circle of radius R in a raster of step 1 deviate from it by at most 1/(8 R).
  EXPECT_NEAR(area_of(loops), std::numbers::pi * (24.0 * 24.0 - 16.0 * 16.0),
              2 * std::numbers::pi * (24.0 / (8 * 24.0) + 16.0 / (8 * 16.0)));
}

TEST(Contour, InfiniteNodesAreLeftHalfwayAndTheEdgeCloses) {
  const auto all = regions_below(field_of(5, 3, [](double, double) { return 0.0; }), 1.0);
  EXPECT_NEAR(area_of(all), 4.0 * 2.0, 1e-12);
  // The last two columns are infinite, so the area ends halfway between the third and the fourth
  // column.
  const auto part = regions_below(
      field_of(5, 3, [](double c, double) { return c > 2.5 ? kInfinity : 0.0; }), 1.0);
  EXPECT_NEAR(area_of(part), 2.5 * 2.0, 1e-12);
  EXPECT_TRUE(regions_below(field_of(5, 3, [](double, double) { return kInfinity; }), 1.0).empty());
}

TEST(Contour, ASaddleIsDecidedByItsMean) {
  const auto saddle = [](double low, double high) {
    return ContourField{2, 2, {low, high, high, low}};
  };
  EXPECT_EQ(regions_below(saddle(0.0, 1.5), 1.0).size(), 1u);  // mean 0.75
  EXPECT_EQ(regions_below(saddle(0.0, 2.5), 1.0).size(), 2u);  // mean 1.25
  EXPECT_EQ(regions_below(saddle(0.0, kInfinity), 1.0).size(), 2u);
}

TEST(Contour, RegionsGrowWithTheLevel) {
  const auto field = field_of(
      20, 15, [](double c, double r) { return 2 + std::sin(c * 0.7) * std::cos(r * 0.9); });
  double last = 0.0;
  for (double level = 1.05; level < 3.2; level += 0.1) {
    const double area = area_of(regions_below(field, level));
    EXPECT_GE(area, last);
    last = area;
  }
  EXPECT_NEAR(last, 19.0 * 14.0, 1e-9);
}

}  // namespace
}  // namespace gearwright
