// The vector results are compared with the scalar results, and the scalar results with the formulas
// of the pair. Law (1) of the header: vector and scalar results agree to 1e-12.
#include "gearwright/design/candidate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "gearwright/base/numbers.hpp"
#include "gearwright/design/testing/search_modes.hpp"
#include "gearwright/design/testing/search_reference.hpp"

namespace gearwright {
namespace {

using testing::search::graph;
using testing::search::kModes;
using testing::search::Mode;
using testing::search::Random;
using testing::search::trial;
using Batch = CandidateBatch;

constexpr double kLanes = 1e-12;  // law (1), relative to 1 + |value|

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

CandidateConstants candidate_constants_of(const SearchProblem& p) {
  const SearchRacks& r = p.racks[0];
  return {std::tan(p.normal_pressure_angle.rad()),
          {r.rack[0].addendum, r.rack[1].addendum},
          {r.rack[0].dedendum, r.rack[1].dedendum},
          r.undercut_depth,
          r.flank_depth,
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

// |ζ| has no upper limit, so 1/(1 + |ζ|) is compared. This is the ratio of the lower to the higher
// speed of the contact over the two flanks, and it does not amplify the rounding errors of ζ.
double compared(int column, double v) {
  return column == Batch::sliding ? 1.0 / (1.0 + std::abs(v)) : v;
}

TEST_P(CandidateOfMode, LanesAgreeWithTheScalarInstance) {  // (1)
  const Mode mode = GetParam();
  Random random(31);
  const CandidateConstants c = candidate_constants_of(problem_of(mode));
  Batch lanes;
  lanes.resize(250'000);
  fill(random, mode, 0, lanes.size(), lanes);
  Batch scalar = lanes;
  evaluate(c, lanes);
  evaluate_scalar(c, scalar);
  std::array<double, Batch::kOut> worst{};
  std::size_t compared_candidates = 0;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const double residual = std::max(lanes.out[Batch::residual][i], scalar.out[Batch::residual][i]);
    if (!(residual < 1e-12)) continue;
    ++compared_candidates;
    for (int k = 0; k < Batch::residual; ++k) {
      const double a = compared(k, lanes.out[static_cast<std::size_t>(k)][i]);
      const double b = compared(k, scalar.out[static_cast<std::size_t>(k)][i]);
      if (std::isnan(a) && std::isnan(b)) continue;
      const double off = a == b ? 0.0 : std::abs(a - b) / (1.0 + std::abs(b));
      auto& most = worst[static_cast<std::size_t>(k)];
      most = off <= most ? most : off;  // the negated form keeps NaN
      ASSERT_LE(off, kLanes) << "column " << k << " of " << lanes.in[0][i] << ":" << lanes.in[1][i]
                             << " sin β " << lanes.in[2][i] << " x " << lanes.in[3][i] << " "
                             << lanes.in[4][i];
    }
  }
  EXPECT_GT(compared_candidates, lanes.size() * 8 / 10);  // the other sums have no working angle
  RecordProperty("worst_1e_15",
                 std::to_string(*std::max_element(worst.begin(), worst.end()) / 1e-15));
}

TEST_P(CandidateOfMode, PartialVectorsAreWhole) {
  const Mode mode = GetParam();
  Random random(32);
  const CandidateConstants c = candidate_constants_of(problem_of(mode));
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

// The scalar results are compared with the results of a search, which uses the formulas of the
// pair.
TEST_P(CandidateOfMode, NumbersAreThoseOfTheRow) {
  const Mode mode = GetParam();
  constexpr double kRow = 1e-11;
  Random random(33);
  const SearchProblem given = problem_of(mode);
  const CandidateConstants c = candidate_constants_of(given);
  Batch b;
  b.resize(10'000);
  fill(random, mode, 0, b.size(), b);
  evaluate_scalar(c, b);
  int rows = 0;
  int beyond_base = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const auto out = [&](Batch::Out k) { return b.out[k][i]; };
    // dα/d inv α = 1/tan² α determines the effect of the residual on the working angle.
    if (!(out(Batch::residual) < 1e-14 * std::pow(out(Batch::tan_working), 2))) continue;
    if (std::isnan(out(Batch::contact_ratio)) || std::isnan(out(Batch::tip_1)) ||
        std::isnan(out(Batch::tip_2)))
      continue;
    SearchProblem p = given;
    p.helix = {Angle::radians(std::asin(b.in[Batch::sin_beta][i]))};
    const Trial t =
        trial(p, static_cast<int>(b.in[Batch::z1][i]), static_cast<int>(b.in[Batch::z2][i]));
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
    near(out(Batch::tan_working), std::tan(row.working_angle.rad()), "tan α_wt");
    near(out(Batch::contact_ratio), row.contact_ratio, "ε");
    near(out(Batch::contact_ratio_true), row.contact_ratio_true, "ε true");
    near(out(Batch::tip_1), row.tip_thickness[0], "s_an1");
    near(out(Batch::tip_2), row.tip_thickness[1], "s_an2");
    near(out(Batch::clearance_1), row.tip_clearance[0], "c1");
    near(out(Batch::clearance_2), row.tip_clearance[1], "c2");
    if (const auto zeta = row.max_sliding()) {
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
  const double values[2][5] = {{20, 40, 0.0, -1.9, 0.0},    // tip inside the base circle
                               {40, 40, 0.0, -1.3, -1.3}};  // centre distance below the sum of the
                                                            // base radii
  for (std::size_t k = 0; k < 5; ++k)
    for (std::size_t i = 0; i < 2; ++i) b.in[k][i] = values[i][k];
  evaluate(candidate_constants_of(SearchProblem{}), b);
  EXPECT_TRUE(std::isnan(b.out[Batch::tip_1][0]));
  EXPECT_TRUE(std::isnan(b.out[Batch::contact_ratio][0]));
  EXPECT_TRUE(std::isnan(b.out[Batch::tan_working][1]));
  EXPECT_TRUE(std::isnan(b.out[Batch::contact_ratio][1]));
  EXPECT_FALSE(lanes_name().empty());
  EXPECT_GE(lanes(), 1u);
}

}  // namespace
}  // namespace gearwright
