// Law: no member has less play than the bound. Golden: the least play of spur gears from [T14.14].
#include "gearwright/scatter/play_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/math/sobol.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"

namespace gearwright {
namespace {

ScatterTask worst_case_of(std::vector<ScatterTolerance> tolerances, int positions) {
  ScatterTask task;
  task.tolerances = std::move(tolerances);
  task.member.positions = positions;
  task.samples = 16;
  task.replicates = 2;
  task.worst_case = true;
  return task;
}

WorstMember least_play(const ContactSetup& setup, const ScatterTask& task) {
  const auto scatter = scatter_of(setup, task);
  EXPECT_TRUE(scatter && scatter->worst_least_play);
  return *scatter->worst_least_play;
}

ScatterTolerance varying_crowning(double um) {
  return testing::tolerance("gear1.modifications.lead_crowning_um", 1e-3, -um, um,
                            VaryingModification{1, Modification::lead_crowning});
}

ScatterTolerance varying_slope(double um) {
  return testing::tolerance("errors.helix_slope1_um", 1e-3, -um, um, VaryingError::helix_slope1);
}

TEST(PlayBound, IsCloseToTheClosedFormOfSpurGears) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  const ScatterTask task = worst_case_of(
      {testing::distance(0.02), testing::crossing(0.02), testing::intersecting(0.03),
       testing::tolerance("gear1.thickness_allowance_mm", 1.0, -0.02, 0.02, VaryingThickness{1})},
      4);
  const double drawn =
      *member_at(setup, deviation_at(setup, {}, {}), task.member)[ScatterQuantity::least_play];
  const double r_b1 = setup.gear(1).base_radius();
  const double r_b2 = setup.gear(2).base_radius();
  // The exact change of the play with ΔC, from inv α_wt at both centre distances.
  const auto involute_at = [&](double a) {
    const double alpha = std::acos((r_b1 + r_b2) / a);
    return std::tan(alpha) - alpha;
  };
  const double closer = 2 * (r_b1 + r_b2) * (involute_at(60.4 - 0.02) - involute_at(60.4)) / r_b2;
  const double alpha = std::acos((r_b1 + r_b2) / (60.4 - 0.02));
  const double tilt =
      20 / r_b2 * std::max(0.02 * std::cos(alpha), 0.03 * std::sin(alpha)) * kRadPerDeg;
  const double least = drawn + closer - tilt - 0.02 * std::cos(20 * kRadPerDeg) / r_b2;
  const WorstMember worst = least_play(setup, task);
  EXPECT_NEAR(worst.value, least, 1e-6);
  ASSERT_TRUE(worst.bound);
  EXPECT_LE(*worst.bound, least);
  EXPECT_NEAR(*worst.bound, least, 2e-5);
}

TEST(PlayBound, NoMemberHasLess) {
  ScatterTolerance bore_a =
      testing::tolerance("bearings.bore_a", 1.0, -0.02, 0.02, VaryingBore{100.0, 10.0, false});
  ScatterTolerance bore_b = bore_a;
  bore_b.name = "bearings.bore_b";
  bore_b.of = VaryingBore{100.0, 10.0, true};
  const std::vector<ScatterTolerance> angles{testing::distance(0.03), testing::crossing(0.04),
                                             testing::intersecting(0.05), varying_slope(15),
                                             varying_crowning(4)};
  const std::vector<ScatterTolerance> bores{bore_a, bore_b, varying_slope(9)};
  for (const auto& drawn : {testing::crowned_helical_pair(), testing::plain_helical_pair()}) {
    const ContactSetup setup = drawn.setup();
    for (const auto& tolerances : {angles, bores}) {
      const ScatterTask task = worst_case_of(tolerances, 8);
      const WorstMember worst = least_play(setup, task);
      ASSERT_TRUE(worst.bound);
      EXPECT_LE(*worst.bound, worst.value);
      EXPECT_GT(*worst.bound, worst.value - 1e-4);
      const int d = coordinates_of(tolerances);
      const SobolPoints points(d);
      for (std::uint32_t n = 0; n < 128; ++n) {
        std::vector<double> u, x;
        for (int j = 0; j < d; ++j) u.push_back(unit_interval(points.bits(n, j)));
        std::size_t from = 0;
        for (const ScatterTolerance& t : tolerances) {
          const auto count = static_cast<std::size_t>(t.coordinates());
          const auto value = t.at(std::span<const double>(u).subspan(from, count));
          x.insert(x.end(), value.begin(), value.begin() + t.coordinates());
          from += count;
        }
        const FamilyMember m = member_at(setup, deviation_at(setup, tolerances, x), task.member);
        EXPECT_GE(m[ScatterQuantity::least_play], *worst.bound);
      }
    }
  }
}

// The bound assumes convex functions. A flank with a kink is not convex. A peak to peak is a
// difference of two convex functions, so it need not be convex.
TEST(PlayBound, IsNoneWithoutConvexity) {
  const std::vector<ScatterTolerance> tolerances{testing::distance(0.02), testing::crossing(0.02)};
  testing::DrawnPair drawn = testing::spur_pair(true);
  const auto scatter = scatter_of(drawn.setup(), worst_case_of(tolerances, 4));
  ASSERT_TRUE(scatter && scatter->worst_peak_to_peak && scatter->worst_least_play);
  EXPECT_FALSE(scatter->worst_peak_to_peak->bound);
  EXPECT_TRUE(scatter->worst_least_play->bound);
  drawn.modifications.end_relief = {0.005, 3.0, ReliefShape::linear};
  EXPECT_FALSE(least_play(drawn.setup(), worst_case_of(tolerances, 4)).bound);
}

}  // namespace
}  // namespace gearwright
