// The graph is compared with the results of mounted pairs, for every kind of mounting. Laws: (1)
// margin() and the results agree on which points are inside; (2) each end of a slice lies on a
// limit, and its interior is within all limits; (3) the feasible sums are exactly those with a
// slice.
#include "gearwright/design/shift_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "gearwright/design/testing/search_reference.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {
namespace {

using testing::search::graph;
using testing::search::Kind;
using testing::search::kKinds;
using testing::search::margin_by_numbers;
using testing::search::Random;
using testing::search::random_trial;
using testing::search::trial;

class ShiftGraphOfKind : public ::testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, ShiftGraphOfKind, ::testing::ValuesIn(kKinds),
                         [](const auto& kind) {
                           std::string name = kind.param.name;
                           for (char& c : name)
                             if (c == ' ') c = '_';
                           return name;
                         });

// A random point near the rectangle of shifts and near the given range of sums.
Vec2 place_near(Random& random, const ShiftGraph& g, const ShiftGraph::Sums& range) {
  const auto& [g_1, g_2] = g.gears();
  const double x1 = random.uniform(g_1.x_min - 0.1, g_1.x_max + 0.1);
  const double sum = range.lo <= range.hi
                         ? random.uniform(range.lo - 0.05, range.hi + 0.05)
                         : random.uniform(g_1.x_min + g_2.x_min, g_1.x_max + g_2.x_max);
  return {x1, sum - x1};
}

TEST_P(ShiftGraphOfKind, MarginsAgreeWithTheNumbersOfThePair) {  // (1)
  Random random(11);
  int inside = 0;
  int outside = 0;
  const bool slow = GetParam().shorten && !GetParam().ring;  // thick_enough at every tip alteration
  for (int t = 0; t < (slow ? 100 : 250); ++t) {
    const auto made = random_trial(random, GetParam());
    const ShiftGraph g = graph(made.problem, made.trial);
    if (g.gears()[0].x_min > g.gears()[0].x_max || g.gears()[1].x_min > g.gears()[1].x_max)
      continue;
    const ShiftGraph::Sums range = g.sums();
    for (int i = 0; i < 40; ++i) {
      const Vec2 x = place_near(random, g, range);
      const double margin = g.margin(x[0], x[1]);
      const double by_numbers = margin_by_numbers(g, x[0], x[1]);
      if (std::abs(margin) < 1e-9 || std::abs(by_numbers) < 1e-9) continue;
      EXPECT_EQ(margin > 0.0, by_numbers > 0.0)
          << "trial " << t << " z " << made.trial.z1 << " " << made.trial.z2 << " x " << x[0] << " "
          << x[1] << ": " << margin << " " << by_numbers;
      ++(margin > 0.0 ? inside : outside);
    }
  }
  EXPECT_GT(inside, slow ? 20 : 60);
  EXPECT_GT(outside, 500);
}

TEST_P(ShiftGraphOfKind, SlicesEndOnTheirLimits) {  // (2)
  Random random(12);
  int slices = 0;
  const bool slow = GetParam().shorten && !GetParam().ring;
  for (int t = 0; t < (slow ? 100 : 400); ++t) {
    const auto made = random_trial(random, GetParam());
    const ShiftGraph g = graph(made.problem, made.trial);
    for (const Interval& piece : g.feasible_sums()) {
      for (int i = 0; i < 5; ++i) {
        const double sum = random.uniform(piece.lo, piece.hi);
        const ShiftSlice s = g.slice(sum);
        ASSERT_FALSE(s.empty()) << t;
        if (s.hi - s.lo < 1e-6) continue;
        ++slices;
        const auto at = [&](double x1) { return g.margin(x1, sum - x1); };
        EXPECT_NEAR(at(s.lo), std::min(0.0, at(s.lo)), 1e-9) << t;
        EXPECT_NEAR(at(s.hi), std::min(0.0, at(s.hi)), 1e-9) << t;
        EXPECT_GT(at(s.lo), -1e-9) << t << " " << name(s.lo_edge);
        EXPECT_GT(at(s.hi), -1e-9) << t << " " << name(s.hi_edge);
        EXPECT_LT(at(s.lo - 1e-6), 0.0) << t << " " << name(s.lo_edge);
        EXPECT_LT(at(s.hi + 1e-6), 0.0) << t << " " << name(s.hi_edge);
        for (int k = 0; k < 5; ++k) EXPECT_GE(at(random.uniform(s.lo, s.hi)), -1e-12) << t;
      }
    }
  }
  EXPECT_GT(slices, slow ? 20 : 100);
}

TEST_P(ShiftGraphOfKind, FeasibleSumsAreThoseWithASlice) {  // (3)
  Random random(13);
  int with = 0;
  int without = 0;
  for (int t = 0; t < 300; ++t) {
    const auto made = random_trial(random, GetParam());
    const ShiftGraph g = graph(made.problem, made.trial);
    const auto range = g.sums();
    if (!(range.lo < range.hi)) continue;
    const auto pieces = g.feasible_sums();
    for (int i = 0; i < 20; ++i) {
      const double sum = random.uniform(range.lo, range.hi);
      const ShiftSlice s = g.slice(sum);
      const double width = s.hi - s.lo;
      const double alone = g.sum_margin(g.place(sum), sum).value;
      if (std::abs(width) < 1e-9 || std::abs(alone) < 1e-9) continue;
      const bool there = width > 0.0 && alone > 0.0;
      const bool listed = std::any_of(pieces.begin(), pieces.end(), [&](const Interval& piece) {
        return piece.lo <= sum && sum <= piece.hi;
      });
      EXPECT_EQ(there, listed) << t << " " << sum << " " << width;
      ++(there ? with : without);
    }
  }
  EXPECT_GT(with, 200);
  EXPECT_GT(without, 200);
}

TEST_P(ShiftGraphOfKind, PathsAreThoseOfTheMesh) {
  Random random(14);
  int paths = 0;
  for (int t = 0; t < 400; ++t) {
    const auto made = random_trial(random, GetParam());
    const ShiftGraph g = graph(made.problem, made.trial);
    const auto range = g.sums(3);
    if (!(range.lo < range.hi)) continue;
    const double sum = random.uniform(range.lo, range.hi);
    const ShiftSlice s =
        g.slice(sum, 2);  // a slice between the limits of the shifts; tips extend beyond base
                          // circles
    if (s.empty()) continue;
    ++paths;
    const SumPlace at = g.place(sum);
    const auto longest = g.longest_path(at, sum, s);
    EXPECT_EQ(longest.length, g.path_length(at, sum, longest.x1));
    for (int i = 0; i <= 20; ++i) {
      const double x1 = s.lo + (s.hi - s.lo) * i / 20.0;
      const DesignRow row = row_at(g, {x1, sum - x1});
      EXPECT_NEAR(row.center_distance, std::abs(at.a), 1e-13 * std::abs(at.a));
      const double path = g.path_length(at, sum, x1);
      EXPECT_NEAR(row.contact_ratio, path / g.pitch(), 2e-12) << t;
      EXPECT_LE(path, longest.length + 1e-13) << t << " " << i;
    }
  }
  EXPECT_GT(paths, 100);
}

TEST(ShiftGraph, CentreDistancesAreThoseOfThePair) {
  for (const Mounting mounting : {Mounting::extended, Mounting::tight}) {
    SearchProblem p;
    p.mounting = mounting;
    p.helix = {Angle::radians(0.3)};
    const double alpha_n = p.normal_pressure_angle.rad();
    const double alpha_t = std::atan(std::tan(alpha_n) / std::cos(0.3));
    for (const int z2 : {31, -61}) {
      const ShiftGraph g = graph(p, trial(p, 17, z2));
      for (const double sum : {-0.7, -0.2, 0.0, 0.1, 0.9}) {
        const double a =
            mounting == Mounting::tight
                ? tight_center_distance(17, z2, 1.0, alpha_n, alpha_t, std::cos(0.3), sum)
                : extended_center_distance(17, z2, 1.0, std::cos(0.3), sum);
        EXPECT_NEAR(std::abs(g.place(sum).a), a, 1e-13) << z2 << " " << sum;
        EXPECT_EQ(g.place(sum).a > 0.0, z2 > 0);
        EXPECT_EQ(g.place(sum).k, 0.0);
      }
    }
  }
}

// At tight centres, the tip alteration k = a − (r_1 + r_2) − Σ restores the clearance h_f − h_a of
// the racks.
TEST(ShiftGraph, ShortenedTipsKeepTheClearance) {
  SearchProblem p;
  p.mounting = Mounting::tight;
  p.shorten_tips = true;
  p.limits.contact_ratio = 0.5;
  for (const int z2 : {18, -60}) {
    const ShiftGraph g = graph(p, trial(p, 12, z2));
    for (const double sum : {-0.4, 0.0, 0.3, 0.9}) {
      const double k = g.place(sum).k;
      EXPECT_LE(k, 0.0);
      const DesignRow row = row_at(g, {sum / 2.0, sum / 2.0});
      for (const double c : row.tip_clearance) {
        if (k < 0.0) {
          EXPECT_NEAR(c, 0.25, 1e-14) << z2 << " " << sum;
        } else {
          EXPECT_GE(c, 0.25) << z2 << " " << sum;
        }
      }
    }
  }
}

// Each limit in turn is the first one that leaves no design for 20:40 teeth, module 1.
TEST(ShiftGraph, TheFirstLimitThatLeavesNothingIsNamed) {
  const auto killed = [](const auto& set, int z1 = 20, int z2 = 40) {
    SearchProblem p;
    p.center_distance = {{29.5, 30.5}};
    p.limits.min_shift = -0.6;
    p.limits.max_shift = 1.0;
    set(p);
    const auto limit = graph(p, trial(p, z1, z2)).what_kills();
    return limit ? std::string(name(*limit)) : std::string("nothing");
  };
  EXPECT_EQ(killed([](SearchProblem&) {}), "nothing");
  EXPECT_EQ(killed([](SearchProblem& p) { p.limits.tip_thickness = 0.9; }), "shift_limits");
  EXPECT_EQ(killed([](SearchProblem& p) { p.limits.min_shift = 1.1; }), "shift_limits");
  EXPECT_EQ(killed([](SearchProblem& p) {
              p.center_distance = {{32.1, 33.0}};
            }),
            "center_distance");
  EXPECT_EQ(killed([](SearchProblem& p) { p.limits.contact_ratio = 1.9; }), "contact_ratio");
  EXPECT_EQ(killed([](SearchProblem& p) { p.limits.overlap_ratio = 1.0; }), "overlap_ratio");
  EXPECT_EQ(killed([](SearchProblem& p) { p.limits.sliding = 0.1; }), "sliding");
  EXPECT_EQ(killed([](SearchProblem& p) { p.limits.tip_clearance = 0.3; }), "tip_clearance");
  // With Σ = −0.5, the tips of the 66-tooth gear reach below the flanks of the 16-tooth gear.
  for (const bool avoid : {false, true}) {
    const auto set = [&](SearchProblem& p) {
      p.center_distance = {{40.5, 40.5}};
      p.limits.max_shift = 0.1;
      p.limits.avoid_interference = avoid;
    };
    EXPECT_EQ(killed(set, 16, 66), avoid ? "interference" : "nothing");
  }
  // If two limits leave no design, the earlier one is reported.
  EXPECT_EQ(killed([](SearchProblem& p) {
              p.limits.tip_clearance = 0.3;
              p.limits.sliding = 0.1;
            }),
            "sliding");
}

TEST(ShiftGraph, OverlapIsThatOfTheFaceWidth) {
  SearchProblem p;
  p.helix = {Angle::radians(0.25)};
  p.face_width = {{12.0, 12.0}};
  p.limits.contact_ratio = 0.5;
  const double overlap = 12.0 * std::sin(0.25) / (std::numbers::pi * 2.0);
  p.limits.overlap_ratio = overlap - 1e-9;
  EXPECT_EQ(graph(p, trial(p, 20, 40, 2.0)).what_kills(), std::nullopt);
  p.limits.overlap_ratio = overlap + 1e-9;
  EXPECT_EQ(graph(p, trial(p, 20, 40, 2.0)).what_kills(), Limit::overlap_ratio);
}

// The flank of gear 1 starts above its base circle. The flank of gear 2 is undercut, and ρ_F2 < 0.
// The path then runs from the start of flank 1 to the base tangent point of gear 2. This path is
// too short, and no other limit is violated.
TEST(ShiftGraph, PathsEndAtOneStartAndOneBaseTangentPoint) {
  SearchProblem p;
  p.limits.undercut_margin = -1.5;
  p.limits.contact_ratio = 1.0;
  for (const bool turned : {false, true}) {
    const ShiftGraph g = turned ? graph(p, trial(p, 22, 40)) : graph(p, trial(p, 40, 22));
    const Vec2 x = turned ? Vec2{-0.975, -0.654} : Vec2{-0.654, -0.975};
    const DesignRow row = row_at(g, x);
    EXPECT_GT(row.contact_ratio, 1.2);
    EXPECT_LT(row.contact_ratio_true, 0.6);
    EXPECT_LT(g.margin(x[0], x[1]), 0.0);
    EXPECT_LT(margin_by_numbers(g, x[0], x[1]), 0.0);
    p.limits.contact_ratio = 0.55;  // for the path between the tips and the clipped path
    EXPECT_GT(graph(p, g.trial()).margin(x[0], x[1]), 0.0);
    p.limits.contact_ratio = 1.0;
  }
}

// 60:60 teeth without a lower limit: for some sums, the extended centre distance is below the sum
// of the base radii. Each shift is within its limits and the centre distance within the band, but
// Eq. 10 has no value.
TEST(ShiftGraph, NoWorkingAngleIsNoContact) {
  SearchProblem p;
  p.center_distance = {{55.0, 55.5}};
  const ShiftGraph g = graph(p, trial(p, 60, 60));
  ASSERT_LT(g.gears()[0].x_min + g.gears()[1].x_min, -4.6);
  EXPECT_TRUE(g.feasible_sums().empty());
  EXPECT_EQ(g.what_kills(), Limit::contact_ratio);
}

}  // namespace
}  // namespace gearwright
