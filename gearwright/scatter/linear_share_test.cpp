// The gradients are the exact derivatives of contact. A quantity that is linear in the inputs has
// the share 1, and a quantity that is an even function of the inputs has the share 0. Golden: the
// closed forms of page 14 for spur gears.
#include "gearwright/scatter/linear_share.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/contact/contact.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"

namespace gearwright {
namespace {

using Q = ScatterQuantity;

constexpr std::size_t at(Q q) { return static_cast<std::size_t>(q); }

ScatterTask indexed(std::vector<ScatterTolerance> tolerances, int positions, int samples) {
  ScatterTask task = testing::task_of(std::move(tolerances), positions, samples, 2);
  task.indices = true;
  return task;
}

std::optional<double> share_in(const ContactSetup& setup, const ScatterTask& task, Q q) {
  const auto scatter = scatter_of(setup, task);
  EXPECT_TRUE(scatter) << scatter.error().message();
  const auto& indices = scatter->indices[at(q)];
  EXPECT_TRUE(indices);
  return indices ? indices->linear_share : std::nullopt;
}

TEST(LinearShare, GradientsAreTheExactDerivatives) {
  testing::DrawnPair drawn = testing::crowned_helical_pair();
  drawn.errors = {.center_distance = 0.01,
                  .crossing = Angle::degrees(0.01),
                  .intersecting = Angle::degrees(-0.02)};
  const ContactSetup setup = drawn.setup();
  using M = Modification;
  const std::vector<std::pair<ScatterTolerance, Influence>> all{
      {testing::tolerance("a", 1.0, -4e-3, 4e-3, VaryingError::center_distance),
       {ErrorKind::center_distance}},
      {testing::tolerance("b", 1.0, -6e-5, 6e-5, VaryingError::crossing), {ErrorKind::crossing}},
      {testing::tolerance("c", 1.0, -1e-4, 1e-4, VaryingError::intersecting),
       {ErrorKind::intersecting}},
      {testing::tolerance("d", 1e-3, -1, 1, VaryingError::helix_slope2), {ErrorKind::helix_slope2}},
      {testing::tolerance("e", 1e-3, -1, 1, VaryingModification{1, M::lead_crowning}),
       {ErrorKind::center_distance, 1, M::lead_crowning}},
      {testing::tolerance("f", 1e-3, -1, 1, VaryingModification{1, M::profile_slope}),
       {ErrorKind::center_distance, 1, M::profile_slope}}};
  std::vector<ScatterTolerance> tolerances;
  std::vector<Influence> influences;
  for (const auto& [tolerance, influence] : all) {
    tolerances.push_back(tolerance);
    influences.push_back(influence);
  }
  const ScatterTask task = indexed(tolerances, 32, 2);
  Deviation none;
  none.errors = drawn.errors;
  const MemberSpan span = continuous_peak_to_peak(setup, none, task.member, influences);
  const ContactPair pair = setup.pair(false);
  Transmission transmission(pair);
  std::vector<double> mean(all.size());
  for (const PairTouch& touch : one_pitch(transmission, -0.5 * pair.pitch(), 32))
    for (std::size_t i = 0; i < all.size(); ++i)
      mean[i] += sensitivity(transmission, touch, influences[i]).te / 32;
  std::array<double, kScatterQuantities> deviation{};
  deviation.fill(1e-7);
  const QuantityGradients g = gradients_as_drawn(setup, task, deviation);
  for (const auto& [quantity, exact] :
       {std::pair(Q::peak_to_peak, span.slope), std::pair(Q::mean, mean)}) {
    ASSERT_TRUE(g[at(quantity)]) << at(quantity);
    const auto effect = [&](std::size_t i, const std::vector<double>& slopes) {
      return slopes[i] * tolerances[i].unit * tolerances[i].distribution.greatest();
    };
    double greatest = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i)
      greatest = std::max(greatest, std::abs(effect(i, exact)));
    for (std::size_t i = 0; i < all.size(); ++i)
      EXPECT_NEAR((*g[at(quantity)])[i] * tolerances[i].distribution.greatest(), effect(i, exact),
                  2e-4 * greatest)
          << at(quantity) << " " << tolerances[i].name;
  }
}

// [T14.14]: the play is linear in the thickness and, except for 2e-3 of its change, in ΔC.
TEST(LinearShare, OfALinearQuantityIsOne) {
  const ContactSetup setup = testing::spur_pair(true).setup();
  const ScatterTask task = indexed(
      {testing::distance(0.02),
       testing::tolerance("gear1.thickness_allowance_mm", 1.0, -0.02, 0.02, VaryingThickness{1})},
      4, 128);
  const auto share = share_in(setup, task, Q::least_play);
  ASSERT_TRUE(share);
  EXPECT_NEAR(*share, 1.0, 1e-4);
}

// TE of lead-crowned spur gears is TE_0 − sin α ΔC/r_b2 + q Δγ² with q = cos²α b²/(16 C r_b2). The
// greatest value of cos α Δγ z − 4 C z²/b² over z gives q. The variance of Δγ² with Δγ uniform over
// ±w is 4w⁴/45.
TEST(LinearShare, OfAnEvenQuantityIsZero) {
  testing::DrawnPair drawn = testing::spur_pair(false);
  drawn.modifications.lead_crowning = 0.008;
  const ContactSetup setup = drawn.setup();
  const double r_b1 = setup.gear(1).base_radius();
  const double r_b2 = setup.gear(2).base_radius();
  const double alpha = std::acos((r_b1 + r_b2) / 60.4);
  const double w = 0.04 * kRadPerDeg;
  const double q = std::pow(std::cos(alpha) * 20, 2) / (16 * 0.008 * r_b2);
  const double even = q * q * 4 * std::pow(w, 4) / 45;
  const auto even_share = share_in(setup, indexed({testing::crossing(0.04)}, 4, 256), Q::mean);
  ASSERT_TRUE(even_share);
  EXPECT_NEAR(*even_share, 0.0, 1e-6);
  const double half = 0.002;
  const double linear = std::pow(std::sin(alpha) * half / r_b2, 2) / 3;
  const auto share =
      share_in(setup, indexed({testing::crossing(0.04), testing::distance(half)}, 4, 256), Q::mean);
  ASSERT_TRUE(share);
  EXPECT_NEAR(*share, linear / (linear + even), 0.01);
}

// TE of spur gears without crowning is |cos α Δγ| [T14.14], so it has a bend in the middle.
TEST(LinearShare, ABendHasNoDerivative) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  EXPECT_FALSE(share_in(setup, indexed({testing::crossing(0.02)}, 4, 64), Q::mean));
  // A bend with little effect on the scatter is ignored. Here, the shaft angle varies by 1e-5
  // degrees, and the centre distance varies by 0.02 mm.
  const auto task = indexed({testing::distance(0.02), testing::crossing(1e-5)}, 4, 64);
  const auto share = share_in(setup, task, Q::mean);
  ASSERT_TRUE(share);
  EXPECT_NEAR(*share, 1.0, 1e-3);
}

// The number of waves is not continuous, and waves change TE and the play.
TEST(LinearShare, WavesHaveNoDerivative) {
  const ContactSetup setup = testing::spur_pair(true).setup();
  ScatterTolerance wave =
      testing::tolerance("gear1.helix_waves", 1.0, 0.0, 1.0, VaryingWave{1, true, {1, 4}, 0.004});
  const auto task = indexed({testing::distance(0.02), wave}, 4, 16);
  EXPECT_FALSE(share_in(setup, task, Q::mean));
  std::array<double, kScatterQuantities> deviation{};
  deviation.fill(1e-6);
  EXPECT_FALSE(gradients_as_drawn(setup, task, deviation)[at(Q::least_play)]);
}

}  // namespace
}  // namespace gearwright
