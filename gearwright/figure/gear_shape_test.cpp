#include "gearwright/figure/gear_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "gearwright/report/testing/chain_distance.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

// Converts the commands M, l and a back into points, mm, y up. Circles become chords of negligible
// error.
std::vector<Vec2> points_of(const std::string& path, double unit) {
  std::string spaced;
  for (const char c : path) {
    if (c == 'M' || c == 'l' || c == 'a') {
      spaced += std::string(" ") + c + " ";
    } else if (c == '-') {
      spaced += " -";
    } else {
      spaced += c;
    }
  }
  std::istringstream in(spaced);
  std::vector<Vec2> points;
  Vec2 pen = Vec2::Zero();
  std::string word;
  char command = 0;
  while (in >> word) {
    if (word == "M" || word == "l" || word == "a") {
      command = word[0];
      if (!(in >> word)) break;
    }
    std::vector<double> n{std::stod(word)};
    const std::size_t count = command == 'a' ? 7 : 2;
    while (n.size() < count && in >> word) n.push_back(std::stod(word));
    const Vec2 step(n[count - 2], n[count - 1]);
    const Vec2 next = command == 'M' ? step : Vec2(pen + step);
    if (command == 'a') {
      const double from = std::atan2(pen.y(), pen.x());
      const double turn =
          std::remainder(std::atan2(next.y(), next.x()) - from, 2 * std::acos(-1.0));
      EXPECT_EQ(n[4] > 0.5, turn > 0.0) << "clockwise on the screen, y down";
      for (int k = 1; k < 64; ++k) {
        const double angle = from + turn * k / 64;
        points.push_back(n[0] * Vec2(std::cos(angle), std::sin(angle)));
      }
    }
    points.push_back(next);
    pen = next;
  }
  for (Vec2& p : points) p = unit * Vec2(p.x(), -p.y());
  return points;
}

class GearShape : public ::testing::TestWithParam<int> {};

TEST_P(GearShape, FollowsTheOutline) {
  const int z = GetParam();
  const Gear gear =
      testing::sample_gear(z, 2.5, z == 17 ? 25.0 : 0.0, z < 12 ? 0.5 : 0.0, z == 60 ? 0.3 : 0.0);
  ASSERT_TRUE(has_outline(gear));
  const std::vector<Vec2> chain = points_of(tooth_path(gear), outline_unit_mm(gear));
  double worst = 0.0;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    for (int k = 0; k <= 400; ++k) {
      const Vec2 p = arc.point(k / 400.0);
      for (const double side : {1.0, -1.0})
        worst = std::max(worst, testing::chain_distance(chain, {p.x(), side * p.y()}));
    }
  }
  EXPECT_LT(worst, kOutlineTolerance * gear.spec.normal_module);
  EXPECT_GT(worst, 0.2 * kOutlineTolerance * gear.spec.normal_module)
      << "more points than the picture needs";
  EXPECT_LT(tooth_path(gear).size(), 3000u);
}

INSTANTIATE_TEST_SUITE_P(Teeth, GearShape, ::testing::Values(6, 8, 17, 25, 60, 300));

TEST(GearShape, FollowsTeethCutByGears) {
  const ParallelPair sixty = testing::two_and_sixty();
  const ParallelPair ring = testing::pinion_in_cut_ring();
  for (const Gear* gear : {&sixty.gears[0], &sixty.gears[1], &ring.gears[1]}) {
    const std::vector<Vec2> chain = points_of(tooth_path(*gear), outline_unit_mm(*gear));
    double worst = 0.0;
    for (const Arc& arc : gear->tooth->outline.arcs) {
      for (int k = 0; k <= 400; ++k) {
        const Vec2 p = arc.point(k / 400.0);
        for (const double side : {1.0, -1.0})
          worst = std::max(worst, testing::chain_distance(chain, {p.x(), side * p.y()}));
      }
    }
    EXPECT_LT(worst, kOutlineTolerance * gear->spec.normal_module) << gear->spec.teeth;
  }
}

TEST(GearShape, ABoreIsAHoleWithItsKeyway) {
  Gear gear = testing::sample_gear(30, 2, 0, 0);
  const std::string plain = gear_definition(gear, "g");
  gear.bore = Bore{20.0, 6.0, 2.8};
  const std::string text = gear_definition(gear, "g");
  const auto units = [&](double mm) {
    return std::to_string(std::lround(mm / outline_unit_mm(gear)));
  };
  EXPECT_EQ(plain.find("evenodd"), std::string::npos);
  EXPECT_NE(text.find("evenodd"), std::string::npos);
  // The floor of the keyway is 2.8 mm above the bore circle. In SVG, y points down, so its y is
  // negative.
  EXPECT_NE(text.find("V-" + units(12.8) + "H-" + units(3.0)), std::string::npos);
  gear.bore->keyway_width = 0.0;
  EXPECT_NE(gear_definition(gear, "g").find("M" + units(10.0) + " 0A"), std::string::npos);
}

// If a gear has few teeth, the chord between the roots of a tooth crosses the bore, which would
// then show corners.
TEST(GearShape, ABoreOfFewTeethStaysRound) {
  Gear gear = testing::sample_gear(5, 2, 0, 0.7);
  const double chord = gear.tooth->outline.arcs.front().begin_point.x();
  gear.bore = Bore{2 * chord - 0.2, 0.0, 0.0};
  const auto r_f = std::to_string(std::lround(gear.tooth->root_radius / outline_unit_mm(gear)));
  const std::string closed = "A" + r_f + " " + r_f + " 0 0 0";
  EXPECT_EQ(gear_definition(gear, "g").find(closed), std::string::npos);
  gear.bore->diameter = 2 * chord + 0.2;
  EXPECT_NE(gear_definition(gear, "g").find(closed), std::string::npos);
}

TEST(GearShape, ARingIsMetalAroundItsTeeth) {
  const Gear ring = testing::pinion_in_cut_ring().gears[1];
  ASSERT_TRUE(has_outline(ring));
  EXPECT_DOUBLE_EQ(drawn_radius(ring), ring.root_diameter / 2 + 2.5 * 2);
  const std::string text = gear_definition(ring, "g");
  std::size_t uses = 0;
  for (std::size_t at = text.find("#g-tooth"); at != text.npos; at = text.find("#g-tooth", at + 1))
    ++uses;
  EXPECT_EQ(uses, 60u);
  // The rim and the roots are one ring with a hole, without a disc.
  const auto radius = [&](double mm) {
    return std::to_string(std::lround(mm / outline_unit_mm(ring)));
  };
  const std::string rim = "M" + radius(drawn_radius(ring)) + " 0A";
  const std::string hole = "M" + radius(ring.root_diameter / 2) + " 0A";
  EXPECT_LT(text.find("evenodd"), text.find(rim));
  EXPECT_LT(text.find(rim), text.find(hole));
  EXPECT_NE(text.find(hole), text.npos);
  // An external gear ends at its tip. An internal gear without an outline ends at its roots.
  EXPECT_DOUBLE_EQ(drawn_radius(testing::sample_gear(20, 2, 0, 0)), 22.0);
  EXPECT_DOUBLE_EQ(drawn_radius(testing::sample_gear(-60, 2, 0, 0)), 62.5);
}

TEST(GearShape, OneToothIsUsedZTimes) {
  const Gear gear = testing::sample_gear(23, 2, 0, 0);
  const std::string text = gear_definition(gear, "g");
  std::size_t uses = 0;
  for (std::size_t at = text.find("#g-tooth"); at != text.npos; at = text.find("#g-tooth", at + 1))
    ++uses;
  EXPECT_EQ(uses, 23u);
  EXPECT_NE(text.find("rotate(344.347826)"), text.npos);  // 360·22/23
}

TEST(GearShape, WhatHasNoOutlineHasNoShape) {
  EXPECT_EQ(gear_definition(testing::sample_gear(-60, 2, 0, 0), "g"), "");
  EXPECT_EQ(gear_definition(testing::sample_gear(3, 2, 0, -0.6), "g"), "");
}

}  // namespace
}  // namespace gearwright
