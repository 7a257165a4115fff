// Strength of designs. Laws: (1) the closed forms give the pair that is cut and mounted, with the
// same safety factors; (2) a search with required safety factors finds the designs of the search
// without them, except for those whose factors are too low; (3) lists by mass and by safety are
// sorted; (4) the number of designs does not increase with the load; (5) the face width is the
// smallest of its band that is sufficient for the nominal values and at the tolerance ends, and at
// most two drawings are checked to find it.
#include "gearwright/design/design_strength.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "gearwright/design/testing/found_designs.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright {
namespace {

using testing::search::load;

SearchProblem wish(double torque = 300.0) {
  SearchProblem p;
  p.ratio = {1.5, 4.0};
  p.modules = {1.5, 2.0, 3.0};
  p.pinion_teeth = {14, 40};
  p.center_distance = {{90.0, 110.0}};
  p.helix = {Angle(), Angle::degrees(12)};
  p.limits.avoid_interference = p.limits.clear_fillets = true;
  p.limits.tip_clearance = kRunningTipClearance;
  p.limits.form_clearance = kRunningFormClearance;
  p.rating = load(torque);
  return p;
}

void expect_same(double got, double want, const DesignRow& row) {
  EXPECT_LE(std::abs(got - want), 1e-12 * std::max(1.0, std::abs(want))) << row.trial.index;
}

void expect_mounted(const SearchProblem& problem, std::size_t least) {
  const Search search(problem);
  const auto rows = testing::search::points_of(problem);
  ASSERT_GE(rows.size(), least);
  constexpr std::size_t kSome = 60;  // mounting is slow
  const std::size_t step = std::max<std::size_t>(1, rows.size() / kSome);
  for (std::size_t n = 0; n < rows.size(); n += step) {
    const DesignRow& row = rows[n];
    const ShiftGraph graph = search.graph(row.trial);
    const auto fast = pair_of_design(graph, row);
    const auto mounted = mounted_design(graph, row);
    ASSERT_TRUE(fast && mounted) << row.trial.index;
    for (const auto member :
         {&RatedPair::normal_module, &RatedPair::alpha_n, &RatedPair::beta, &RatedPair::alpha_t,
          &RatedPair::alpha_wt, &RatedPair::beta_b, &RatedPair::center_distance, &RatedPair::u,
          &RatedPair::face_width, &RatedPair::epsilon_alpha, &RatedPair::epsilon_beta})
      expect_same((*fast).*member, (*mounted).*member, row);
    for (const std::size_t i : {0, 1}) {
      for (const auto member :
           {&RatedGear::reference_diameter, &RatedGear::base_diameter, &RatedGear::tip_diameter,
            &RatedGear::tip_form_diameter, &RatedGear::root_diameter, &RatedGear::tooth_height,
            &RatedGear::profile_shift, &RatedGear::generating_shift, &RatedGear::virtual_teeth,
            &RatedGear::face_width})
        expect_same(fast->gears[i].*member, mounted->gears[i].*member, row);
      for (const auto member : {&RootTool::addendum, &RootTool::dedendum, &RootTool::fillet})
        expect_same(fast->gears[i].tool.*member, mounted->gears[i].tool.*member, row);
      EXPECT_EQ(fast->gears[i].teeth, mounted->gears[i].teeth);
    }
    const Rating r = rate(*mounted, problem.rating->input).value();
    for (const std::size_t i : {0, 1}) {
      expect_same(*row.flank_safety[i], r.S_H[i].value, row);
      expect_same(*row.root_safety[i], r.S_F[i].value, row);
    }
  }
}

TEST(DesignStrength, IsThatOfTheMountedPair) {  // (1)
  expect_mounted(wish(), 100);
  SearchProblem tight = wish();
  tight.mounting = Mounting::tight;
  tight.shorten_tips = true;
  expect_mounted(tight, 100);
  SearchProblem interfering = wish();
  interfering.limits = {};
  interfering.limits.undercut_margin = -0.3;
  interfering.pinion_teeth = {9, 18};
  expect_mounted(interfering, 100);
  SearchProblem rings = wish();
  rings.ratio = {-5.0, -3.0};
  rings.modules = {2.0};
  rings.helix = {Angle()};
  rings.pinion_teeth = {16, 22};
  rings.center_distance.reset();
  expect_mounted(rings, 10);
  SearchProblem shifted = rings;  // both shifts, another module, helical, thin tips
  shifted.modules = {1.5, 3.0};
  shifted.helix = {Angle::degrees(14)};
  shifted.center_distance = {{28.0, 60.0}};
  shifted.limits.min_shift = 0.1;
  shifted.limits.max_shift = 0.9;
  expect_mounted(shifted, 20);
  SearchProblem small = wish();  // every cutter for these wheels would remove a part of the flanks
  small.ratio = {-2.2, -2.0};
  small.helix = {Angle()};
  small.pinion_teeth = {17, 18};
  small.center_distance.reset();
  expect_mounted(small, 10);
  // With a pressure angle of 25°, the fillet radius of the default rack does not fit.
  rings.normal_pressure_angle = Angle::degrees(25);
  rings.ratio = {-3.5, -3.3};
  rings.helix = {Angle::degrees(8)};
  expect_mounted(rings, 3);
  SearchProblem steep = wish();
  steep.normal_pressure_angle = Angle::degrees(25);
  steep.limits = interfering.limits;
  steep.pinion_teeth = {9, 14};
  expect_mounted(steep, 50);
}

// Work counter: an internal gear is cut once for all modules and pinions, not for every design.
TEST(DesignStrength, RingsAreCutOnce) {
  SearchProblem p = wish();
  p.ratio = {-4.0, -2.5};
  p.modules = {1.5, 2.0, 3.0};
  p.helix = {Angle()};
  p.pinion_teeth = {17, 25};
  p.center_distance.reset();
  const Search search(p);
  std::vector<DesignRow> rows;
  search.range(0, *search.space().size(), rows, {.detail = RegionDetail::point});
  std::set<std::pair<int, double>> wheels;
  for (const DesignRow& row : rows) wheels.emplace(row.trial.z2, row.shift[1]);
  EXPECT_GT(rows.size(), 500u);
  EXPECT_EQ(search.problem().rating->ring_cuts->size(), wheels.size());
}

TEST(DesignStrength, SafetiesTakeAwayWhatFallsShort) {  // (2)
  const SearchProblem all = wish();
  SearchProblem some = all;
  some.limits.safety_flank = 1.1;
  some.limits.safety_root = 1.4;
  std::vector<DesignRow> rest = testing::search::points_of(all);
  const auto count = rest.size();
  std::erase_if(rest, [&](const DesignRow& row) { return short_of(some, row).has_value(); });
  const auto kept = testing::search::points_of(some);
  ASSERT_EQ(kept.size(), rest.size());
  ASSERT_GT(kept.size(), 0u);
  ASSERT_LT(kept.size(), count);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(kept[i].trial.index, rest[i].trial.index);
    EXPECT_EQ(kept[i].shift, rest[i].shift);
    EXPECT_GE(*least_safety(some, kept[i]), 1.0);
  }
  const Search search(some);
  std::vector<DesignRow> rows;
  const SearchCounts counts = search.range(0, *search.space().size(), rows);
  EXPECT_EQ(counts.feasible, static_cast<std::int64_t>(kept.size()));
  EXPECT_EQ(counts.rejected[static_cast<std::size_t>(Limit::safety_flank)] +
                counts.rejected[static_cast<std::size_t>(Limit::safety_root)],
            static_cast<std::int64_t>(count - kept.size()));
  // feasible() accepts every trial that has a design with sufficient safety factors.
  for (const DesignRow& row : kept) EXPECT_TRUE(search.feasible(row.trial));
  for (const DesignRow& row : rows) EXPECT_TRUE(row.whole);
}

TEST(DesignStrength, RanksByMassAndSafety) {  // (3)
  for (const Objective objective : {Objective::mass, Objective::safety}) {
    SearchProblem p = wish();
    p.objectives = {objective};
    BestDesigns best(p, 1000);
    for (const DesignRow& row : testing::search::points_of(p)) best.add(row);
    const SearchAnswer answer = std::move(best).answer({});
    double last = -1e300;
    for (const DesignRow& row : answer.designs) {
      if (!row.balanced) break;
      const double c = *cost(p, row, objective);
      EXPECT_GE(c, last - 1e-9);
      last = c;
    }
    EXPECT_GT(last, -1e300);
  }
}

TEST(DesignStrength, MoreLoadLeavesFewer) {  // (4)
  std::size_t before = 1'000'000;
  for (const double torque : {100.0, 300.0, 600.0, 1200.0}) {
    SearchProblem p = wish(torque);
    p.limits.safety_flank = 1.0;
    p.limits.safety_root = 1.4;
    const std::size_t now = testing::search::points_of(p).size();
    EXPECT_LE(now, before) << torque;
    before = now;
  }
  EXPECT_EQ(before, 0u);
}

// The pair with its teeth cut 0.1 modules deeper, as at one end of a wide tolerance.
RatedPair thin_teeth(const SearchProblem& p, const DesignRow& row) {
  RatedPair pair = mounted_design(Search(p).graph(row.trial), row).value();
  for (RatedGear& gear : pair.gears) gear.generating_shift -= 0.1;
  return pair;
}

bool thin_teeth_hold(const SearchProblem& p, const RatedPair& pair) {
  const auto rating = rate(pair, p.rating->input);
  return rating && holds(*rating, {*p.limits.safety_flank, *p.limits.safety_root});
}

// The search for a face width also terminates if only the verdict rejects a width.
TEST(DesignStrength, AFaceIsAsWideAsItsWorstTeethNeed) {  // (5)
  SearchProblem p = wish(100.0);
  p.helix = {Angle::degrees(12)};
  p.pinion_teeth = {17, 24};
  p.face_width = {{10.0, 60.0}};
  p.limits.safety_flank = 0.8;
  p.limits.safety_root = 2.2;
  std::vector<DesignRow> nominal = testing::search::points_of(p);
  std::map<std::int64_t, int> drawings;
  p.draw = [&](const SearchProblem& problem, const DesignRow& row) {
    ++drawings[row.trial.index];
    DrawnDesign drawn;
    const RatedPair pair = thin_teeth(problem, row);
    drawn.runs = thin_teeth_hold(problem, pair);
    if (!drawn.runs) drawn.at_ends = {pair};
    return drawn;
  };
  const std::vector<DesignRow> rows = testing::search::points_of(p);
  ASSERT_GT(rows.size(), 10u);
  std::size_t wider = 0;
  for (const DesignRow& row : rows) {
    EXPECT_TRUE(row.runs);
    EXPECT_LE(drawings[row.trial.index], 2) << row.trial.index;
    const RatedPair thin = thin_teeth(p, row);
    EXPECT_TRUE(thin_teeth_hold(p, thin)) << row.trial.index;
    const auto same = std::find_if(nominal.begin(), nominal.end(), [&](const DesignRow& other) {
      return other.trial.index == row.trial.index;
    });
    ASSERT_NE(same, nominal.end());
    EXPECT_LE(same->face_width, row.face_width);
    if (same->face_width == row.face_width) continue;
    ++wider;
    EXPECT_FALSE(thin_teeth_hold(p, with_face_width(thin, row.face_width - 1.0)))
        << row.trial.index;
  }
  EXPECT_GT(wider, 5u);
}

// Every trial that the verdict rejects is also counted for its finding.
TEST(DesignStrength, RejectedDrawingsAreCountedByFinding) {
  SearchProblem p = wish();
  std::set<std::uint64_t> thin, jams;  // indices of trials; a trial may be drawn several times
  p.draw = [&](const SearchProblem&, const DesignRow& row) {
    DrawnDesign drawn;
    drawn.runs = row.trial.z1 % 3 == 0;
    if (drawn.runs) return drawn;
    const bool jam = row.trial.z1 % 3 == 1;
    (jam ? jams : thin).insert(static_cast<std::uint64_t>(row.trial.index));
    drawn.finding = jam ? WarningCode::jam : WarningCode::thin_tip;
    return drawn;
  };
  const Search search(p);
  std::vector<DesignRow> rows;
  const SearchCounts counts =
      search.range(0, *search.space().size(), rows, {.detail = RegionDetail::point});
  ASSERT_FALSE(jams.empty());
  ASSERT_FALSE(thin.empty());
  const auto jammed = static_cast<std::int64_t>(jams.size());
  const auto thinned = static_cast<std::int64_t>(thin.size());
  EXPECT_EQ(counts.rejected[static_cast<std::size_t>(Limit::verdict)], jammed + thinned);
  EXPECT_EQ(counts.findings[static_cast<std::size_t>(WarningCode::jam)], jammed);
  EXPECT_EQ(counts.findings[static_cast<std::size_t>(WarningCode::thin_tip)], thinned);
  SearchCounts twice = counts;
  twice += counts;
  EXPECT_EQ(twice.findings[static_cast<std::size_t>(WarningCode::jam)], 2 * jammed);
  for (const DesignRow& row : rows) EXPECT_FALSE(row.finding);
}

TEST(DesignStrength, MassOfFullCylinders) {
  SearchProblem p = wish();
  p.pinion_teeth = {20, 20};
  p.ratio = {2.0, 2.0};
  p.modules = {3.0};
  p.helix = {Angle()};
  p.face_width = {{30.0, 30.0}};
  const auto rows = testing::search::points_of(p);
  ASSERT_EQ(rows.size(), 1u);
  // h_a 1, h_f 1.25: the mean diameter is d − 0.25 m + 2 m x.
  double mass = 0.0;
  for (const std::size_t i : {0, 1}) {
    const double d = 3.0 * (i == 0 ? 20 : 40) - 0.75 + 6.0 * rows[0].shift[i];
    mass += 7.83e-6 * 30.0 * 3.14159265358979 / 4 * d * d;
  }
  EXPECT_NEAR(rows[0].mass, mass, 1e-12 * mass);
}

}  // namespace
}  // namespace gearwright
