#include "gearwright/design/shift_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "gearwright/design/design_row.hpp"
#include "gearwright/design/search.hpp"

namespace gearwright {
namespace {

constexpr double kStep = 0.05;

SearchProblem spur(int z1, int z2) {
  SearchProblem p;
  p.ratio = {static_cast<double>(z2) / z1, static_cast<double>(z2) / z1};
  p.pinion_teeth = {z1, z1};
  p.modules = {2.0};
  p.limits.min_shift = -0.6;
  p.limits.max_shift = 1.0;
  return p;
}

struct Case {
  const char* name;
  SearchProblem problem;
};

std::vector<Case> cases() {
  std::vector<Case> c{
      {"extended", spur(17, 34)},      {"tight", spur(17, 34)},   {"shortened", spur(28, 28)},
      {"ring", spur(18, -60)},         {"crossed", spur(20, 40)}, {"sliding", spur(20, 41)},
      {"interference", spur(40, 120)}, {"helical", spur(19, 31)}, {"clearance", spur(17, 34)}};
  c[1].problem.mounting = Mounting::tight;
  c[2].problem.mounting = Mounting::tight;
  c[2].problem.shorten_tips = true;
  c[2].problem.limits.max_shift = 3.0;
  c[4].problem.shaft_angle = Angle::degrees(90);
  c[4].problem.helix = {Angle::degrees(45)};
  c[5].problem.limits.sliding = 1.5;
  c[6].problem.limits.avoid_interference = true;
  c[6].problem.limits.min_shift.reset();
  c[6].problem.limits.max_shift.reset();
  c[7].problem.helix = {Angle::radians(0.3)};
  c[7].problem.center_distance = {{52.0, 54.0}};
  c[8].problem.mounting = Mounting::tight;
  c[8].problem.limits.tip_clearance = 0.2;
  return c;
}

std::set<std::pair<int, int>> plain(const ShiftGraph& graph) {
  std::set<std::pair<int, int>> inside;
  for (int i = -120; i <= 120; ++i) {
    for (int j = -120; j <= 120; ++j) {
      if (graph.margin(i * kStep, j * kStep) >= -kTouching) inside.insert({i, j});
    }
  }
  return inside;
}

TEST(ShiftPoints, AreThoseOfThePlainLoops) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Search search(c.problem);
    const ShiftGraph graph = search.graph(search.space().trial(0));
    const auto region = shift_region(graph);
    ASSERT_TRUE(region);
    std::vector<ShiftPoint> points;
    const PointCounts counts = feasible_points(graph, *region, kStep, points);
    EXPECT_EQ(counts.feasible, static_cast<std::int64_t>(points.size()));
    EXPECT_GE(counts.tested, counts.feasible);
    std::set<std::pair<int, int>> found;
    for (const ShiftPoint& p : points) {
      found.insert({static_cast<int>(std::lround(p.shift[0] / kStep)),
                    static_cast<int>(std::lround(p.shift[1] / kStep))});
    }
    EXPECT_EQ(found.size(), points.size());
    EXPECT_EQ(found, plain(graph));
    EXPECT_NEAR(static_cast<double>(points.size()) * kStep * kStep, region->area,
                0.1 * region->area + 0.05);
    if (!c.problem.crossed() && !c.problem.limits.avoid_interference) {
      EXPECT_LT(counts.asked, counts.tested / 10);
    }
  }
}

TEST(ShiftPoints, HaveTheNumbersOfThePair) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Search search(c.problem);
    const ShiftGraph graph = search.graph(search.space().trial(0));
    std::vector<ShiftPoint> points;
    feasible_points(graph, *shift_region(graph), 0.2, points);
    ASSERT_FALSE(points.empty());
    for (const ShiftPoint& p : points) {
      const DesignRow row = row_at(graph, {p.shift[0], p.shift[1]});
      EXPECT_EQ(p.contact_ratio, row.contact_ratio);
      EXPECT_EQ(p.sliding, row.max_sliding());
      EXPECT_EQ(p.tip_thickness, row.tip_thickness);
      EXPECT_GE(p.contact_ratio, c.problem.limits.contact_ratio - 1e-9);
    }
  }
}

TEST(ShiftPoints, ShortenedTipsMayBeShiftedFartherThanWholeOnes) {
  SearchProblem p = spur(28, 28);
  p.mounting = Mounting::tight;
  p.shorten_tips = true;
  p.limits.max_shift = 3.0;
  const double a = ShiftGraph(p, {0, 2.0, 28, 28, {}, 0}, trial_gear(p, 28, Angle(), 0, 0),
                              trial_gear(p, 28, Angle(), 0, 1))
                       .place(3.0)
                       .a *
                   2.0;
  p.center_distance = {{a, a}};
  p.limits.contact_ratio = 0.8;
  const Search search(p);
  EXPECT_TRUE(search.exists(0, *search.space().size()));
  p.limits.min_shift = 1.3;
  p.center_distance.reset();
  const Search high(p);
  EXPECT_TRUE(high.exists(0, *high.space().size()));
}

}  // namespace
}  // namespace gearwright
