// Lanes against the scalar instance and both against the scalar formulas of the pair. Laws:
// (1) lanes agree with the scalar instance to 1e-12; (2) verdicts are the same but where the sieve
// asks; (3) a verdict is that of the graph.
#include "gearwright/design/candidate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "gearwright/design/testing/search_reference.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {
namespace {

using testing::search::graph;
using testing::search::Random;
using testing::search::trial;
using Batch = CandidateBatch;

constexpr double kLanes = 1e-12;  // law (1), of 1 + |value|
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Mode {
  const char* name;
  bool ring, tight;
};
constexpr std::array<Mode, 4> kModes{
    {{"external", false, false}, {"ring", true, false}, {"tight", false, true}, {"tight_ring", true, true}}};

class CandidateOfMode : public ::testing::TestWithParam<Mode> {};
INSTANTIATE_TEST_SUITE_P(Modes, CandidateOfMode, ::testing::ValuesIn(kModes),
                         [](const auto& mode) { return std::string(mode.param.name); });

SearchProblem problem_of(const Mode& mode) {
  SearchProblem p;
  p.ratio = mode.ring ? std::array{-20.0, -1.0} : std::array{1.0, 20.0};
  p.mounting = mode.tight ? Mounting::tight : Mounting::extended;
  p.shorten_tips = mode.tight;
  return p;
}

CandidateConstants constants_of(const SearchProblem& p) {
  const SearchRacks& r = p.racks[0];
  return {std::tan(p.normal_pressure_angle),
          {r.rack[0].addendum, r.rack[1].addendum},
          {r.rack[0].dedendum, r.rack[1].dedendum},
          r.undercut_depth,
          p.mounting == Mounting::tight,
          p.shorten_tips};
}

void fill(Random& random, const Mode& mode, std::size_t from, std::size_t to, Batch& b) {
  for (std::size_t i = from; i < to; ++i) {
    const int z1 = random.whole(7, 60);
    b.in[Batch::z1][i] = z1;
    b.in[Batch::z2][i] = mode.ring ? -random.whole(z1 + 6, z1 + 150) : random.whole(z1, 160);
    b.in[Batch::sin_beta][i] = random.chance(0.5) ? 0.0 : std::sin(random.uniform(-0.6, 0.6));
    b.in[Batch::x1][i] = random.uniform(-0.6, 1.0);
    b.in[Batch::x2][i] = random.uniform(-0.6, 1.0);
  }
}

// ζ has no bound, 1/(1 + |ζ|) is the lesser part of the two curvature radii, to which a rounding
// of them is passed on as it is.
double compared(int column, double v) {
  return column == Batch::sliding ? 1.0 / (1.0 + std::abs(v)) : v;
}

TEST_P(CandidateOfMode, LanesAgreeWithTheScalarInstance) {  // (1)
  const Mode mode = GetParam();
  Random random(31);
  const CandidateConstants c = constants_of(problem_of(mode));
  Batch lanes;
  lanes.resize(250'000);
  fill(random, mode, 0, lanes.size(), lanes);
  Batch scalar = lanes;
  evaluate(c, lanes);
  evaluate_scalar(c, scalar);
  std::array<double, Batch::kOut> worst{};
  std::size_t compared_candidates = 0;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const double residual =
        std::max(lanes.out[Batch::residual][i], scalar.out[Batch::residual][i]);
    if (!(residual < 1e-12)) continue;
    ++compared_candidates;
    for (int k = 0; k < Batch::residual; ++k) {
      const double a = compared(k, lanes.out[static_cast<std::size_t>(k)][i]);
      const double b = compared(k, scalar.out[static_cast<std::size_t>(k)][i]);
      if (std::isnan(a) && std::isnan(b)) continue;
      const double off = a == b ? 0.0 : std::abs(a - b) / (1.0 + std::abs(b));
      auto& most = worst[static_cast<std::size_t>(k)];
      most = off <= most ? most : off;  // NaN stays
      ASSERT_LE(off, kLanes) << "column " << k << " of " << lanes.in[0][i] << ":" << lanes.in[1][i]
                             << " sin β " << lanes.in[2][i] << " x " << lanes.in[3][i] << " "
                             << lanes.in[4][i];
    }
  }
  EXPECT_GT(compared_candidates, lanes.size() * 8 / 10);  // sums without a working angle
  RecordProperty("worst_1e_15", std::to_string(*std::max_element(worst.begin(), worst.end()) / 1e-15));
}

TEST_P(CandidateOfMode, PartialVectorsAreWhole) {
  const Mode mode = GetParam();
  Random random(32);
  const CandidateConstants c = constants_of(problem_of(mode));
  Batch all;
  all.resize(17);
  fill(random, mode, 0, 17, all);
  evaluate(c, all);
  for (std::size_t n = 1; n <= 17; ++n) {
    Batch part = all;
    part.resize(n);
    for (auto& column : part.out) {
      column.assign(n, -77.0);
      column.reserve(64);
    }
    evaluate(c, part);
    for (std::size_t k = 0; k < Batch::kOut; ++k) {
      for (std::size_t i = 0; i < n; ++i) {
        const bool both_nan = std::isnan(part.out[k][i]) && std::isnan(all.out[k][i]);
        EXPECT_TRUE(both_nan || part.out[k][i] == all.out[k][i]) << n << " " << i << " " << k;
      }
    }
  }
  Batch none;
  evaluate(c, none);
  EXPECT_EQ(none.size(), 0u);
}

// The scalar instance against what a search prints: the pair's own formulas.
TEST_P(CandidateOfMode, NumbersAreThoseOfTheRow) {
  const Mode mode = GetParam();
  constexpr double kRow = 1e-11;
  Random random(33);
  const SearchProblem given = problem_of(mode);
  const CandidateConstants c = constants_of(given);
  Batch b;
  b.resize(10'000);
  fill(random, mode, 0, b.size(), b);
  evaluate_scalar(c, b);
  int rows = 0;
  int beyond_base = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const auto out = [&](Batch::Out k) { return b.out[k][i]; };
    // d tan α/d inv α = 1/tan² α: what the residual does to the working angle.
    if (!(out(Batch::residual) < 1e-14 * std::pow(out(Batch::tan_working), 2))) continue;
    if (std::isnan(out(Batch::contact_ratio)) || std::isnan(out(Batch::tip_1)) ||
        std::isnan(out(Batch::tip_2)))
      continue;
    SearchProblem p = given;
    p.helix = {std::asin(b.in[Batch::sin_beta][i])};
    const Trial t = trial(p, static_cast<int>(b.in[Batch::z1][i]),
                          static_cast<int>(b.in[Batch::z2][i]));
    const ShiftGraph g = graph(p, t);
    const DesignRow row = row_at(g, {b.in[Batch::x1][i], b.in[Batch::x2][i]});
    ++rows;
    const std::string what = std::to_string(t.z1) + ":" + std::to_string(t.z2) + " " +
                             std::to_string(b.in[Batch::x1][i]) + " " +
                             std::to_string(b.in[Batch::x2][i]);
    const auto near = [&](double value, double expected, const char* name) {
      EXPECT_NEAR(value, expected, kRow * (1.0 + std::abs(expected))) << name << " " << what;
    };
    near(out(Batch::center_distance), row.center_distance, "a");
    near(out(Batch::tan_working), std::tan(row.working_angle), "tan α_wt");
    near(out(Batch::contact_ratio), row.contact_ratio, "ε");
    near(out(Batch::contact_ratio_true), row.contact_ratio_true, "ε true");
    near(out(Batch::tip_1), row.tip_thickness[0], "s_an1");
    near(out(Batch::tip_2), row.tip_thickness[1], "s_an2");
    near(out(Batch::clearance_1), row.tip_clearance[0], "c1");
    near(out(Batch::clearance_2), row.tip_clearance[1], "c2");
    if (const auto zeta = row.greatest_sliding()) {
      near(1.0 / (1.0 + out(Batch::sliding)), 1.0 / (1.0 + *zeta), "ζ");
    } else {
      ++beyond_base;
      EXPECT_EQ(out(Batch::sliding), kInfinity) << what;
    }
    const double free = std::min(out(Batch::interference_1), out(Batch::interference_2));
    if (std::abs(free) > 1e-9) {
      EXPECT_EQ(row.interference, free < 0.0) << what;
    }
    if (mode.ring) {
      EXPECT_EQ(out(Batch::interference_2), kInfinity);
    }
  }
  EXPECT_GT(rows, 5000);
  EXPECT_GT(beyond_base, 10);
}

TEST(Candidate, WhatDoesNotExistIsNotANumber) {
  Batch b;
  b.resize(2);
  const double values[2][5] = {{20, 40, 0.0, -1.9, 0.0},   // tip inside the base circle
                               {40, 40, 0.0, -1.3, -1.3}};  // below the sum of the base radii
  for (std::size_t k = 0; k < 5; ++k)
    for (std::size_t i = 0; i < 2; ++i) b.in[k][i] = values[i][k];
  evaluate(constants_of(SearchProblem{}), b);
  EXPECT_TRUE(std::isnan(b.out[Batch::tip_1][0]));
  EXPECT_TRUE(std::isnan(b.out[Batch::contact_ratio][0]));
  EXPECT_TRUE(std::isnan(b.out[Batch::tan_working][1]));
  EXPECT_TRUE(std::isnan(b.out[Batch::contact_ratio][1]));
  EXPECT_FALSE(lanes_name().empty());
  EXPECT_GE(lanes(), 1u);
}

// ---- the sieve ----

// One problem for many pairs, and what the sieve is told of it.
struct SieveCase {
  SearchProblem problem;
  SieveConstants constants;
  std::vector<Trial> trials;
  SieveBatch batch;
};

SieveCase sieve_case(Random& random, const Mode& mode, std::size_t n) {
  SieveCase s;
  SearchProblem& p = s.problem;
  p.ratio = problem_of(mode).ratio;
  p.mounting = mode.tight ? Mounting::tight : Mounting::extended;
  p.helix = {random.chance(0.5) ? 0.0 : random.uniform(-0.5, 0.5)};
  p.normal_pressure_angle = random.uniform(0.26, 0.45);
  SearchLimits& l = p.limits;
  l.tip_thickness = random.uniform(0.0, 0.6);
  l.contact_ratio = random.uniform(1.0, 1.9);
  if (mode.ring || random.chance(0.6)) l.least_shift = random.uniform(-0.9, 0.1);
  if (mode.ring || random.chance(0.6)) l.greatest_shift = random.uniform(0.2, 1.2);
  const double cos_beta = std::cos(p.helix[0]);
  const double alpha_t = std::atan(std::tan(p.normal_pressure_angle) / cos_beta);
  SieveConstants& c = s.constants;
  c.cos_transverse = std::cos(alpha_t);
  c.involute_transverse = involute(alpha_t);
  c.sum_per_involute = cos_beta / std::tan(p.normal_pressure_angle);
  c.least_path = l.contact_ratio * std::numbers::pi * c.cos_transverse / cos_beta;
  c.addendum = {1.0, 1.0};
  c.tight = mode.tight;
  c.internal = mode.ring;
  c.path = !mode.tight && !mode.ring;
  // One band of centre distances for pairs of about the same size.
  const int z1 = random.whole(8, 70);
  const int z2 = mode.ring ? -(z1 + random.whole(8, 60)) : z1 + random.whole(0, 60);
  const double R = std::abs(z1 + z2) / (2.0 * cos_beta);
  const double least = R + random.uniform(-0.08 * R, 1.5);
  const bool exact = random.chance(0.2);
  p.center_distance = {{least, exact ? least : least + random.uniform(0.0, 0.6)}};
  s.batch.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int dz = random.whole(0, 6);
    const Trial t = trial(p, z1 + random.whole(0, 4), mode.ring ? z2 - dz - 4 : z2 + dz);
    s.trials.push_back(t);
    const TrialGear g_1 = trial_gear(p, t.z1, t.helix[0], 0, 0);
    const TrialGear g_2 = trial_gear(p, t.z2, t.helix[1], 0, 1);
    const double values[SieveBatch::kIn] = {g_1.r,       g_1.x_least,    g_1.x_greatest,
                                            g_2.r,       g_2.x_least,    g_2.x_greatest,
                                            (*p.center_distance)[0],     (*p.center_distance)[1]};
    for (std::size_t k = 0; k < SieveBatch::kIn; ++k) s.batch.in[k][i] = values[k];
  }
  return s;
}

TEST_P(CandidateOfMode, VerdictsOfLanesAreThoseOfTheScalarInstance) {  // (2)
  Random random(34);
  int asked = 0;
  int decided = 0;
  for (int repeat = 0; repeat < 400; ++repeat) {
    SieveCase s = sieve_case(random, GetParam(), 37);
    sieve(s.constants, s.batch);
    SieveBatch scalar = s.batch;
    sieve_scalar(s.constants, scalar);
    for (std::size_t i = 0; i < scalar.size(); ++i) {
      if (scalar.verdict[i] == kSieveAsk || s.batch.verdict[i] == kSieveAsk) {
        ++asked;
        continue;
      }
      ++decided;
      ASSERT_EQ(s.batch.verdict[i], scalar.verdict[i]) << repeat << " " << i;
    }
  }
  EXPECT_GT(decided, 4000);
  EXPECT_GT(asked, 0);
}

void expect_verdicts_of_the_graph(const Mode& mode, unsigned seed, int cases, int least) {
  Random random(seed);
  std::array<int, 5> seen{};
  int clipped_later = 0;
  for (int repeat = 0; repeat < cases; ++repeat) {
    SieveCase s = sieve_case(random, mode, 20);
    sieve(s.constants, s.batch);
    for (std::size_t i = 0; i < s.trials.size(); ++i) {
      const double verdict = s.batch.verdict[i];
      ++seen[static_cast<std::size_t>(verdict)];
      if (verdict == kSieveAsk) continue;
      const auto limit = graph(s.problem, s.trials[i]).what_kills();
      const double by_graph =
          limit ? std::min(static_cast<double>(*limit), kSievePass) : kSievePass;
      // The sieve does not know where flanks start: what it lets through, the graph may clip away.
      const bool clipped = verdict == kSievePass && by_graph == kSieveContactRatio;
      if (clipped) ++clipped_later;
      ASSERT_TRUE(verdict == by_graph || clipped)
          << verdict << " " << by_graph << " " << repeat << ": " << s.trials[i].z1 << ":" << s.trials[i].z2 << " a "
          << (*s.problem.center_distance)[0] << " " << (*s.problem.center_distance)[1] << " α "
          << s.problem.normal_pressure_angle << " β " << s.problem.helix[0] << " ε "
          << s.problem.limits.contact_ratio << " s " << s.problem.limits.tip_thickness << " x "
          << s.problem.limits.least_shift.value_or(-99.0) << " "
          << s.problem.limits.greatest_shift.value_or(99.0);
    }
  }
  EXPECT_GT(seen[0], least / 10);
  EXPECT_GT(seen[1], least);
  if (mode.ring || mode.tight) {
    EXPECT_GT(seen[4], least);
  } else {
    EXPECT_GT(seen[2], least);
    EXPECT_GT(seen[3] - clipped_later, least);
  }
}

TEST_P(CandidateOfMode, VerdictsAreThoseOfTheGraph) {  // (3)
  expect_verdicts_of_the_graph(GetParam(), 35, 100, 80);
}
TEST_P(CandidateOfMode, LongVerdictsAreThoseOfTheGraph) {
  expect_verdicts_of_the_graph(GetParam(), 36, 1000, 800);
}

TEST_P(CandidateOfMode, PartialVectorsOfTheSieveAreWhole) {
  Random random(37);
  SieveCase s = sieve_case(random, GetParam(), 17);
  sieve(s.constants, s.batch);
  for (std::size_t n = 1; n <= 17; ++n) {
    SieveBatch part = s.batch;
    part.resize(n);
    part.verdict.assign(n, -1.0);
    sieve(s.constants, part);
    for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(part.verdict[i], s.batch.verdict[i]) << n;
  }
}

// What a band leaves to the sieve's doubt: the trials that survive, and few of those that do not.
TEST(Candidate, TheSieveAsksForFewGraphs) {
  const auto& first = testing::search::reference().at("searches")[0];
  const Search search(testing::search::problem_of_search(first.at("input")));
  std::vector<DesignRow> rows;
  SieveCounts counts;
  search.range(0, *search.space().size(), rows, &counts);
  EXPECT_EQ(counts.asked + counts.decided, 2754);
  EXPECT_LT(counts.asked, 27);
}

}  // namespace
}  // namespace gearwright
