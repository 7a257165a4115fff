// Tests laws of the plain search: its results agree with grids of points; regions that are a
// segment or a point; limits that just meet; and cases without a result.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/oracle/numbers.hpp"
#include "tests/oracle/plain_cells.hpp"
#include "tests/oracle/plain_search.hpp"

namespace gearwright::oracle {
namespace {

using Real = long double;
using enum PlainVerdict;

TEST(PlainSearchLaws, coprime_pairs_are_the_others_without_common_factors) {
  const PlainBand ratio{1.9L, 2.1L}, centres{59, 61};
  const PlainSearch all = plain_search({}, {2, 3}, ratio, {12, 25}, centres, false);
  const PlainSearch coprime = plain_search({}, {2, 3}, ratio, {12, 25}, centres, true);
  std::vector<PlainSearch::Design> kept;
  for (const auto& [m, z1, z2] : all.designs)
    if (std::gcd(z1, z2) == 1) kept.emplace_back(m, z1, z2);
  EXPECT_EQ(coprime.designs, kept);
  EXPECT_GT(all.designs.size(), kept.size());
  EXPECT_GT(all.tested, coprime.tested);
}

/// Problems of every kind: helices, internal gears, backlash-free centre distances, each optional
/// limit in some of them.
struct RandomTrial {
  PlainProblem problem;
  int z1, z2;
  Real c_min, c_max;

  explicit RandomTrial(std::mt19937& bits) {
    const auto uniform = [&](Real low, Real high) {
      return low + (high - low) * (bits() / 4294967296.0L);
    };
    const auto chance = [&](Real p) { return uniform(0, 1) < p; };
    const bool ring = chance(0.3L);
    z1 = int(uniform(8, 40));
    z2 = ring ? -int(uniform(z1 + 8, z1 + 80)) : int(uniform(z1, z1 + 60));
    PlainProblem& p = problem;
    p.alpha_n = uniform(17, 25) * kLongDegree;
    if (chance(0.4L)) p.beta = uniform(5, 30) * kLongDegree;
    if (ring || chance(0.6L)) p.floor = uniform(-0.7L, 0);
    if (ring || chance(0.6L)) p.ceil = uniform(0.3L, 1);
    p.undercut_margin = chance(0.3L) ? uniform(-0.1L, 0.2L) : 0;
    p.tip_thickness_min = uniform(0, 0.4L);
    p.contact_ratio_min = uniform(1, 1.7L);
    p.tight = chance(0.5L);
    if (chance(0.5L)) p.sliding_max = uniform(0.5L, 4);
    if (chance(0.4L)) p.clearance_min = uniform(0.15L, 0.249L);
    p.clip = chance(0.5L) ? PlainClip::usable_flanks : PlainClip::tangent_points;
    p.avoid_interference = chance(0.5L);
    const Real standard = std::abs(z1 + z2) / (2 * std::cos(p.beta));
    c_min = standard + uniform(-1, 1);
    c_max = chance(0.3L) ? c_min : c_min + uniform(0, 0.5L);
  }
};

// One limit is set at a time, so that its own bound is tested. The bound must converge to the
// margin.
TEST(PlainSearchLaws, bounds_of_cells_hold) {
  std::mt19937 bits(3);
  const auto uniform = [&](Real low, Real high) {
    return low + (high - low) * (bits() / 4294967296.0L);
  };
  std::array<int, 5> bound{};
  for (int t = 0; t < 1000; ++t) {
    RandomTrial trial(bits);
    PlainProblem& p = trial.problem;
    const int kind = t % 5;
    p.clip = kind == 0   ? PlainClip::none
             : kind == 1 ? PlainClip::tangent_points
                         : PlainClip::usable_flanks;
    if (kind > 1) p.contact_ratio_min = kind == 2 ? 1 : -100;
    p.sliding_max = kind == 3 ? std::optional(3.0L) : std::nullopt;
    p.clearance_min = kind == 4 && t % 2 == 0 ? std::optional(0.2L) : std::nullopt;
    p.avoid_interference = kind == 4 && t % 2 == 1;
    const plain::Pair pair(p, trial.z1, trial.z2);
    const auto pieces_1 = plain::shifts_1(pair), pieces_2 = plain::shifts_2(pair, -1, 1);
    if (pieces_1.held.empty() || pieces_2.held.empty()) continue;
    const plain::Interval domain = pair.shift_sum_domain();
    plain::Box box{{}, pieces_1.held[0], pieces_2.held[0]};
    box.s = {std::max(domain.low, box.x1.low + box.x2.low),
             std::min(domain.high, box.x1.high + box.x2.high)};
    if (box.s.low > box.s.high) continue;
    for (int repeat = 0; repeat < 6; ++repeat) {
      const Real sum = uniform(box.s.low, box.s.high);
      const Real x1 = uniform(box.x1_at(sum).low, box.x1_at(sum).high);
      const Real margin = plain::contact_margin(pair, x1, sum - x1);
      for (const Real size : {0.5L, 0.05L, 1e-9L, 0.0L}) {
        // A cell of that size that contains the point at a random position.
        const Real s_low = std::max(box.s.low, sum - size * uniform(0, 1));
        const Real x1_low = std::max(box.x1.low, x1 - size * uniform(0, 1));
        const plain::Cell cell{{s_low, std::min(box.s.high, std::max(sum, s_low + size))},
                               {x1_low, std::min(box.x1.high, std::max(x1, x1_low + size))}};
        const Real most = plain::upper_bound(pair, box, cell);
        ASSERT_GE(most, margin - 1e-15L) << "trial " << t << " size " << double(size);
        if (size > 0 || margin < -1e6L) continue;
        EXPECT_NEAR(most, margin, 1e-15L * (1 + std::abs(margin))) << "trial " << t;
        ++bound[kind];
      }
    }
  }
  for (const int n : bound) EXPECT_GT(n, 300);
}

/// `not_empty` must provide a point that satisfies all limits. `empty` is compared with a grid of
/// points.
void expect_true_verdicts(unsigned seed, int trials, int grid, int min_of_each) {
  std::mt19937 bits(seed);
  int with = 0, without = 0;
  std::map<std::string, int> killed;
  for (int t = 0; t < trials; ++t) {
    const RandomTrial trial(bits);
    const PlainProblem& p = trial.problem;
    const plain::Pair pair(p, trial.z1, trial.z2);
    const PlainAnswer answer = region_not_empty(p, 1, trial.z1, trial.z2, trial.c_min, trial.c_max);
    ASSERT_NE(answer.verdict, ambiguous) << "trial " << t;
    if (answer.verdict == not_empty) {
      ++with;
      const PlainPoint o = look(p, trial.z1, trial.z2, answer.x1, answer.x2);
      EXPECT_GE(o.margins.min(), -1e-15L) << "trial " << t;
      EXPECT_GE(o.centre_distance, trial.c_min - 1e-15L);
      EXPECT_LE(o.centre_distance, trial.c_max + 1e-15L);
      continue;
    }
    ++without;
    ++killed[answer.killed_by];
    const auto sums = pair.shift_sums({trial.c_min, trial.c_max});
    if (!sums) continue;
    for (int i = 0; i <= grid; ++i)
      for (int j = 0; j <= grid; ++j) {
        const Real sum = sums->at(i / Real(grid)), x1 = -1 + 3 * j / Real(grid);
        ASSERT_LT(plain::look(pair, x1, sum - x1).margins.min(), 0)
            << "trial " << t << " " << double(x1) << " " << double(sum);
      }
  }
  EXPECT_GE(with, min_of_each);
  for (const char* reason : {"center_distance", "contact_ratio", "other"})
    EXPECT_GE(killed[reason], min_of_each / 4) << reason;
  EXPECT_GE(without, min_of_each);
}

TEST(PlainSearchLaws, verdicts_stand_against_grids) { expect_true_verdicts(1, 200, 120, 40); }

TEST(PlainSearchLaws, LongVerdictsStandAgainstFineGrids) {
  expect_true_verdicts(2, 1000, 200, 200);
}

// 12:18 teeth at the backlash-free centre distance of Σx = 0.9, with hardly any limits of undercut
// and tip thickness. The specific sliding is balanced at x1 = 0.54239 (the source prints five
// digits).
TEST(PlainSearchLaws, balanced_sliding_is_the_least) {
  PlainProblem p;
  p.tight = true;
  const PlainPoint o = look(p, 12, 18, 0.54239L, 0.9L - 0.54239L);
  EXPECT_NEAR(o.zeta_A[0], o.zeta_E[1], 1e-4);
  for (const Real more : {-1e-3L, 1e-3L}) {
    p.sliding_max = std::abs(o.zeta_A[0]) + more;
    const PlainAnswer answer = region_not_empty(p, 1, 12, 18, o.centre_distance, o.centre_distance);
    EXPECT_EQ(answer.verdict, more > 0 ? not_empty : empty);
    EXPECT_EQ(answer.killed_by, more > 0 ? "" : "other");
  }
}

// An exact centre distance gives a segment, and equal lower and upper limits give a point. Both are
// regions.
TEST(PlainSearchLaws, segments_and_points_are_regions) {
  PlainProblem p;
  EXPECT_EQ(region_not_empty(p, 1, 20, 40, 30, 30).verdict, not_empty);
  const auto segment = measure_region(p, 1, 20, 40, 30, 30, 20);
  ASSERT_TRUE(segment);
  EXPECT_EQ(segment->area, 0);
  EXPECT_EQ(segment->s_lo, 0);
  EXPECT_EQ(segment->s_hi, 0);
  EXPECT_LT(segment->lo_edge[0][0], segment->lo_edge[1][0]);

  p.floor = p.ceil = 0.25L;
  EXPECT_EQ(region_not_empty(p, 1, 20, 40, 30, 31).verdict, not_empty);
  EXPECT_EQ(region_not_empty(p, 1, 20, 40, 30.5L, 30.5L).verdict, not_empty);
  const PlainAnswer beside = region_not_empty(p, 1, 20, 40, 30.6L, 31);
  EXPECT_EQ(beside.verdict, empty);
  EXPECT_EQ(beside.killed_by, "center_distance");

  p.floor = -0.6L;
  p.ceil = 1;  // module 2, 31:64: Σx = 2 is both the least of the band and the greatest of the sums
  const PlainAnswer corner = region_not_empty(p, 2, 31, 64, 99, 101);
  EXPECT_EQ(corner.verdict, not_empty);
  EXPECT_EQ(corner.x1, 1);
  EXPECT_EQ(corner.x2, 1);
}

TEST(PlainSearchLaws, limits_that_nearly_meet_are_ambiguous) {
  PlainProblem p;
  p.floor = -0.6L;
  p.ceil = 1;
  for (const Real nearly : {-1e-10L, 1e-10L})
    EXPECT_EQ(region_not_empty(p, 2, 31, 64, 99 + nearly, 101).verdict, ambiguous);
  EXPECT_EQ(region_not_empty(p, 2, 31, 64, 99 + 1e-8L, 101).verdict, empty);
  EXPECT_EQ(region_not_empty(p, 2, 31, 64, 99 - 1e-8L, 101).verdict, not_empty);

  // The greatest contact ratio on a segment, at equal tip pressure angles: x_1 = z_1(2 + S)/Σz − 1.
  PlainProblem ratio;
  const Real best = look(ratio, 24, 36, -0.2L, 0.2L).eps;
  ratio.contact_ratio_min = best;
  EXPECT_EQ(region_not_empty(ratio, 1, 24, 36, 30, 30).verdict, ambiguous);
  ratio.contact_ratio_min = best - 1e-8L;
  EXPECT_EQ(region_not_empty(ratio, 1, 24, 36, 30, 30).verdict, not_empty);
  ratio.contact_ratio_min = best + 1e-8L;
  const PlainAnswer none = region_not_empty(ratio, 1, 24, 36, 30, 30);
  EXPECT_EQ(none.verdict, empty);
  EXPECT_EQ(none.killed_by, "contact_ratio");
  EXPECT_NEAR(none.min_margin, -1e-8, 1e-10);
}

// At extended centres, the clearance is h_f − h_a for every shift.
TEST(PlainSearchLaws, clearance_of_extended_centres_is_the_same_everywhere) {
  PlainProblem p;
  p.clearance_min = 0.25L;
  EXPECT_EQ(region_not_empty(p, 1, 20, 40, 30, 31).verdict, ambiguous);
  p.clearance_min = 0.25L - 1e-8L;
  EXPECT_EQ(region_not_empty(p, 1, 20, 40, 30, 31).verdict, not_empty);
  p.clearance_min = 0.25L + 1e-8L;
  EXPECT_EQ(region_not_empty(p, 1, 20, 40, 30, 31).verdict, empty);
  EXPECT_EQ(region_not_empty(p, 1, 20, 40, 30, 31).killed_by, "other");
  p.tight = true;  // the clearance is smaller, except at Σx = 0
  p.clearance_min = 0.25L - 1e-4L;
  EXPECT_EQ(region_not_empty(p, 1, 20, 40, 29.9L, 30.1L).verdict, not_empty);
  EXPECT_EQ(region_not_empty(p, 1, 20, 40, 30.5L, 31).verdict, empty);
}

// 12:18 requires a thicker tooth than any shift of 12 teeth permits without undercut.
TEST(PlainSearchLaws, shift_limits_kill_first) {
  PlainProblem p;
  p.tip_thickness_min = 0.6L;
  EXPECT_EQ(region_not_empty(p, 1, 12, 18, 15, 16).killed_by, "shift_limits");
  EXPECT_EQ(region_not_empty(p, 1, 12, 18, 50, 51).killed_by, "shift_limits");
}

// A tip thickness limit can also limit the shift from below. Far below the reference circle the
// teeth are thick, but tips there end where the space is narrow.
TEST(PlainSearchLaws, thick_tips_bound_shifts_on_both_sides) {
  PlainProblem p;
  p.undercut_depth = -1;
  const plain::Pair pair(p, 60, 60);
  Real best = -1;
  for (Real x = -2.5L; x < 1; x += 0.001L)
    if (pair.tip_thickness(1, x) > pair.tip_thickness(1, best)) best = x;
  p.tip_thickness_min = pair.tip_thickness(1, best) - 0.001L;
  const auto held = plain::shifts_1(plain::Pair(p, 60, 60)).held;
  ASSERT_EQ(held.size(), 1u);
  EXPECT_LT(held[0].low, best);
  EXPECT_GT(held[0].high, best);
  for (const Real end : {held[0].low, held[0].high})
    EXPECT_NEAR(pair.tip_thickness(1, end), p.tip_thickness_min, 1e-15);
}

TEST(PlainSearchLaws, ratio_bands_are_closed_and_rings_negative) {
  const PlainSearch two = plain_search({}, {1}, {2, 2}, {18, 20}, {27, 30}, false);
  EXPECT_EQ(two.tested, 3);
  PlainProblem p;
  p.floor = -0.5L;
  p.ceil = 0.5L;
  const PlainSearch rings = plain_search(p, {1}, {-3.1L, -2.9L}, {20, 21}, {20, 22}, false);
  EXPECT_EQ(rings.tested, 5 + 5);  // 58 … 62, 61 … 65
  EXPECT_TRUE(rings.ambiguous.empty());
  EXPECT_FALSE(rings.designs.empty());
  for (const auto& [m, z1, z2] : rings.designs) EXPECT_LT(z2, -57);
}

TEST(PlainSearchLaws, what_makes_no_problem_is_refused) {
  EXPECT_THROW(look({}, 0, 18, 0, 0), std::invalid_argument);
  EXPECT_THROW(look({}, 18, -18, 0, 0), std::invalid_argument);
  EXPECT_THROW(look({.alpha_n = 0}, 18, 18, 0, 0), std::invalid_argument);
  EXPECT_THROW(look({.beta = kLongPi}, 18, 18, 0, 0), std::invalid_argument);
  EXPECT_THROW(look({.tip_thickness_min = -0.1L}, 18, 18, 0, 0), std::invalid_argument);
  EXPECT_THROW(region_not_empty({}, 1, 18, 18, 19, 18), std::invalid_argument);
  EXPECT_THROW(plain_search({}, {1}, {-1, 1}, {18, 18}, {18, 18}, false), std::invalid_argument);
}

// Below the sum of the base radii there is no path, and below the base circle there is no tip.
TEST(PlainSearchLaws, what_does_not_exist_is_outside) {
  const PlainPoint apart = look({}, 20, 20, -0.61L, -0.61L);  // domain: S ≥ −1.206
  EXPECT_TRUE(std::isnan(apart.eps));
  EXPECT_TRUE(std::isnan(apart.eps_true));
  EXPECT_EQ(apart.margins.eps, -PlainMargins::kFree);
  EXPECT_EQ(apart.margins.eps_true, -PlainMargins::kFree);
  EXPECT_FALSE(std::isnan(look({}, 20, 20, -0.6L, -0.6L).eps));
  const PlainPoint stub = look({}, 20, 20, -1.7L, 1.7L);
  EXPECT_TRUE(std::isnan(stub.tip_thickness[0]));
  EXPECT_EQ(stub.margins.s1max, -PlainMargins::kFree);
  PlainProblem p;
  p.sliding_max = 100;
  const PlainPoint beyond = look(p, 12, 100, 0, 0);  // the wheel's tip passes T_1
  EXPECT_LT(beyond.rho_1A, 0);
  EXPECT_EQ(beyond.margins.sliding, -PlainMargins::kFree);
}

}  // namespace
}  // namespace gearwright::oracle
