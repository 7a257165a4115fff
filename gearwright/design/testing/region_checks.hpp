// Checks of a region of shifts. The area within its boundary is compared with the area of a fine
// grid of points at which the pair meets all limits.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gearwright/design/shift_region.hpp"
#include "gearwright/design/testing/search_reference.hpp"

namespace gearwright::testing::search {

inline double signed_area(const std::vector<RegionEdge>& loop) {
  double twice = 0.0;
  for (const RegionEdge& edge : loop)
    for (std::size_t i = 1; i < edge.points.size(); ++i)
      twice +=
          edge.points[i - 1][0] * edge.points[i][1] - edge.points[i][0] * edge.points[i - 1][1];
  return twice / 2.0;
}

// Computes the area from a grid of grid × grid points at which the pair meets all limits.
inline void expect_area_of_a_grid(const ShiftGraph& g, const ShiftRegion& region, Random& random,
                                  int grid, double within) {
  // Points are (Σ, x1), with dx1 dx2 = dΣ dx1.
  const double from = region.sums.front().lo - 0.01;
  const double to = region.sums.back().hi + 0.01;
  const double x_from = g.gears()[0].x_min - 0.01;
  const double x_to = std::max(g.gears()[0].x_max, g.slice((from + to) / 2.0).hi) + 0.01;
  int hits = 0;
  int rows = 0;
  for (int i = 0; i < grid; ++i) {
    const double sum = from + (to - from) * (i + 0.5) / grid;
    const int before = hits;
    const double start =
        random.uniform(0.0, 1.0);  // without this offset, an edge x1 = const has the same error in
                                   // all rows
    for (int k = 0; k < grid; ++k) {
      const double x1 = x_from + (x_to - x_from) * (k + start) / grid;
      if (margin_by_numbers(g, x1, sum - x1) >= 0.0) ++hits;
    }
    if (hits > before) ++rows;
  }
  const double cell = (to - from) * (x_to - x_from) / grid / grid;
  // The standard deviation of the count of a row is at most half a point. The tolerance is four
  // standard deviations of the total, plus half a row at each end of Σ for every piece.
  const auto pieces = static_cast<double>(region.sums.size());
  const double doubt = cell * (2.0 * std::sqrt(rows) + pieces * static_cast<double>(hits) / rows);
  EXPECT_NEAR(hits * cell, region.area, doubt) << g.trial().z1 << ":" << g.trial().z2;
  EXPECT_LT(doubt, within * region.area);
}

}  // namespace gearwright::testing::search
