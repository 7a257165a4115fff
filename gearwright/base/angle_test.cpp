// Laws of turns: quarter turns are exact, tooth n is tooth 0 bit for bit, and the point lies on the
// circle within rounding.
//
//   ε    2⁻⁵², the spacing of doubles at 1
#include "gearwright/base/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

using testing::kEps;

TEST(SincosTurn, QuarterTurnsAreExact) {
  for (const long long quarter : {1LL, 2LL, 3LL, 5LL, 25LL, 1'000'003LL, 1LL << 40}) {
    const long long n = 4 * quarter;
    const SinCos expected[] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
    for (int q = 0; q < 4; ++q) {
      const SinCos got = sincos_turn(q * quarter, n);
      EXPECT_EQ(got.sin, expected[q].sin) << q << " quarters of " << n;
      EXPECT_EQ(got.cos, expected[q].cos) << q << " quarters of " << n;
    }
  }
  EXPECT_EQ(sincos_turn(1, 2).cos, -1.0);
  EXPECT_EQ(sincos_turn(1, 1).sin, 0.0);
}

TEST(SincosTurn, ToothZIsToothZero) {
  for (long long n = 1; n <= 200; ++n) {
    for (long long k = 0; k < n; ++k) {
      const SinCos once = sincos_turn(k, n);
      for (const long long turns : {-1'000'000LL, -1LL, 1LL, 7LL}) {
        const SinCos again = sincos_turn(k + turns * n, n);
        EXPECT_EQ(once.sin, again.sin) << k << " of " << n;
        EXPECT_EQ(once.cos, again.cos) << k << " of " << n;
      }
    }
  }
}

// A fraction need not be in lowest terms: k/n and mk/(mn) are the same turn. Here m is a power of
// two, so both quotients round to the same double.
TEST(SincosTurn, TheFractionIsWhatCounts) {
  for (long long n = 1; n <= 100; ++n) {
    for (long long k = 0; k < n; ++k) {
      EXPECT_EQ(sincos_turn(k, n).sin, sincos_turn(16 * k, 16 * n).sin) << k << " of " << n;
      EXPECT_EQ(sincos_turn(k, n).cos, sincos_turn(16 * k, 16 * n).cos) << k << " of " << n;
    }
  }
}

// The library's sin and cos are within 0.55 ε relative, so s² + c² is within 1.1 ε. The rounding of
// the two squares adds at most ε/2, and the rounding of their sum adds ε/2. The limit is therefore
// 2.1 ε.
TEST(SincosTurn, LiesOnTheUnitCircle) {
  for (long long n = 1; n <= 1000; ++n) {
    for (long long k = 0; k < n; ++k) {
      const auto [s, c] = sincos_turn(k, n);
      EXPECT_NEAR(s * s + c * c, 1.0, 2.1 * kEps) << k << " of " << n;
    }
  }
}

// The reference values are the long double sine and cosine of 2πk/n, which is not reduced. The
// reduced argument is at most π/4. Its three roundings (quotient, constant, product) are together
// below 1.5 ε relative, and the functions add 0.55 ε. Because x cot x <= 1 and x tan x <= 1 there,
// the sum is 2.05 ε relative. The argument of the reference, below 2π, has roundings of about 2⁻⁶²,
// for which the limit contains the constant 2⁻⁶¹.
TEST(SincosTurn, AgreesWithTheUnreducedAngle) {
  static_assert(std::numeric_limits<long double>::digits >= 64, "the reference needs more digits");
  std::mt19937_64 random(20240);
  for (int i = 0; i < 100'000; ++i) {
    const long long n = 1 + static_cast<long long>(random() % 100'000);
    const long long k = static_cast<long long>(random() % static_cast<unsigned long long>(n));
    const long double turn =
        2 * testing::kLongPi * static_cast<long double>(k) / static_cast<long double>(n);
    const auto [s, c] = sincos_turn(k, n);
    const double floor = std::ldexp(1.0, -61);
    const auto sin = static_cast<double>(std::sin(turn));
    const auto cos = static_cast<double>(std::cos(turn));
    // The limit is 0.5 ε larger, because the reference is rounded to double here.
    EXPECT_NEAR(s, sin, 2.55 * kEps * std::abs(sin) + floor) << k << " of " << n;
    EXPECT_NEAR(c, cos, 2.55 * kEps * std::abs(cos) + floor) << k << " of " << n;
  }
}

TEST(SincosTurnDeath, NoTeethIsAContract) { GW_EXPECT_VIOLATION(sincos_turn(0, 0)); }

TEST(Angle, DegreesAndRadiansAreOneThing) {
  using namespace literals;
  EXPECT_EQ(Angle::degrees(180).rad(), std::numbers::pi);
  EXPECT_EQ((-90_deg).rad(), -std::numbers::pi / 2);
  EXPECT_EQ(22.5_deg + 22.5_deg, 45_deg);
  EXPECT_LT(-(20_deg), 15_deg);
  for (int d = -720; d <= 720; ++d) {
    // The two constants and the two products each round by at most ε/2 relative, 2 ε in total.
    EXPECT_NEAR(Angle::degrees(d).deg(), d, 2 * kEps * std::abs(d)) << d;
  }
}

TEST(Angle, degrees_of_ten_decimals_come_back_as_they_were_given) {
  for (const double step : {1.0, 0.1, 1e-3, 1e-7, 1e-10}) {
    for (int k = -720; k <= 720; ++k) {
      const double given = std::round(k * step * 1e10) / 1e10;
      EXPECT_EQ(Angle::degrees(given).deg(), given);
    }
  }
  EXPECT_EQ(Angle::degrees(60).deg(), 60);
  // Any other angle is returned within rounding. NaN and −0 are returned unchanged.
  EXPECT_NEAR(Angle::degrees(12.345678901234567).deg(), 12.345678901234567, 2e-15);
  EXPECT_TRUE(std::isnan(Angle::radians(std::nan("")).deg()));
  EXPECT_TRUE(std::signbit(Angle::radians(-0.0).deg()));
  EXPECT_EQ(Angle::degrees(1e300).deg(), 1e300 * kRadPerDeg * kDegPerRad);
}

}  // namespace
}  // namespace gearwright
