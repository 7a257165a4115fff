// Percentiles of a distribution that is known exactly: the sum of three uniform numbers, with
// F(x) = x³/6 for x ≤ 1 and a standard deviation of ½.
#include "gearwright/scatter/spread.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/math/sobol.hpp"

namespace gearwright {
namespace {

constexpr int kSumSamples = 64, kSumReplicates = 8;

SampleValues sums(std::uint64_t seed) {
  const SobolPoints sobol(3);
  SampleValues values;
  for (int r = 0; r < kSumReplicates; ++r) {
    for (std::uint32_t n = 0; n < kSumSamples; ++n) {
      double sum = 0.0;
      for (int j = 0; j < 3; ++j)
        sum += unit_interval(owen_scrambled(sobol.bits(n, j), scramble_key(seed, r, j)));
      values.push_back(sum);
    }
  }
  return values;
}

// An interval about the mean of the percentiles of the replicates would contain the exact
// percentile in only three of four trials.
TEST(Spread, IntervalsContainTheExactPercentiles) {
  const double low = std::cbrt(0.3);
  const std::array<double, 3> exact{low, 1.5, 3.0 - low};
  ScatterTask task;
  constexpr int kTrials = 200;
  std::array<int, 3> inside{};
  int deviation = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto spread = spread_of(task, sums(static_cast<std::uint64_t>(trial)), kSumSamples);
    ASSERT_TRUE(spread);
    for (std::size_t i = 0; i < 3; ++i) {
      const Percentile& p = spread->percentiles[i];
      inside[i] += *p.lower <= exact[i] && exact[i] <= *p.upper;
    }
    const ConfidenceInterval of_deviation =
        interval(spread->standard_deviation, kSumReplicates, task.confidence);
    deviation += of_deviation.lower <= 0.5 && 0.5 <= of_deviation.upper;
  }
  // 95 % of the trials, less three standard deviations of the binomial distribution.
  for (const int count : inside) EXPECT_GE(count, 0.90 * kTrials);
  EXPECT_GE(deviation, 0.90 * kTrials);
}

// Two replicates, one with only zeros and one with only tens, give intervals that extend far below
// 0 and far above 10. If the values of the quantity are limited to 0 to 10, the intervals end at 0
// and at 10.
TEST(Spread, IntervalsEndAtPossibleValues) {
  ScatterTask task;
  SampleValues values(2 * kSumSamples, 0.0);
  for (std::size_t n = kSumSamples; n < values.size(); ++n) values[n] = 10.0;
  const auto free = spread_of(task, values, kSumSamples);
  const auto limited = spread_of(task, values, kSumSamples, {0.0, 10.0});
  ASSERT_TRUE(free && limited);
  for (std::size_t i = 0; i < free->percentiles.size(); ++i) {
    const Percentile &wide = free->percentiles[i], &cut = limited->percentiles[i];
    EXPECT_LT(*wide.lower, 0.0);
    EXPECT_GT(*wide.upper, 10.0);
    EXPECT_EQ(*cut.lower, 0.0);
    EXPECT_EQ(*cut.upper, 10.0);
    EXPECT_EQ(cut.estimate.value, wide.estimate.value);
    EXPECT_EQ(*cut.estimate.standard_error, *wide.estimate.standard_error);
  }
}

TEST(Spread, LostSamplesAreLeftOut) {
  SampleValues values(kSumSamples * kSumReplicates, 1.0);
  std::fill_n(values.begin(), kSumSamples, std::nullopt);  // a whole replicate
  const auto spread = spread_of(ScatterTask(), values, kSumSamples);
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->mean.value, 1.0);
  EXPECT_EQ(spread->standard_deviation.value, 0.0);
}

}  // namespace
}  // namespace gearwright
