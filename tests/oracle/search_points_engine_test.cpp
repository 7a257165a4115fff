// Compares the engine's shift graph with the plain pair. The same points must satisfy all limits in
// both.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/design/search.hpp"
#include "tests/oracle/plain_pair.hpp"
#include "tests/oracle/search_twin.hpp"

namespace gearwright::oracle {
namespace {

/// Points around the regions of random problems, classified as inside or outside by both.
void expect_same_points(TwinKind kind, unsigned seed, int points) {
  TwinRandom random(seed);
  int inside = 0;
  int outside = 0;
  int near = 0;
  int problems = 0;
  while (inside + outside + near < points) {
    Twin twin = random_twin(random, kind);
    share_doubles(twin);
    const SearchProblem problem = engine_problem(twin);
    const Search search(problem);
    if (search.space().size().value_or(0) == 0) continue;
    const Trial t = search.space().trial(0);
    const ShiftGraph graph = search.graph(t);
    if (++problems % 4 != 0 && graph.what_kills()) continue;  // mostly regions that are not empty
    const auto& [g_1, g_2] = graph.gears();
    if (g_1.x_min > g_1.x_max || g_2.x_min > g_2.x_max) continue;
    const auto sums = graph.feasible_sums();
    const double from = sums.empty() ? -0.8 : sums.front().lo - 0.05;
    const double to = sums.empty() ? 1.5 : sums.back().hi + 0.05;
    const plain::Pair pair(twin.plain, t.z1, t.z2);
    const Real a_lo = twin.center_distance[0] / Real(t.module);
    const Real a_hi = twin.center_distance[1] / Real(t.module);
    for (int i = 0; i < 50; ++i) {
      const double sum = random.uniform(from, to);
      double lo = g_1.x_min - 0.05;
      double hi = g_1.x_max + 0.05;
      // Half of the points are drawn near the region, where they may be inside. The other half is
      // drawn anywhere.
      if (i % 2 == 0 && !sums.empty()) {
        const double middle = std::clamp(sum, sums.front().lo, sums.back().hi);
        const ShiftSlice s = graph.slice(middle);
        lo = s.lo - 0.02;
        hi = s.hi + 0.02;
      }
      const double x1 = random.uniform(lo, hi);
      const double x2 = sum - x1;
      const double margin = graph.margin(x1, x2);
      const PlainPoint o = plain::look(pair, x1, x2);
      Real least = o.margins.min();
      if (std::isnan(o.centre_distance)) {
        least = -1;
      } else {
        least = std::min({least, o.centre_distance - a_lo, a_hi - o.centre_distance});
      }
      if (std::abs(margin) <= 1e-9) {
        ++near;
        continue;
      }
      ++(margin > 0.0 ? inside : outside);
      ASSERT_EQ(margin > 0.0, least > 0.0L)
          << t.z1 << ":" << t.z2 << " x " << x1 << " " << x2 << ": " << margin << " "
          << static_cast<double>(least) << " α " << problem.normal_pressure_angle.rad() << " β "
          << problem.helix[0].rad() << " problem " << problems;
    }
  }
  EXPECT_GT(inside, points / 10);
  EXPECT_GT(outside, points / 10);
  EXPECT_LT(near, points / 100);
}

TEST(SearchPoints, PointsOfExtendedPairs) { expect_same_points(TwinKind::extended, 61, 10'000); }
TEST(SearchPoints, PointsOfHelicalPairs) { expect_same_points(TwinKind::helical, 62, 10'000); }
TEST(SearchPoints, PointsOfTightPairs) { expect_same_points(TwinKind::tight, 63, 10'000); }
TEST(SearchPoints, PointsOfRings) { expect_same_points(TwinKind::ring, 64, 10'000); }
TEST(SearchPoints, PointsOfTightRings) { expect_same_points(TwinKind::tight_ring, 65, 10'000); }
TEST(SearchPoints, LongPointsOfEveryKind) {
  for (const TwinKind kind : kTwinKinds) expect_same_points(kind, 66, 400'000);
}

}  // namespace
}  // namespace gearwright::oracle
