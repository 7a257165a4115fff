#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearwright/design/search.hpp"

namespace gearwright {
namespace {

// At some sums of shifts, the limits on interference give no bound, which means that the bound lies
// at infinity. The search for a corner between such an edge and the edge of sliding must still end.
TEST(SearchEnds, WhereAnEdgeStopsBounding) {
  SearchProblem p;
  p.ratio = {2.0, 6.0};
  p.center_distance = {{100.0, 100.2}};
  p.modules = {1.0, 1.25, 1.5, 2.0, 2.5, 3.0};
  p.pinion_teeth = {8, 60};
  p.coprime = true;
  p.limits.sliding = 2.5;
  p.limits.avoid_interference = true;
  p.helix.clear();
  for (int i = 0; i <= 8; ++i)
    p.helix.push_back(Angle::radians(0.5 * i * std::numbers::pi / 180.0));
  const Search search(p);
  std::vector<DesignRow> rows;
  const SearchCounts counts = search.range(0, *search.space().size(), rows);
  EXPECT_GT(counts.feasible, 1000);
  for (const DesignRow& row : rows) EXPECT_TRUE(std::isfinite(row.area) && row.area >= -1e-12);
}

}  // namespace
}  // namespace gearwright
