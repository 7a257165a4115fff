// Laws: (1) F⁻¹ grows and stays in the range; (2) its mean and variance over u agree with the
// closed forms; (3) a range of width 0 gives one number. Golden: the standard deviation of a
// truncated normal distribution.
#include "gearwright/scatter/distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gearwright/math/sobol.hpp"

namespace gearwright {
namespace {

using Kind = DistributionSpec::Kind;

Distribution made(const DistributionSpec& spec) {
  auto distribution = Distribution::of(spec);
  EXPECT_TRUE(distribution) << distribution.error().message();
  return std::move(distribution).take();
}

const std::vector<DistributionSpec>& several() {
  static const std::vector<DistributionSpec> list{{{-0.02, 0.05}},
                                                  {{-1.0, 3.0}, Kind::triangular},
                                                  {{-0.02, 0.02}, Kind::normal, 1.33},
                                                  {{-0.02, 0.06}, Kind::normal, 0.4, 0.03},
                                                  {{-0.02, 0.02}, Kind::normal, 1.67, -0.015},
                                                  {{-0.06, 0.09}, Kind::beta, 1.0, 0.0, {2.0, 3.0}},
                                                  {{0.0, 1.0}, Kind::beta, 1.0, 0.0, {0.5, 0.5}}};
  return list;
}

TEST(Distribution, MomentsAreThoseOfTheQuantiles) {
  for (const DistributionSpec& spec : several()) {
    const Distribution d = made(spec);
    std::vector<double> x;
    constexpr int n = 1 << 16;
    for (int i = 0; i < n; ++i) {
      x.push_back(d.at((i + 0.5) / n));
      ASSERT_TRUE(x.back() >= d.least() && x.back() <= d.greatest());
      ASSERT_GE(x.back(), x[std::max(0, i - 1)]);
    }
    const Moments found = moments(x);
    const double width = d.greatest() - d.least();
    // The tolerances cover the error of the midpoint rule. At an end, the slope of F⁻¹ grows at
    // most like u^(−1/2).
    EXPECT_NEAR(found.mean, d.moments().mean, 1e-6 * width);
    EXPECT_NEAR(found.variance, d.moments().variance, 1e-4 * width * width);
  }
}

TEST(Distribution, NormalIsCutAtItsLimits) {
  // σ_cut/σ at C_pk = 1: √(1 − 6 φ(3)/(2 Φ(3) − 1)) = 0.98658 (page 14).
  const Distribution d = made({{-3.0, 3.0}, Kind::normal, 1.0});
  EXPECT_NEAR(std::sqrt(d.moments().variance), 0.98658, 1e-5);
  EXPECT_NEAR(d.at(0.5), 0.0, 1e-15);
  EXPECT_NEAR(d.at(1e-12), -3.0, 1e-8);
  EXPECT_NEAR(d.at(1 - 1e-12), 3.0, 1e-8);
  // If the mean is not in the middle, the nearer end is 3 C_pk standard deviations away.
  const Distribution off = made({{-3.0, 3.0}, Kind::normal, 1.0, 1.5});
  EXPECT_NEAR(off.at(0.5), 1.5 - 0.5 * 1.25331 * 2 * (1 - 0.99865), 3e-3);
}

TEST(Distribution, OthersHaveClosedQuantiles) {
  EXPECT_DOUBLE_EQ(made({{-1.0, 3.0}}).at(0.25), 0.0);
  EXPECT_DOUBLE_EQ(made({{-1.0, 1.0}, Kind::triangular}).at(0.125), -0.5);
  EXPECT_DOUBLE_EQ(made({{-1.0, 1.0}, Kind::triangular}).at(0.875), 0.5);
  EXPECT_NEAR(made({{0.0, 2.0}, Kind::beta, 1.0, 0.0, {2.0, 1.0}}).at(0.25), 1.0, 1e-14);
}

TEST(Distribution, NoWidthIsOneNumber) {
  for (const Kind kind : {Kind::uniform, Kind::triangular, Kind::normal, Kind::beta}) {
    const Distribution d = made({{0.01, 0.01}, kind});
    EXPECT_FALSE(d.varies());
    EXPECT_EQ(d.at(0.3), 0.01);
    EXPECT_EQ(d.moments().variance, 0.0);
  }
}

TEST(Distribution, DiscIsFilledEvenly) {
  // A uniform disc has var x = R²/4, and half of its points lie within R/√2.
  const SobolPoints sobol(2);
  double sum = 0.0;
  int inner = 0;
  constexpr std::uint32_t n = 4096;
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto [x, y] =
        in_disc(2.0, unit_interval(sobol.bits(i, 0)), unit_interval(sobol.bits(i, 1)));
    ASSERT_LE(x * x + y * y, 4.0 + 1e-12);
    sum += x * x;
    if (x * x + y * y < 2.0) ++inner;
  }
  EXPECT_NEAR(sum / n, 1.0, 2e-3);
  EXPECT_EQ(inner, static_cast<int>(n) / 2);
}

TEST(Distribution, RefusesWhatIsNone) {
  const auto field = [](const DistributionSpec& spec) {
    const auto d = Distribution::of(spec);
    return d ? std::string() : d.error().field;
  };
  EXPECT_EQ(field({{0.02, -0.02}}), "range");
  EXPECT_EQ(field({{-0.02, NAN}}), "range");
  EXPECT_EQ(field({{-1.0, 1.0}, Kind::normal, 0.0}), "cpk");
  EXPECT_EQ(field({{-1.0, 1.0}, Kind::normal, -1.0}), "cpk");
  EXPECT_EQ(field({{-1.0, 1.0}, Kind::normal, 1.0, 1.0}), "offset");
  EXPECT_EQ(field({{-1.0, 1.0}, Kind::beta, 1.0, 0.0, {0.0, 1.0}}), "shape");
}

}  // namespace
}  // namespace gearwright
