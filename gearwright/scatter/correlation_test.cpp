// Laws: (1) correlations of 0 change no bit; (2) the distribution of each input stays the same.
// Golden: the rank correlation of a Gaussian copula, 6/π asin(ρ/2), and the variance of the play of
// spur gears, which is a sum of two inputs. Oracle: positions of bores from random normal points.
#include "gearwright/scatter/correlation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

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
    const ScatterTask task = three_inputs({{0, 1, rho, 1}});
    const auto points = SamplePoints(task).first(0, task.samples);
    const auto ranks = [&](std::size_t i) { return rank_numbers(input(points, i)); };
    EXPECT_NEAR(pearson(ranks(0), ranks(1)), 6 / std::numbers::pi * std::asin(rho / 2), 0.005);
    EXPECT_NEAR(pearson(ranks(0), ranks(2)), 0.0, 0.005);
    EXPECT_NEAR(pearson(ranks(1), ranks(2)), 0.0, 0.005);
  }
}

TEST(Correlation, OfThreeInputsIsTheirMatrix) {
  const ScatterTask task = three_inputs({{0, 1, 0.6, 1}, {0, 2, -0.3, 1}, {1, 2, 0.4, 1}});
  const auto points = SamplePoints(task).first(0, task.samples);
  for (const ToleranceCorrelation& c : task.correlations)
    EXPECT_NEAR(
        pearson(rank_numbers(input(points, c.first)), rank_numbers(input(points, c.second))),
        6 / std::numbers::pi * std::asin(c.value / 2), 0.005);
}

TEST(Correlation, DistributionsOfTheInputsStayTheSame) {
  const ScatterTask alone = three_inputs({});
  const ScatterTask task = three_inputs({{0, 1, 0.8, 1}, {1, 2, -0.5, 1}});
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
  const ScatterTask task = three_inputs({{0, 1, 0.0, 1}, {1, 2, 0.0, 1}});
  EXPECT_EQ(SamplePoints(alone).first(0, 64), SamplePoints(task).first(0, 64));
  // Inputs 0 and 2 are correlated. Input 1 has no correlation and keeps its values. Input 0 also
  // keeps its values, because it is the first of the correlated inputs.
  const ScatterTask two = three_inputs({{0, 2, 0.5, 1}});
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
    task.correlations = {{0, 1, rho, 1}};
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
  const std::vector<ToleranceCorrelation> good{{0, 1, 0.9, 1}, {1, 2, 0.9, 1}, {0, 2, 0.9, 1}};
  EXPECT_FALSE(check_correlations(inputs.tolerances, good));
  // If two correlations are 0.9 and 0.5, the third one can be at most 0.45 + √(0.19 · 0.75) =
  // 0.82749. The message proposes this value for one of the two correlations of 0.9. The
  // alternative would be to raise 0.5 to 0.62 or more.
  const std::vector<ToleranceCorrelation> bad{{0, 1, 0.9, 1}, {1, 2, 0.9, 1}, {0, 2, 0.5, 1}};
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
  // If all correlations of four inputs are equal, they must be greater than −1/3.
  std::vector<ScatterTolerance> four = inputs.tolerances;
  four.push_back(testing::distance(0.01));
  std::vector<ToleranceCorrelation> all;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) all.push_back({i, j, -0.9, 1});
  const auto none = check_correlations(four, all);
  ASSERT_TRUE(none);
  EXPECT_NE(none->rule.find("at most 0.37"), std::string::npos) << none->rule;
}

ScatterTolerance bore(bool far_end) {
  return testing::tolerance(far_end ? "bearings.bore_b" : "bearings.bore_a", 1.0, -0.02, 0.02,
                            VaryingBore{100.0, 0.0, far_end});
}

// The oracle draws correlated normal points of the plane and moves each along its radius, so that
// the point is uniform in the disc. It uses the generators of the standard library.
double correlation_in_discs(double rho) {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal;
  std::vector<double> a, b;
  for (int n = 0; n < 400000; ++n) {
    std::array<std::array<double, 2>, 2> point{};
    for (const std::size_t k : {0U, 1U}) {
      point[0][k] = normal(generator);
      point[1][k] = rho * point[0][k] + std::sqrt(1 - rho * rho) * normal(generator);
    }
    const auto x = [&](std::size_t i) {
      const double far = std::hypot(point[i][0], point[i][1]);
      return std::sqrt(1 - std::exp(-far * far / 2)) * point[i][0] / far;
    };
    a.push_back(x(0));
    b.push_back(x(1));
  }
  return pearson(a, b);
}

TEST(Correlation, OfBoresIsThatOfTheirPositions) {
  for (const double rho : {-0.5, 0.8}) {
    ScatterTask task = three_inputs({{0, 2, rho, 1}, {1, 3, rho, 1}});
    task.tolerances = {bore(false), bore(true)};
    const auto points = SamplePoints(task).first(0, task.samples);
    const double expected = correlation_in_discs(rho);
    EXPECT_NEAR(pearson(input(points, 0), input(points, 2)), expected, 0.005);
    EXPECT_NEAR(pearson(input(points, 1), input(points, 3)), expected, 0.005);
    EXPECT_NEAR(pearson(input(points, 0), input(points, 1)), 0.0, 0.005);
    EXPECT_NEAR(pearson(input(points, 2), input(points, 3)), 0.0, 0.005);
    EXPECT_NEAR(pearson(input(points, 0), input(points, 3)), 0.0, 0.005);
    // The positions of the second bore are uniform in the circle: the square of the distance and
    // the direction have uniform distributions.
    std::vector<double> square, direction;
    for (const auto& x : points) {
      square.push_back((x[2] * x[2] + x[3] * x[3]) / (0.02 * 0.02));
      direction.push_back(std::atan2(x[3], x[2]) / (2 * std::numbers::pi) + 0.5);
    }
    for (std::vector<double>* values : {&square, &direction}) {
      std::sort(values->begin(), values->end());
      for (const double p : {0.05, 0.25, 0.5, 0.75, 0.95})
        EXPECT_NEAR(quantile(*values, p), p, 0.01);
    }
  }
}

// [S4]: ΔC = −(x_A + x_B)/2 and Δδ = (x_B − x_A)/L. If r is the correlation of x_A and x_B,
// var ΔC = R²(1 + r)/8 and var Δδ = R²(1 − r)/(2L²).
TEST(Correlation, OfBoresMovesTheAxisMoreAndTiltsItLess) {
  ScatterTask task = three_inputs({{0, 2, 0.9, 1}, {1, 3, 0.9, 1}});
  task.tolerances = {bore(false), bore(true)};
  const ContactSetup setup = testing::spur_pair(false).setup();
  std::vector<double> distance, in_plane;
  for (const auto& x : SamplePoints(task).first(0, task.samples)) {
    const ContactErrors e = deviation_at(setup, task.tolerances, x).errors;
    distance.push_back(e.center_distance);
    in_plane.push_back(e.intersecting.rad());
  }
  const double r = correlation_in_discs(0.9);
  EXPECT_NEAR(moments(distance).variance, 0.0004 * (1 + r) / 8, 0.01 * 0.0004 / 8);
  EXPECT_NEAR(moments(in_plane).variance, 0.0004 * (1 - r) / 2e4, 0.01 * 0.0004 / 2e4);
}

TEST(Correlation, OfABoreAndANumberLeavesTheBoreUniform) {
  ScatterTask task = three_inputs({{0, 1, 0.7, 1}, {0, 2, -0.5, 1}});
  task.tolerances = {testing::distance(0.01), bore(false)};
  const auto points = SamplePoints(task).first(0, task.samples);
  EXPECT_GT(pearson(input(points, 0), input(points, 1)), 0.6);
  EXPECT_LT(pearson(input(points, 0), input(points, 2)), -0.4);
  EXPECT_NEAR(pearson(input(points, 1), input(points, 2)), 0.0, 0.005);
  std::vector<double> square;
  for (const auto& x : points) square.push_back((x[1] * x[1] + x[2] * x[2]) / (0.02 * 0.02));
  std::sort(square.begin(), square.end());
  for (const double p : {0.05, 0.5, 0.95}) EXPECT_NEAR(quantile(square, p), p, 0.01);
}

TEST(Correlation, OfPitchesAndWavesIsThatOfTheirShareAndTheirNumber) {
  ScatterTask task = three_inputs({{0, 3, 0.8, 1}, {6, 8, 0.999, 1}});
  task.tolerances = {testing::tolerance("gear1.pitch", 1.0, 0.0, 1.0, VaryingPitch{1, 0.04, 0.01}),
                     testing::tolerance("gear2.pitch", 1.0, 0.0, 1.0, VaryingPitch{2, 0.05, 0.01}),
                     testing::tolerance("gear1.profile_waves", 1.0, 0.0, 1.0,
                                        VaryingWave{1, false, {1, 4}, 0.004}),
                     testing::tolerance("gear2.profile_waves", 1.0, 0.0, 1.0,
                                        VaryingWave{2, false, {1, 4}, 0.004})};
  const auto points = SamplePoints(task).first(0, task.samples);
  EXPECT_NEAR(pearson(rank_numbers(input(points, 0)), rank_numbers(input(points, 3))),
              6 / std::numbers::pi * std::asin(0.4), 0.005);
  EXPECT_NEAR(pearson(input(points, 1), input(points, 4)), 0.0, 0.005);
  int different = 0;
  for (const auto& x : points) different += x[6] != x[8];
  EXPECT_LT(different, task.samples / 20);
}

TEST(Correlation, RefusesPhasesAndBothCoordinatesOfABore) {
  const std::vector<ScatterTolerance> tolerances{
      testing::distance(0.01), bore(false),
      testing::tolerance("gear1.helix_waves", 1.0, 0.0, 1.0, VaryingWave{1, true, {2, 2}, 0.004}),
      testing::tolerance("gear1.pitch", 1.0, 0.0, 1.0, VaryingPitch{1, 0.04, 0.01})};
  const auto refused = [&](std::size_t first, std::size_t second) {
    const std::vector<ToleranceCorrelation> correlations{{first, second, 0.5, 1}};
    const auto error = check_correlations(tolerances, correlations);
    return error ? error->value : std::string();
  };
  EXPECT_EQ(refused(0, 3), "gear1.helix_waves.waves");
  EXPECT_EQ(refused(0, 4), "gear1.helix_waves.phase_deg");
  EXPECT_EQ(refused(0, 6), "gear1.pitch.phase_deg");
  EXPECT_EQ(refused(1, 2), "bearings.bore_a.y_mm");
  EXPECT_EQ(refused(0, 5), "");
  EXPECT_EQ(refused(2, 7), "");
}

TEST(Correlation, BlocksAreConnected) {
  const std::vector<ToleranceCorrelation> chain{{0, 3, 0.5, 1}, {1, 2, 0.0, 1}, {3, 4, 0.1, 1}};
  std::vector<ScatterTolerance> six(6, testing::distance(0.01));
  EXPECT_EQ(correlated_blocks(six, chain), (std::vector<std::vector<std::size_t>>{{0, 3, 4}}));
  // If input 0 is a bore with two coordinates, coordinate 3 belongs to input 2.
  six[0] = bore(false);
  EXPECT_EQ(correlated_blocks(six, chain), (std::vector<std::vector<std::size_t>>{{0, 2, 3}}));
}

}  // namespace
}  // namespace gearwright
