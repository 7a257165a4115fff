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

// The values of a function at n scrambled points of A, of B, and of A with one column of B.
template <int d>
struct Design {
  SampleValues a, b;
  std::array<SampleValues, d> mixed;

  template <class F>
  Design(const F& f, std::uint32_t n, int replicate) {
    const SobolPoints sobol(2 * d);
    const auto at = [&](std::uint32_t i, int j) {
      return unit_interval(owen_scrambled(sobol.bits(i, j), scramble_key(1, replicate, j)));
    };
    for (std::uint32_t i = 0; i < n; ++i) {
      std::array<double, d> x_a{}, x_b{};
      for (int j = 0; j < d; ++j) {
        x_a[j] = at(i, j);
        x_b[j] = at(i, d + j);
      }
      a.push_back(f(x_a));
      b.push_back(f(x_b));
      for (int j = 0; j < d; ++j) {
        auto x = x_a;
        x[j] = x_b[j];
        mixed[j].push_back(f(x));
      }
    }
  }
  std::optional<SobolIndices> indices() const { return sobol_indices(a, b, mixed, 0.0); }
};

template <class F>
std::optional<SobolIndices> indices_of(const F& f, std::uint32_t n, int replicate) {
  return Design<3>(f, n, replicate).indices();
}

// A function with known indices. The last input has no influence.
double ishigami(const std::array<double, 4>& u) {
  const auto at = [&](int j) { return std::numbers::pi * (2 * u[j] - 1); };
  const double x3 = at(2) * at(2);
  return std::sin(at(0)) + 7 * std::sin(at(1)) * std::sin(at(1)) + 0.1 * x3 * x3 * std::sin(at(0));
}

TEST(Statistics, IndicesOfIshigamisFunction) {
  const auto c = testing::oracle_case("sampling.json", "ishigami")["expected"];
  for (int j = 0; j < 4; ++j) {
    std::vector<double> s, s_t;
    for (int r = 0; r < 8; ++r) {
      const auto indices = Design<4>(ishigami, 4096, r).indices();
      ASSERT_TRUE(indices);
      s.push_back(indices->first[j]);
      s_t.push_back(indices->total[j]);
    }
    const Estimate first = estimate(s), total = estimate(s_t);
    if (j == 3) {
      EXPECT_EQ(first.value, 0.0);
      EXPECT_EQ(total.value, 0.0);
      continue;
    }
    EXPECT_NEAR(first.value, c["first"][j], 4 * *first.standard_error);
    EXPECT_NEAR(total.value, c["total"][j], 4 * *total.standard_error);
    EXPECT_LT(*first.standard_error, 2e-3);
    EXPECT_LT(*total.standard_error, 2e-3);
  }
}

// The G function Π (|4 u_j − 2| + a_j)/(1 + a_j) has V_j = 1/(3 (1 + a_j)²), V = Π (1 + V_j) − 1,
// S_j = V_j/V and S_Tj = (V + 1) V_j/((1 + V_j) V). At n = 256, the combined forms have less error
// than Jansen's forms, 1 − Σ (f(B) − f(A_B))²/(2nV) and Σ (f(A) − f(A_B))²/(2nV), alone.
TEST(Statistics, IndicesOfTheGFunctionHaveLessErrorThanJansens) {
  constexpr std::array<double, 4> kA{0, 1, 9, 99};
  const auto g = [&](const std::array<double, 4>& u) {
    double product = 1.0;
    for (int j = 0; j < 4; ++j) product *= (std::abs(4 * u[j] - 2) + kA[j]) / (1 + kA[j]);
    return product;
  };
  const auto part = [&](int j) { return 1 / (3 * (1 + kA[j]) * (1 + kA[j])); };
  double v = 1.0;
  for (int j = 0; j < 4; ++j) v *= 1 + part(j);
  v -= 1.0;
  constexpr int kReplicates = 100;
  std::array<double, 4> own_first{}, own_total{}, jansen_first{}, jansen_total{};  // squares
  for (int r = 0; r < kReplicates; ++r) {
    const Design<4> design(g, 256, r);
    const auto found = design.indices();
    ASSERT_TRUE(found);
    const std::vector<double> a = existing(design.a), b = existing(design.b);
    std::vector<double> both = a;
    both.insert(both.end(), b.begin(), b.end());
    const double scale = 1 / (2 * 256 * moments(both).variance);
    for (int j = 0; j < 4; ++j) {
      double first = 1.0, total = 0.0;
      for (std::size_t i = 0; i < 256; ++i) {
        first -= scale * std::pow(b[i] - *design.mixed[j][i], 2);
        total += scale * std::pow(a[i] - *design.mixed[j][i], 2);
      }
      const double s = part(j) / v, s_t = (v + 1) * part(j) / ((1 + part(j)) * v);
      own_first[j] += std::pow(found->first[j] - s, 2) / kReplicates;
      own_total[j] += std::pow(found->total[j] - s_t, 2) / kReplicates;
      jansen_first[j] += std::pow(first - s, 2) / kReplicates;
      jansen_total[j] += std::pow(total - s_t, 2) / kReplicates;
    }
  }
  for (int j = 0; j < 4; ++j) {
    EXPECT_LT(own_first[j], jansen_first[j]) << j;
    EXPECT_LE(own_total[j], jansen_total[j]) << j;
  }
  EXPECT_LT(std::sqrt(own_first[2]), 0.4 * std::sqrt(jansen_first[2]));
  EXPECT_LT(std::sqrt(own_first[3]), 0.05 * std::sqrt(jansen_first[3]));
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
  EXPECT_FALSE(indices_of([](const auto&) { return std::nullopt; }, 64, 0));
}

// If f has no value at a point, only this point is left out, and the indices are still computed.
TEST(Statistics, IndicesWithoutLostPoints) {
  const auto f = [](const std::array<double, 3>& u) {
    return u[0] > 0.9 ? std::nullopt : std::optional(u[1]);
  };
  const auto indices = indices_of(f, 4096, 0);
  ASSERT_TRUE(indices);
  EXPECT_EQ(indices->first[0], 0.0);
  EXPECT_EQ(indices->total[0], 0.0);
  EXPECT_NEAR(indices->first[1], 1.0, 1e-2);
  EXPECT_NEAR(indices->total[1], 1.0, 1e-2);
}

}  // namespace
}  // namespace gearwright
