// Internal pairs of a search without a centre distance. Interference excludes a range of sums
// around 0 that is narrower than the distance of the nodes, so the region consists of two pieces.
#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/design/shift_region.hpp"
#include "gearwright/design/testing/region_checks.hpp"
#include "gearwright/design/testing/search_reference.hpp"

namespace gearwright {
namespace {

using testing::search::expect_area_of_a_grid;
using testing::search::graph;
using testing::search::Random;
using testing::search::signed_area;
using testing::search::trial;

SearchProblem internal_problem(int z1, int z2, Mounting mounting) {
  SearchProblem p;
  p.ratio = {static_cast<double>(z2) / z1, static_cast<double>(z2) / z1};
  p.pinion_teeth = {z1, z1};
  p.modules = {1.0};
  p.mounting = mounting;
  p.limits.avoid_interference = true;
  p.limits.form_clearance = kRunningFormClearance;
  p.limits.tip_clearance = kRunningTipClearance;
  return p;
}

TEST(ShiftRegionInternal, IsInTwoPiecesWhereInterferenceParts) {
  for (const Mounting mounting : {Mounting::tight, Mounting::extended}) {
    const SearchProblem p = internal_problem(22, -66, mounting);
    const ShiftGraph g = graph(p, trial(p, 22, -66));
    const auto region = shift_region(g);
    ASSERT_TRUE(region);
    ASSERT_EQ(region->sums.size(), 2u);
    EXPECT_LT(region->sums[0].hi, 0.0);
    EXPECT_GT(region->sums[1].lo, 0.0);
    Random random(31);
    expect_area_of_a_grid(g, *region, random, 300, 0.05);
  }
}

TEST(ShiftRegionInternal, HasTheAreaOfItsBoundaryAtEverySize) {
  int in_pieces = 0;
  int regions = 0;
  for (int z1 = 14; z1 <= 44; z1 += 5) {
    for (int more = 12; more <= 132; more += 20) {
      for (const Mounting mounting : {Mounting::tight, Mounting::extended}) {
        const SearchProblem p = internal_problem(z1, -z1 - more, mounting);
        const ShiftGraph g = graph(p, trial(p, z1, -z1 - more));
        const auto region = shift_region(g);
        EXPECT_EQ(region.has_value(), !g.what_kills());
        if (!region) continue;
        ++regions;
        if (region->sums.size() > 1) ++in_pieces;
        double around = 0.0;
        for (const auto& loop : region_boundary(g, *region)) {
          EXPECT_GE(signed_area(loop), -1e-12) << z1 << " " << more;
          around += signed_area(loop);
          for (const RegionEdge& edge : loop)
            for (const Vec2& x : edge.points) {
              // Near the sum at which the working angle vanishes, N grows as the square root of Σ,
              // so rounding of Σ is visible.
              const SumPlace place = g.place(x[0] + x[1]);
              if (std::abs(place.N) < 1e-4 * std::abs(place.a)) continue;
              // If both ends of a slice coincide, the error of x1 is the square root of the
              // rounding error of Σ.
              const ShiftSlice slice = g.slice(x[0] + x[1]);
              EXPECT_NEAR(g.wall_distance(x[0], x[1]), 0.0,
                          slice.hi - slice.lo < 2e-6 ? 1e-6 : 1e-9)
                  << z1 << " " << more << " " << name(edge.edge) << " at " << x.transpose();
            }
        }
        EXPECT_NEAR(around, region->area, 6e-3 * region->area + 1e-9) << z1 << " " << more;
        const Vec2 x = chosen_point(g, *region);
        EXPECT_GE(g.margin(x[0], x[1]), -kTouching) << z1 << " " << more;
      }
    }
  }
  EXPECT_GT(regions, 60);
  EXPECT_GT(in_pieces, 40);
}

}  // namespace
}  // namespace gearwright
