#include "gearwright/figure/shift_region.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/report/testing/sample_search.hpp"

namespace gearwright {
namespace {

constexpr double kAspect = 1.25;
const Bounds kDrawnLimits{{-0.6, -0.6}, {1.0, 1.0}};

void expect_holds(const RegionWindow& w, const Bounds& box) {
  EXPECT_LT(w.box.lo.x(), box.lo.x());
  EXPECT_LT(w.box.lo.y(), box.lo.y());
  EXPECT_GT(w.box.hi.x(), box.hi.x());
  EXPECT_GT(w.box.hi.y(), box.hi.y());
  EXPECT_NEAR(w.box.size().x() / w.box.size().y(), kAspect, 1e-9);
}

TEST(ShiftRegionWindow, HoldsTheRegionInItsShape) {
  for (const Bounds& region : {Bounds{{-0.6, -0.6}, {1.0, 1.0}}, Bounds{{0.0, 0.1}, {0.9, 0.2}},
                               Bounds{{0.3, -0.4}, {0.35, 0.9}}}) {
    const RegionWindow w = region_window(kDrawnLimits, region, kAspect, 0.5);
    EXPECT_FALSE(w.zoomed);
    expect_holds(w, region);
    expect_holds(w, kDrawnLimits);
  }
  const Bounds small{{0.30, 0.20}, {0.31, 0.205}};
  const RegionWindow w = region_window(kDrawnLimits, small, kAspect, 0.5);
  EXPECT_TRUE(w.zoomed);
  expect_holds(w, small);
  EXPECT_LT(w.box.size().y(), 0.03);
}

TEST(ShiftRegionWindow, APointHasAWindowToo) {
  const Bounds point{{-0.5, -0.5}, {-0.5, -0.5}};
  for (const Bounds& limits : {kDrawnLimits, point}) {
    const RegionWindow w = region_window(limits, point, kAspect, 0.5);
    expect_holds(w, point);
    EXPECT_GT(w.box.size().y(), 1e-5);
  }
}

// For every kind of mounting, the pair has the centre distance whose line is drawn.
TEST(ShiftRegionWindow, SumsOfDistances) {
  const Bounds wide{{-2.0, -2.0}, {2.0, 2.0}};
  int drawn = 0;
  for (const auto& sample :
       {testing::spur_search(), testing::pareto_search(), testing::ring_search(),
        testing::crossed_search(), testing::helical_search()}) {
    const DesignRow& row = sample.answer->designs.front();
    const ShiftGraph graph = sample.search->graph(row.trial);
    for (const double more : {-0.4, 0.0, 0.3}) {
      const double a = row.center_distance + more * row.trial.module;
      const auto sum = sum_at_distance(graph, a, wide);
      if (!sum) continue;
      EXPECT_NEAR(row.trial.module * std::abs(graph.place(*sum).a), a, 1e-11 * a);
      ++drawn;
    }
    EXPECT_NEAR(*sum_at_distance(graph, row.center_distance, wide), row.shift[0] + row.shift[1],
                1e-10);
    EXPECT_FALSE(sum_at_distance(graph, 10.0 * row.center_distance, wide));
  }
  EXPECT_GE(drawn, 12);
}

}  // namespace
}  // namespace gearwright
