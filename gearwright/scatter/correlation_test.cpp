// Laws: (1) correlations of 0 change no bit; (2) the distribution of each input stays the same.
// Golden: the rank correlation of a Gaussian copula, 6/π asin(ρ/2), and the variance of the play of
// spur gears, which is a sum of two inputs.
#include "gearwright/scatter/correlation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gearwright/scatter/sample_points.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"

namespace gearwright {
namespace {

ScatterTask three_inputs(std::vector<ToleranceCorrelation> correlations) {
  ScatterTask task;
  task.tolerances = {testing::distance(0.02), testing::crossing(0.03), testing::intersecting(0.04)};
  task.tolerances[1].distribution =
      Distribution::of({{-0.03, 0.03}, DistributionSpec::Kind::normal}).value();
  task.correlations = std::move(correlations);
  task.samples = 4096;
  task.replicates = 1;
  return task;
}

std::vector<double> input(const std::vector<std::vector<double>>& points, std::size_t which) {
  std::vector<double> x;
  for (const auto& point : points) x.push_back(point[which]);
  return x;
}

double pearson(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  const double mx = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double my = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mx) * (x[i] - mx);
    yy += (y[i] - my) * (y[i] - my);
    xy += (x[i] - mx) * (y[i] - my);
  }
  return xy / std::sqrt(xx * yy);
}

std::vector<double> rank_numbers(const std::vector<double>& x) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return x[a] < x[b]; });
  std::vector<double> ranks(x.size());
  for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = static_cast<double>(i);
  return ranks;
}

TEST(Correlation, RankCorrelationsAreThoseOfTheCopula) {
  for (const double rho : {-0.95, -0.4, 0.2, 0.7, 0.99}) {
    const ScatterTask task = three_inputs({{0, 1, rho}});
    const auto points = SamplePoints(task).first(0, task.samples);
    const auto ranks = [&](std::size_t i) { return rank_numbers(input(points, i)); };
    EXPECT_NEAR(pearson(ranks(0), ranks(1)), 6 / std::numbers::pi * std::asin(rho / 2), 0.005);
    EXPECT_NEAR(pearson(ranks(0), ranks(2)), 0.0, 0.005);
    EXPECT_NEAR(pearson(ranks(1), ranks(2)), 0.0, 0.005);
  }
}

TEST(Correlation, OfThreeInputsIsTheirMatrix) {
  const ScatterTask task = three_inputs({{0, 1, 0.6}, {0, 2, -0.3}, {1, 2, 0.4}});
  const auto points = SamplePoints(task).first(0, task.samples);
  for (const ToleranceCorrelation& c : task.correlations)
    EXPECT_NEAR(
        pearson(rank_numbers(input(points, c.first)), rank_numbers(input(points, c.second))),
        6 / std::numbers::pi * std::asin(c.value / 2), 0.005);
}

TEST(Correlation, DistributionsOfTheInputsStayTheSame) {
  const ScatterTask alone = three_inputs({});
  const ScatterTask task = three_inputs({{0, 1, 0.8}, {1, 2, -0.5}});
  const auto before = SamplePoints(alone).first(0, task.samples);
  const auto after = SamplePoints(task).first(0, task.samples);
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<double> x = input(before, i), y = input(after, i);
    std::sort(x.begin(), x.end());
    std::sort(y.begin(), y.end());
    const double width = task.tolerances[i].distribution.greatest();
    for (const double p : {0.01, 0.1, 0.5, 0.9, 0.99})
      EXPECT_NEAR(quantile(x, p), quantile(y, p), 0.01 * width);
    EXPECT_GE(y.front(), -width);
    EXPECT_LE(y.back(), width);
  }
}

TEST(Correlation, OfZeroChangesNoBit) {
  const ScatterTask alone = three_inputs({});
  const ScatterTask task = three_inputs({{0, 1, 0.0}, {1, 2, 0.0}});
  EXPECT_EQ(SamplePoints(alone).first(0, 64), SamplePoints(task).first(0, 64));
  // An input without a correlation keeps its values, and so does the first of a block.
  const ScatterTask two = three_inputs({{0, 2, 0.5}});
  const auto before = SamplePoints(alone).first(0, 64);
  const auto after = SamplePoints(two).first(0, 64);
  EXPECT_EQ(input(before, 0), input(after, 0));
  EXPECT_EQ(input(before, 1), input(after, 1));
  EXPECT_NE(input(before, 2), input(after, 2));
}

// [T14.14]: the play of spur gears changes by 2 sin α ΔC/r_b2 − cos α_n ΔE_sn/r_b2. The covariance
// of two uniform inputs is their rank correlation times w_1 w_2/3.
TEST(Correlation, ChangesTheVarianceOfThePlay) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  const double r_b2 = setup.gear(2).base_radius();
  const double sine = std::sin(std::acos((setup.gear(1).base_radius() + r_b2) / 60.4));
  const double a = 2 * sine * 0.0175;
  const double b = -0.03 * std::cos(20 * kRadPerDeg);
  for (const double rho : {-0.8, 0.8}) {
    ScatterTask task;
    task.tolerances = {
        testing::distance(0.0175),
        testing::tolerance("gear1.thickness_allowance_mm", 1.0, -0.03, 0.03, VaryingThickness{1})};
    task.correlations = {{0, 1, rho}};
    task.member.positions = 2;
    task.samples = 512;
    task.replicates = 4;
    const auto scatter = scatter_of(setup, task);
    ASSERT_TRUE(scatter);
    const Spread& play = *scatter->spread[static_cast<std::size_t>(ScatterQuantity::least_play)];
    const double rank = 6 / std::numbers::pi * std::asin(rho / 2);
    const double exact = std::sqrt((a * a + b * b + 2 * a * b * rank) / 3) / r_b2;
    EXPECT_NEAR(play.standard_deviation.value, exact, 0.01 * exact);
  }
}

TEST(Correlation, RefusesAMatrixThatIsNotPositiveDefinite) {
  const ScatterTask inputs = three_inputs({});
  const std::vector<ToleranceCorrelation> good{{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, 0.9}};
  EXPECT_FALSE(check_correlations(inputs.tolerances, good));
  // With 0.9 and 0.5, the third correlation lies within 0.45 ± √(0.19 · 0.75), up to 0.82749. With
  // 0.9 and 0.9, it lies within 0.81 ± 0.19, from 0.62, which is farther from 0.5.
  const std::vector<ToleranceCorrelation> bad{{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, 0.5}};
  const auto error = check_correlations(inputs.tolerances, bad);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->field, "correlations[1].value");
  EXPECT_NE(error->rule.find("0.8274"), std::string::npos) << error->rule;
  EXPECT_NE(error->rule.find("errors.crossing_deg"), std::string::npos);
  std::vector<ToleranceCorrelation> mended = bad;
  mended[0].value = 0.8274;
  EXPECT_FALSE(check_correlations(inputs.tolerances, mended));
  mended[0].value = 0.8276;
  EXPECT_TRUE(check_correlations(inputs.tolerances, mended));
  // Four inputs with the same correlation need more than −1/3.
  std::vector<ScatterTolerance> four = inputs.tolerances;
  four.push_back(testing::distance(0.01));
  std::vector<ToleranceCorrelation> all;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) all.push_back({i, j, -0.9});
  const auto none = check_correlations(four, all);
  ASSERT_TRUE(none);
  EXPECT_NE(none->rule.find("at most 0.37"), std::string::npos) << none->rule;
}

TEST(Correlation, RefusesInputsOfSeveralCoordinates) {
  std::vector<ScatterTolerance> tolerances{
      testing::distance(0.01),
      testing::tolerance("bearings.bore_a", 1.0, -0.02, 0.02, VaryingBore{100.0, 0.0, false})};
  const std::vector<ToleranceCorrelation> correlations{{0, 1, 0.5}};
  const auto error = check_correlations(tolerances, correlations);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->value, "bearings.bore_a");
}

TEST(Correlation, BlocksAreConnected) {
  const std::vector<ToleranceCorrelation> chain{{0, 3, 0.5}, {1, 2, 0.0}, {3, 4, 0.1}};
  const auto blocks = correlated_blocks(6, chain);
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_EQ(blocks[0], (std::vector<std::size_t>{0, 3, 4}));
}

}  // namespace
}  // namespace gearwright
