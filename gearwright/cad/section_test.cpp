#include "gearwright/cad/section.hpp"

#include <gtest/gtest.h>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

using testing::append;

// Areas of polygons with n, 2n, 4n … points per arc are extrapolated (Romberg), because the error
// of an inscribed polygon is a series in even powers of 1/n. This shares no code with the
// quadrature.
double polygon_oracle(const Outline& outline) {
  constexpr int kLevels = 9;
  double table[kLevels][kLevels] = {};
  for (int level = 0; level < kLevels; ++level) {
    const int n = 8 << level;
    double sum = 0.0;
    for (const Arc& arc : outline.arcs) {
      const std::vector<Vec2> p = sample(arc, n + 1);
      for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        sum -= p[i].x() * p[i + 1].y() - p[i].y() * p[i + 1].x();
      }
    }
    table[level][0] = sum * std::abs(outline.teeth);
    double four = 1.0;
    for (int k = 1; k <= level; ++k) {
      four *= 4.0;
      table[level][k] =
          table[level][k - 1] + (table[level][k - 1] - table[level - 1][k - 1]) / (four - 1.0);
    }
  }
  return table[kLevels - 1][kLevels - 1];
}

TEST(Section, CircleIsPiRSquared) {
  for (const int teeth : {1, 2, 7, -30}) {
    Outline outline{teeth, {}};
    append(outline, ArcName::root_land, std::make_shared<testing::SampleCircle>(3.25),
           kPi / std::abs(teeth), 0.0);
    EXPECT_NEAR(section_area(outline) / (kPi * 3.25 * 3.25), 1.0, 2e-14) << teeth;
  }
}

TEST(Section, StraightFlanksAreSectorsAndTriangles) {
  const auto body = testing::plain_body(12, 20.0, 0.2, 25.0, 0.08);
  EXPECT_NEAR(section_area(body.outline) / testing::plain_area(12, 20.0, 0.2, 25.0, 0.08), 1.0,
              2e-14);
}

TEST(Section, RackCutTeethAgreeWithExtrapolatedPolygons) {
  for (const testing::SampleGear& gear :
       {testing::SampleGear{}, testing::SampleGear{.teeth = 60, .beta = 0.3},
        testing::SampleGear{.pointed = true, .full_radius_root = true},
        testing::SampleGear{.chamfer = 0.4}}) {
    const Outline outline = testing::sample_body(gear).outline;
    EXPECT_NEAR(section_area(outline) / polygon_oracle(outline), 1.0, 1e-12) << gear.teeth;
  }
}

TEST(Section, ScalesWithTheSquare) {
  const double one = section_area(testing::sample_body({.normal_module = 2.0}).outline);
  const double two = section_area(testing::sample_body({.normal_module = 4.0}).outline);
  EXPECT_NEAR(two / one, 4.0, 1e-13);
}

TEST(Section, BoreWithKeyway) {
  EXPECT_DOUBLE_EQ(bore_area({20.0}), kPi * 100.0);
  // The area of the slot between the circle y = √(r² − x²) and y = r + t is summed over strips by
  // the midpoint rule.
  const Bore bore{20.0, 6.0, 2.8};
  double slot = 0.0;
  constexpr int kStrips = 2000;
  for (int i = 0; i < kStrips; ++i) {
    const double x = -3.0 + 6.0 * (i + 0.5) / kStrips;
    slot += (12.8 - std::sqrt(100.0 - x * x)) * 6.0 / kStrips;
  }
  // The midpoint rule's error is h²/24 (f'(3) − f'(−3)) = 2.4e-7.
  EXPECT_NEAR(bore_area(bore), kPi * 100.0 + slot, 3e-7);
}

TEST(Section, MetalIsOutlineLessBoreAndRimLessOutline) {
  auto gear = testing::plain_body(12, 20.0, 0.2, 25.0, 0.08);
  const double outline = section_area(gear.outline);
  EXPECT_DOUBLE_EQ(metal_area(gear), outline);
  gear.bore = Bore{10.0};
  EXPECT_DOUBLE_EQ(metal_area(gear), outline - kPi * 25.0);
  auto ring = testing::plain_body(-12, 25.0, 0.2, 20.0, 0.08);
  ring.bore = Bore{60.0};
  EXPECT_DOUBLE_EQ(metal_area(ring), kPi * 900.0 - section_area(ring.outline));
}

}  // namespace
}  // namespace gearwright
