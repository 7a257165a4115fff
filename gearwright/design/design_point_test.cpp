// The point of a design. Laws: (1) it is within all limits, and for most designs away from the
// borders; (2) if the point of balanced strength (Eq. 11) with Σ = 0 lies well inside, it is
// chosen; (3) the row does not depend on whether the region is computed; (4) a gap is negative if
// and only if a corner of the mounted pair cuts into a fillet.
#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/design/design_row.hpp"
#include "gearwright/design/fillet_gap.hpp"
#include "gearwright/design/search.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {
namespace {

SearchProblem wish(Mounting mounting, bool exclude) {
  SearchProblem p;
  p.ratio = {1.5, 4.0};
  p.center_distance = {{99.0, 101.0}};
  p.modules = {1.5, 2.0, 3.0, 4.0};
  p.pinion_teeth = {10, 45};
  p.mounting = mounting;
  p.limits.avoid_interference = p.limits.clear_fillets = exclude;
  if (exclude) {
    p.limits.tip_clearance = kRunningTipClearance;
    p.limits.form_clearance = kRunningFormClearance;
  }
  return p;
}

TEST(DesignPoint, StandsOffTheWalls) {
  for (const Mounting mounting : {Mounting::extended, Mounting::tight}) {
    const Search search(wish(mounting, true));
    std::vector<DesignRow> rows;
    search.range(0, *search.space().size(), rows);
    ASSERT_GT(rows.size(), 50u);
    int far = 0;
    for (const DesignRow& row : rows) {
      const ShiftGraph graph = search.graph(row.trial);
      const Vec2 x{row.shift[0], row.shift[1]};
      EXPECT_GE(graph.margin(x[0], x[1]), -1e-9) << row.trial.index;  // (1)
      const double off = graph.wall_distance(x[0], x[1]);
      EXPECT_GE(off, row.balanced ? 1e-10 : -1e-11) << row.trial.index;
      far += off >= kWallDistance - 1e-9;
      EXPECT_FALSE(row.interference);
      EXPECT_FALSE(fillet_is_cut(graph, x));
      // (2)
      const Vec2 even = balanced_point(row.trial.z1, row.trial.z2, 0.0, 0.625);
      const ShiftGraph::Sums range = graph.sums();
      if (range.lo <= 0.0 && range.hi >= 0.0 &&
          graph.wall_distance(even[0], even[1]) >= kWallDistance && !fillet_is_cut(graph, even)) {
        EXPECT_EQ(x, even);
      }
    }
    EXPECT_GT(2 * far, static_cast<int>(rows.size()));
  }
}

TEST(DesignPoint, TheRegionChangesNothingOfTheRow) {  // (3)
  for (const Mounting mounting : {Mounting::extended, Mounting::tight}) {
    for (const bool exclude : {false, true}) {
      const Search search(wish(mounting, exclude));
      std::vector<DesignRow> rows;
      std::vector<DesignRow> points;
      const std::int64_t size = *search.space().size();
      const SearchCounts counts = search.range(0, size, rows);
      EXPECT_EQ(search.range(0, size, points, {.detail = RegionDetail::point}), counts);
      ASSERT_EQ(points.size(), rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_FALSE(points[i].whole);
        EXPECT_EQ(points[i].shift, rows[i].shift) << i;
        EXPECT_EQ(points[i].balanced, rows[i].balanced) << i;
        EXPECT_EQ(points[i].contact_ratio_true, rows[i].contact_ratio_true) << i;
        const DesignRow whole = search.whole(points[i]);
        EXPECT_TRUE(whole.whole);
        EXPECT_EQ(whole.area, rows[i].area) << i;
        EXPECT_EQ(whole.lo, rows[i].lo) << i;
      }
    }
  }
}

Gear gear(const TrialGear& g, Angle helix, double x) {
  CylindricalSpec s =
      testing::plain_spec({.teeth = g.teeth, .module = 1.0, .x = x, .face_width = 10.0});
  s.helix_angle = helix;
  return testing::taken(make_gear(s));
}

// Random shifts at tight and extended centres, for spur and helical gears. If the gap is near 0,
// both results are accepted.
TEST(FilletGap, HasTheSignOfThePairsClearance) {  // (4)
  int cut = 0;
  int clear = 0;
  for (const Mounting mounting : {Mounting::extended, Mounting::tight}) {
    SearchProblem p = wish(mounting, true);
    p.center_distance.reset();
    p.modules = {1.0};
    p.helix = {Angle(), Angle::degrees(25)};
    for (SearchRacks& racks : p.racks) {
      for (const std::size_t i : {0, 1}) {
        const StraightRack& r = racks.rack[i];
        racks.flank_depth[i] =
            r.dedendum - r.root_fillet_radius * (1.0 - std::sin(p.normal_pressure_angle.rad()));
      }
    }
    const Search search(p);
    const std::int64_t size = *search.space().size();
    for (std::int64_t i = 0; i < size; i += size / 60) {
      const Trial t = search.space().trial(i);
      if (t.z1 < 18) continue;  // undercut gears are outside the domain
      const ShiftGraph graph = search.graph(t);
      for (const double sum : {-0.3, 0.4, 1.0, 1.6, 2.2}) {
        const Vec2 x = balanced_point(t.z1, t.z2, sum, 0.625);
        const auto gap = fillet_gap(graph, x);
        if (!gap || std::abs(*gap) < 2e-4) continue;
        const ParallelPair pair = testing::taken(
            mount_as<ParallelPair>(gear(graph.gears()[0], t.helix[0], x[0]),
                                   gear(graph.gears()[1], t.helix[1], x[1]), {graph.place(sum).a}));
        const auto c_1 = fillet_clearance(pair, 1);
        const auto c_2 = fillet_clearance(pair, 2);
        const double least = std::min(c_1.value_or(1.0), c_2.value_or(1.0));
        EXPECT_EQ(*gap < 0.0, least < 0.0)
            << t.z1 << ":" << t.z2 << " Σx " << sum << ", gap " << *gap << ", clearance " << least;
        ++(least < 0.0 ? cut : clear);
      }
    }
  }
  EXPECT_GT(cut, 10);
  EXPECT_GT(clear, 100);
}

}  // namespace
}  // namespace gearwright
