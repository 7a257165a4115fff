// Golden: tests/oracle/sampling.json and closed forms.
// Laws: (1) adding a constant changes no moment except the mean   (2) one replicate has no standard
// error   (3) an additive function has equal first and total indices.
#include "gearwright/math/statistics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "gearwright/base/testing/oracle_case.hpp"
#include "gearwright/math/sobol.hpp"

namespace gearwright {
namespace {

TEST(Statistics, MomentsAreStable) {
  const std::vector<double> x{1.0, 2.0, 4.0};
  EXPECT_DOUBLE_EQ(moments(x).mean, 7.0 / 3);
  EXPECT_DOUBLE_EQ(moments(x).variance, 7.0 / 3);
  const std::vector<double> far{1e9 + 1, 1e9 + 2, 1e9 + 4};
  EXPECT_NEAR(moments(far).variance, 7.0 / 3, 1e-6);
  EXPECT_EQ(moments(std::vector{5.0}).variance, 0.0);
}

TEST(Statistics, QuantilesLieBetweenSamples) {
  const std::vector<double> x{0.0, 1.0, 10.0};
  EXPECT_EQ(quantile(x, 0.0), 0.0);
  EXPECT_EQ(quantile(x, 0.25), 0.5);
  EXPECT_EQ(quantile(x, 0.75), 5.5);
  EXPECT_EQ(quantile(x, 1.0), 10.0);
}

TEST(Statistics, RanksAreThoseOfTheBinomialDistribution) {
  const auto c = testing::oracle_case("sampling.json", "order-statistics");
  for (std::size_t i = 0; i < c["expected"]["ranks"].size(); ++i) {
    const auto& given = c["spec"]["samples_percent"][i];
    const auto ranks = quantile_ranks(given[0], given[1].get<double>() / 100, 0.95);
    ASSERT_TRUE(ranks.lower && ranks.upper);
    EXPECT_EQ(*ranks.lower, c["expected"]["ranks"][i][0]);
    EXPECT_EQ(*ranks.upper, c["expected"]["ranks"][i][1]);
  }
  // 0.95^72 < 0.025 < 0.95^71. At least 72 samples are therefore needed for an upper bound of the
  // 95 % quantile with this confidence.
  EXPECT_FALSE(quantile_ranks(71, 0.95, 0.95).upper);
  EXPECT_TRUE(quantile_ranks(72, 0.95, 0.95).upper);
  EXPECT_FALSE(quantile_ranks(71, 0.05, 0.95).lower);
  EXPECT_EQ(quantile_ranks(72, 0.05, 0.95).lower, 1);
}

TEST(Statistics, ProbabilitiesHaveClopperAndPearsonsInterval) {
  const auto c = testing::oracle_case("sampling.json", "clopper-pearson");
  for (std::size_t i = 0; i < c["expected"]["intervals"].size(); ++i) {
    const auto& count = c["spec"]["counts"][i];
    const ConfidenceInterval found = probability_interval(count[0], count[1], 0.95);
    const double lower = c["expected"]["intervals"][i][0];
    const double upper = c["expected"]["intervals"][i][1];
    EXPECT_NEAR(found.lower, lower, 1e-10 * lower);
    EXPECT_NEAR(found.upper, upper, 1e-10 * upper);
  }
}

TEST(Statistics, ReplicatesGiveTheError) {
  const std::vector<double> y{1.0, 2.0, 3.0, 6.0};
  const Estimate e = estimate(y);
  EXPECT_EQ(e.value, 3.0);
  ASSERT_TRUE(e.standard_error);
  EXPECT_DOUBLE_EQ(*e.standard_error, std::sqrt(14.0 / 12));
  const ConfidenceInterval i = interval(e, 4, 0.95);
  EXPECT_NEAR(i.upper - 3.0, 3.182446 * std::sqrt(14.0 / 12), 1e-5);  // t_3
  EXPECT_FALSE(estimate(std::vector{2.0}).standard_error);
}

// Estimates the indices in one replicate, from n scrambled points of A, of B, and of A with one
// column of B.
template <class F>
std::optional<SobolIndices> indices_of(const F& f, std::uint32_t n, int replicate) {
  constexpr int d = 3;
  const SobolPoints sobol(2 * d);
  std::vector<double> a, b;
  std::vector<std::vector<double>> mixed(d);
  for (std::uint32_t i = 0; i < n; ++i) {
    std::array<double, d> x_a{}, x_b{};
    for (int j = 0; j < d; ++j) {
      x_a[j] = unit_interval(owen_scrambled(sobol.bits(i, j), scramble_key(1, replicate, j)));
      x_b[j] =
          unit_interval(owen_scrambled(sobol.bits(i, d + j), scramble_key(1, replicate, d + j)));
    }
    a.push_back(f(x_a));
    b.push_back(f(x_b));
    for (int j = 0; j < d; ++j) {
      auto x = x_a;
      x[j] = x_b[j];
      mixed[j].push_back(f(x));
    }
  }
  return sobol_indices(a, b, mixed, 0.0);
}

TEST(Statistics, IndicesOfIshigamisFunction) {
  const auto c = testing::oracle_case("sampling.json", "ishigami")["expected"];
  const auto ishigami = [](const std::array<double, 3>& u) {
    const auto at = [&](int j) { return std::numbers::pi * (2 * u[j] - 1); };
    const double x3 = at(2) * at(2);
    return std::sin(at(0)) + 7 * std::sin(at(1)) * std::sin(at(1)) +
           0.1 * x3 * x3 * std::sin(at(0));
  };
  // The values are from theory page 14. Another program computed them with n = 4096, 8 replicates,
  // and the same points and estimators.
  const std::array<double, 3> first{0.31337, 0.44010, -0.00177}, total{0.55817, 0.44227, 0.24428};
  for (int j = 0; j < 3; ++j) {
    std::vector<double> s, s_t;
    for (int r = 0; r < 8; ++r) {
      const auto indices = indices_of(ishigami, 4096, r);
      ASSERT_TRUE(indices);
      s.push_back(indices->first[j]);
      s_t.push_back(indices->total[j]);
    }
    EXPECT_NEAR(estimate(s).value, first[j], 5e-5);
    EXPECT_NEAR(estimate(s_t).value, total[j], 5e-5);
    EXPECT_NEAR(estimate(s).value, c["first"][j], 0.01);
    EXPECT_NEAR(estimate(s_t).value, c["total"][j], 0.01);
  }
}

TEST(Statistics, IndicesOfASum) {
  const auto sum = [](const std::array<double, 3>& u) { return 3 * u[0] + 4 * u[1]; };
  const auto indices = indices_of(sum, 4096, 0);
  ASSERT_TRUE(indices);
  const std::array<double, 3> share{9.0 / 25, 16.0 / 25, 0.0};
  for (int j = 0; j < 3; ++j) {
    EXPECT_NEAR(indices->first[j], share[j], 3e-3);
    EXPECT_NEAR(indices->total[j], share[j], 3e-3);
  }
  EXPECT_FALSE(indices_of([](const auto&) { return 7.0; }, 64, 0));
  EXPECT_FALSE(indices_of([](const auto& u) { return u[0] > 0.5 ? NAN : u[1]; }, 64, 0));
}

}  // namespace
}  // namespace gearwright
