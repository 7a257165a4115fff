// Regions are compared with the five regions of the reference, to its printed digits. Laws for
// every kind of mounting: (1) the boundary is traversed once, counter-clockwise, and each edge lies
// on a limit; (2) the area equals that of a fine grid of points at which the pair is feasible; (3)
// the balanced point lies inside, on the line of balanced strength (Eq. 11).
#include "gearwright/design/shift_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "gearwright/design/testing/region_checks.hpp"
#include "gearwright/design/testing/search_reference.hpp"

namespace gearwright {
namespace {

using nlohmann::json;
using testing::search::expect_area_of_a_grid;
using testing::search::graph;
using testing::search::Kind;
using testing::search::kKinds;
using testing::search::kPrinted;
using testing::search::margin_by_numbers;
using testing::search::number;
using testing::search::Random;
using testing::search::random_trial;
using testing::search::signed_area;
using testing::search::trial;

Vec2 point(const json& p) { return {number(p[0]), number(p[1])}; }

void expect_point(const Vec2& value, const json& expected, const std::string& what) {
  EXPECT_NEAR(value[0], number(expected[0]), kPrinted) << what;
  EXPECT_NEAR(value[1], number(expected[1]), kPrinted) << what;
}

// ε_α of Eq. 10 at extended centres, α 20°, addendum 1.
double eq_10(int z1, int z2, const Vec2& x) {
  const double c = std::cos(std::numbers::pi / 9.0);
  const auto leg = [](double r, double b) { return std::sqrt((r - b) * (r + b)); };
  const double b_1 = z1 / 2.0 * c;
  const double b_2 = z2 / 2.0 * c;
  return (leg(z1 / 2.0 + 1.0 + x[0], b_1) + leg(z2 / 2.0 + 1.0 + x[1], b_2) -
          leg((z1 + z2) / 2.0 + x[0] + x[1], b_1 + b_2)) /
         (std::numbers::pi * c);
}

// Calls f(problem, graph, region of the reference), either for all regions that exist or for all
// that do not.
template <class F>
void each_region(bool feasible, const F& f) {
  int regions = 0;
  for (const json& region : testing::search::reference().at("regions")) {
    if (region.at("feasible") != feasible) continue;
    const json& in = region.at("input");
    const SearchProblem p = testing::search::problem_of_region(in);
    f(p, graph(p, trial(p, in.at("z1"), in.at("z2"), p.modules[0])), region);
    ++regions;
  }
  EXPECT_EQ(regions, feasible ? 4 : 1);
}

TEST(ShiftRegion, RectangleEndsAndAreaOfTheReference) {
  each_region(true, [](const SearchProblem&, const ShiftGraph& g, const json& expected) {
    const std::string what = expected.at("input").dump();
    for (const std::size_t i : {0, 1}) {
      EXPECT_NEAR(g.gears()[i].x_min, number(expected.at("rect")[i][0]), kPrinted) << what;
      EXPECT_NEAR(g.gears()[i].x_max, number(expected.at("rect")[i][1]), kPrinted) << what;
    }
    const auto region = shift_region(g);
    ASSERT_TRUE(region) << what;
    ASSERT_EQ(region->sums.size(), 1u);
    EXPECT_NEAR(region->sums[0].lo, number(expected.at("S_lo")), kPrinted) << what;
    EXPECT_NEAR(region->sums[0].hi, number(expected.at("S_hi")), kPrinted) << what;
    for (const std::size_t i : {0, 1}) {
      expect_point(region->lo_edge[i], expected.at("lo_edge")[i], "lo_edge " + what);
      expect_point(region->hi_edge[i], expected.at("hi_edge")[i], "hi_edge " + what);
    }
    expect_point(region->lo, expected.at("lo"), "lo " + what);
    expect_point(region->hi, expected.at("hi"), "hi " + what);
    EXPECT_NEAR(region->area, number(expected.at("area")), kPrinted) << what;
  });
}

TEST(ShiftRegion, TheLineOfEq11OfTheReference) {
  each_region(true, [](const SearchProblem& given, const ShiftGraph& g, const json& expected) {
    for (const json& line : expected.at("eq11")) {
      SearchProblem p = given;
      p.lambda = number(line.at("lambda"));
      const auto region = shift_region(graph(p, g.trial()));
      ASSERT_TRUE(region);
      ASSERT_TRUE(line.at("feasible").get<bool>());
      ASSERT_EQ(region->balanced_sums.size(), 1u);
      const std::string what = line.dump();
      EXPECT_NEAR(region->balanced_sums[0].lo, number(line.at("S_min")), kPrinted) << what;
      EXPECT_NEAR(region->balanced_sums[0].hi, number(line.at("S_max")), kPrinted) << what;
      ASSERT_TRUE(region->balanced) << what;
      EXPECT_NEAR((*region->balanced)[0], number(line.at("s1")), kPrinted) << what;
      EXPECT_NEAR((*region->balanced)[1], number(line.at("s2")), kPrinted) << what;
      EXPECT_NEAR(row_at(g, *region->balanced).contact_ratio, number(line.at("eps")), kPrinted);
    }
  });
}

TEST(ShiftRegion, CornersAndCurvesOfTheReference) {
  each_region(true, [](const SearchProblem& p, const ShiftGraph& g, const json& expected) {
    const auto region = shift_region(g);
    ASSERT_TRUE(region);
    const auto loops = region_boundary(g, *region);
    ASSERT_EQ(loops.size(), 1u);
    const auto& loop = loops[0];
    const json& vertices = expected.at("vertices");
    EXPECT_EQ(loop.size(), vertices.size()) << vertices.dump();
    for (const json& vertex : vertices) {
      const std::set<std::string> names(vertex[2].begin(), vertex[2].end());
      bool found = false;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const RegionEdge& next = loop[(i + 1) % loop.size()];
        const std::set<std::string> meeting{std::string(name(loop[i].edge)),
                                            std::string(name(next.edge))};
        if (meeting != names) continue;
        found = true;
        expect_point(loop[i].points.back(), vertex, "end before " + vertex.dump());
        expect_point(next.points.front(), vertex, "end after " + vertex.dump());
      }
      EXPECT_TRUE(found) << vertex.dump();
    }
    int on_curve = 0;
    for (const RegionEdge& edge : loop) {
      if (edge.edge != ShiftEdge::eps) continue;
      EXPECT_GE(edge.points.size(), 25u);
      for (const Vec2& x : edge.points) {
        ++on_curve;
        EXPECT_NEAR(eq_10(g.trial().z1, g.trial().z2, x), p.limits.contact_ratio, kPrinted);
      }
    }
    EXPECT_GT(on_curve, 20);
    for (const json& of_curve : expected.at("curve")) {
      const Vec2 x = point(of_curve);
      const ShiftSlice s = g.slice(x[0] + x[1]);
      const double off = std::min(std::abs(s.lo - x[0]), std::abs(s.hi - x[0]));
      EXPECT_LE(off, kPrinted) << of_curve.dump();
    }
  });
}

TEST(ShiftRegion, WhatTheReferenceFindsEmptyIsEmpty) {
  each_region(false, [](const SearchProblem&, const ShiftGraph& g, const json&) {
    EXPECT_FALSE(shift_region(g));
    EXPECT_EQ(g.what_kills(), Limit::center_distance);
  });
}

// If the band consists of one distance, the boundary is a segment that is traversed in both
// directions.
TEST(ShiftRegion, AnExactDistanceIsASegment) {
  SearchProblem p;
  p.center_distance = {{75.0, 75.0}};
  p.limits.min_shift = -0.6;
  p.limits.max_shift = 1.0;
  for (const auto& [z1, z2, sum] : {std::tuple{20, 40, 0.0}, {20, 39, 0.5}, {19, 40, 0.5}}) {
    const ShiftGraph g = graph(p, trial(p, z1, z2, 2.5));
    const auto region = shift_region(g);
    ASSERT_TRUE(region) << z1;
    EXPECT_EQ(region->area, 0.0);
    EXPECT_NEAR(region->sums[0].lo, sum, 1e-14);
    EXPECT_EQ(region->sums[0].lo, region->sums[0].hi);
    EXPECT_EQ(region->lo, region->hi);
    EXPECT_LT(region->lo_edge[0][0], region->lo_edge[1][0] - 0.1);
    const auto loops = region_boundary(g, *region);
    ASSERT_EQ(loops.size(), 1u);
    ASSERT_EQ(loops[0].size(), 2u);
    EXPECT_EQ(loops[0][0].points.front(), loops[0][1].points.back());
    EXPECT_EQ(loops[0][0].points.back(), loops[0][1].points.front());
    for (const RegionEdge& edge : loops[0])
      EXPECT_TRUE(edge.edge == ShiftEdge::Cmin || edge.edge == ShiftEdge::Cmax) << name(edge.edge);
    ASSERT_TRUE(region->balanced);
    EXPECT_NEAR((*region->balanced)[0] + (*region->balanced)[1], sum, 1e-14);
  }
}

// Module 2, 31:64 teeth, 99 … 101 mm: Σ = 2 is the least sum of the band, and also the corner of
// the upper limits.
TEST(ShiftRegion, ABandThatTouchesTheCornerLeavesAPoint) {
  SearchProblem p;
  p.limits.min_shift = -0.6;
  p.limits.max_shift = 1.0;
  for (const double m : {1.0, 1.25, 2.0, 0.3, 1.1}) {  // for some modules the quotient is rounded
    p.center_distance = {{49.5 * m, 50.5 * m}};
    const ShiftGraph g = graph(p, trial(p, 31, 64, m));
    const auto region = shift_region(g);
    ASSERT_TRUE(region) << m;
    EXPECT_EQ(g.what_kills(), std::nullopt) << m;
    EXPECT_LT(region->area, 1e-12) << m;
    for (const Vec2& x : {region->lo, region->hi}) {
      EXPECT_NEAR(x[0], 1.0, kTouching) << m;
      EXPECT_NEAR(x[1], 1.0, kTouching) << m;
    }
    EXPECT_FALSE(region->balanced) << m;  // Eq. 11 divides Σ = 2 differently
    p.center_distance = {{49.5 * m + 1e-9, 50.5 * m}};
    EXPECT_FALSE(shift_region(graph(p, trial(p, 31, 64, m)))) << m;
  }
}

class ShiftRegionOfKind : public ::testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, ShiftRegionOfKind, ::testing::ValuesIn(kKinds),
                         [](const auto& kind) {
                           std::string name = kind.param.name;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST_P(ShiftRegionOfKind, BoundariesRunAroundOnTheirLimits) {  // (1)
  Random random(21);
  int regions = 0;
  std::set<std::string> seen;
  const bool slow = GetParam().shorten && !GetParam().ring;  // thick_enough at every tip alteration
  for (int t = 0; t < (slow ? 60 : 200); ++t) {
    const auto made = random_trial(random, GetParam());
    const ShiftGraph g = graph(made.problem, made.trial);
    const auto region = shift_region(g);
    EXPECT_EQ(region.has_value(), !g.what_kills()) << t;
    if (!region) continue;
    const auto loops = region_boundary(g, *region);
    EXPECT_EQ(loops.size(), region->sums.size());
    double around = 0.0;
    for (const auto& loop : loops) {
      if (loop.empty()) continue;
      around += signed_area(loop);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2& end = loop[i].points.back();
        const Vec2& next = loop[(i + 1) % loop.size()].points.front();
        EXPECT_LT((end - next).norm(), 1e-9) << t << " " << name(loop[i].edge);
        seen.insert(std::string(name(loop[i].edge)));
        for (const Vec2& x : loop[i].points) {
          // Near the sum at which the working angle vanishes, N grows as the square root of Σ, so
          // rounding of Σ is visible.
          if (std::abs(g.place(x[0] + x[1]).N) < 1e-3) continue;
          EXPECT_NEAR(g.margin(x[0], x[1]), 0.0, 1e-9) << t << " " << name(loop[i].edge);
        }
      }
    }
    if (region->area < 1e-6) continue;
    ++regions;
    // Each curve has 25 points. The relative error of their chords is h²/6 for half an ellipse with
    // h = π/24, and there are two curves.
    EXPECT_NEAR(around, region->area, 6e-3 * region->area + 1e-9) << t;
  }
  EXPECT_GT(regions, slow ? 5 : 15);
  EXPECT_TRUE(seen.count("Cmin") && seen.count("Cmax"));
}

void expect_areas_of_a_grid(const Kind& kind, unsigned seed, int wanted, int grid, double within) {
  Random random(seed);
  int regions = 0;
  while (regions < wanted) {
    const auto made = random_trial(random, kind);
    const ShiftGraph g = graph(made.problem, made.trial);
    const auto region = shift_region(g);
    if (!region || region->area < 0.01) continue;
    ++regions;
    expect_area_of_a_grid(g, *region, random, grid, within);
  }
}

TEST_P(ShiftRegionOfKind, AreasAreThoseOfAGridOfPairs) {  // (2)
  expect_areas_of_a_grid(GetParam(), 22, 3, 250, 0.03);
}
TEST_P(ShiftRegionOfKind, LongAreasAreThoseOfAFineGridOfPairs) {
  expect_areas_of_a_grid(GetParam(), 25, 2, 2000, 2e-3);
}

TEST_P(ShiftRegionOfKind, BalancedPointsAreInsideOnTheLine) {  // (3)
  Random random(23);
  int balanced = 0;
  int chosen = 0;
  const bool slow = GetParam().shorten && !GetParam().ring;
  for (int t = 0; t < (slow ? 100 : 300); ++t) {
    auto made = random_trial(random, GetParam());
    made.problem.lambda = random.uniform(0.4, 0.9);
    const ShiftGraph g = graph(made.problem, made.trial);
    const auto region = shift_region(g);
    if (!region) continue;
    const Vec2 x = chosen_point(g, *region);
    EXPECT_GE(g.margin(x[0], x[1]), -kTouching - 1e-12) << t;
    if (region->area > 1e-6) {
      ++chosen;
      EXPECT_GE(margin_by_numbers(g, x[0], x[1]), -1e-10) << t;
    }
    if (!region->balanced) continue;
    ++balanced;
    const bool runs = made.problem.limits.avoid_interference;
    if (runs) {
      const double off = g.wall_distance(x[0], x[1]);
      EXPECT_GE(off, g.wall_distance((*region->balanced)[0], (*region->balanced)[1]) - 1e-9) << t;
    } else {
      EXPECT_EQ(x, *region->balanced);
    }
    const double z1 = made.trial.z1;
    const double z2 = made.trial.z2;
    const double lambda = made.problem.lambda;
    const double on_line =
        z2 < 0.0 ? x[0] + x[1] : (lambda * z2 + (x[0] + x[1] - lambda) * z1) / (z1 + z2);
    EXPECT_NEAR(x[0], on_line, 1e-13);
    // No other feasible point on the line has a sum nearer to 0.
    const double sum = (*region->balanced)[0] + (*region->balanced)[1];
    for (int i = 0; i < 20; ++i) {
      const double nearer = sum * random.uniform(-0.999, 0.999);
      if (std::abs(sum - nearer) < 1e-6) continue;
      const Vec2 y = balanced_point(made.trial.z1, made.trial.z2, nearer, lambda);
      EXPECT_LT(g.margin(y[0], y[1]), 1e-9) << t;
    }
  }
  EXPECT_GT(chosen, slow ? 8 : 20);
  EXPECT_GT(balanced, slow ? 0 : 3);
}

}  // namespace
}  // namespace gearwright
