// Golden: points of the published direction numbers and of the scrambling,
// tests/oracle/sampling.json.
// Laws: (1) 2^k points of two coordinates are a (0, k, 2)-net, scrambled or not   (2) keys of
// different seeds, replicates and coordinates differ.
#include "gearwright/math/sobol.hpp"

#include <gtest/gtest.h>

#include <set>

#include "gearwright/base/testing/oracle_case.hpp"
#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

TEST(Sobol, PointsAreThoseOfTheDirectionNumbers) {
  const auto points = testing::oracle_case("sampling.json", "sobol-first-8")["expected"]["points"];
  const SobolPoints sobol(6);
  for (std::uint32_t n = 0; n < 8; ++n)
    for (int j = 0; j < 6; ++j) EXPECT_EQ(sobol.bits(n, j) / 4294967296.0, points[n][j]) << n << j;
}

TEST(Sobol, ScramblingIsTheHash) {
  const auto expected = testing::oracle_case("sampling.json", "owen-scrambled")["expected"];
  const SobolPoints sobol(3);
  for (std::uint32_t n = 0; n < 4; ++n) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_EQ(unit_interval(owen_scrambled(sobol.bits(n, j), scramble_key(1, 0, j))),
                expected["points"][n][j]);
    }
  }
  const auto bits = expected["bits_replicate_5_dimension_2"];
  for (std::uint32_t n = 0; n < bits.size(); ++n)
    EXPECT_EQ(owen_scrambled(sobol.bits(n, 2), scramble_key(42, 5, 2)), bits[n]);
}

// For every shape 2^-i × 2^-(k-i), each of the 2^k boxes must contain exactly one of the first 2^k
// points.
void expect_net(const std::vector<std::array<std::uint32_t, 2>>& points, unsigned k) {
  for (unsigned i = 0; i <= k; ++i) {
    std::set<std::uint64_t> boxes;
    for (const auto& p : points) {
      const std::uint64_t column = std::uint64_t{p[0]} >> (32 - i);
      const std::uint64_t row = std::uint64_t{p[1]} >> (32 - (k - i));
      boxes.insert((column << 32U) + row);
    }
    EXPECT_EQ(boxes.size(), points.size()) << i;
  }
}

TEST(Sobol, PowersOfTwoAreNets) {
  const SobolPoints sobol(2);
  for (const unsigned k : {3U, 6U, 10U}) {
    std::vector<std::array<std::uint32_t, 2>> plain, scrambled;
    for (std::uint32_t n = 0; n < (1U << k); ++n) {
      plain.push_back({sobol.bits(n, 0), sobol.bits(n, 1)});
      scrambled.push_back({owen_scrambled(sobol.bits(n, 0), scramble_key(7, 3, 0)),
                           owen_scrambled(sobol.bits(n, 1), scramble_key(7, 3, 1))});
    }
    expect_net(plain, k);
    expect_net(scrambled, k);
  }
}

// Each single coordinate has one point in each of the 2^k intervals, up to the last coordinate of
// the table.
TEST(Sobol, EveryCoordinateIsStratified) {
  const SobolPoints sobol(SobolPoints::kMaxDimensions);
  for (const int j : {20, 100, 1111, SobolPoints::kMaxDimensions - 1}) {
    std::set<std::uint32_t> intervals;
    for (std::uint32_t n = 0; n < 1024; ++n) intervals.insert(sobol.bits(n, j) >> 22U);
    EXPECT_EQ(intervals.size(), 1024u) << j;
  }
}

TEST(Sobol, KeysDiffer) {
  std::set<std::uint64_t> keys;
  for (int seed = 0; seed < 10; ++seed)
    for (int replicate = 0; replicate < 10; ++replicate)
      for (int j = 0; j < 10; ++j)
        keys.insert(scramble_key(static_cast<std::uint64_t>(seed), replicate, j));
  EXPECT_EQ(keys.size(), 1000u);
}

TEST(Sobol, UnitsAreInsideTheInterval) {
  EXPECT_GT(unit_interval(0), 0.0);
  EXPECT_LT(unit_interval(0xFFFFFFFFU), 1.0);
  double sum = 0.0;
  for (std::uint64_t n = 0; n < 10000; ++n) {
    const double u = random_unit(scramble_key(1, 0, 0), n);
    EXPECT_TRUE(u > 0.0 && u < 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / 10000, 0.5, 5 * 0.2887 / 100);  // five standard errors
}

TEST(Sobol, DimensionsOfTheTable) {
  GW_EXPECT_VIOLATION(SobolPoints(SobolPoints::kMaxDimensions + 1));
  GW_EXPECT_VIOLATION(SobolPoints(0));
}

}  // namespace
}  // namespace gearwright
