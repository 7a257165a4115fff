// The involute and its inverse are compared with 20 digits that mpmath computed with a precision of
// 40 digits. The cases include both sides of the limit between series and closed formula.
#include "gearwright/math/involute.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

using testing::kDegree;
using testing::kEps;

struct Known {
  double in, out;
};

TEST(Involute, known_values) {
  // The series is used up to α = 0.46. Above this angle, tan α − α loses 3ε/α², which is 14 ε at
  // 0.46.
  for (const auto& [alpha, inv] : {Known{0.000017453292519943296, 1.7721923116185322917e-15},
                                   {0.0087266462599716479, 2.2153078714144991774e-7},
                                   {0.25307274153917778865, 0.0055448428167124932231},
                                   {0.34906585039886591538, 0.014904383867336445966},
                                   {0.45378560551852569538, 0.033946983047335732773},
                                   {0.47123889803846898577, 0.038286551455959824744},
                                   {0.78539816339744830962, 0.21460183660255169038},
                                   {1.3962634015954636615, 4.2750184180222458695}}) {
    // The angle is rounded too. The relative condition number α tan²α/inv α is at most 11, in the
    // last case.
    EXPECT_NEAR(involute(alpha), inv, 16 * kEps * inv) << alpha;
    EXPECT_EQ(involute(-alpha), -involute(alpha));
  }
  EXPECT_EQ(involute(0.0), 0.0);
}

TEST(Involute, of_roll_known_values) {
  for (const auto& [xi, inv] : {Known{1e-5, 3.3333333331333333333e-16},
                                {0.1, 0.00033134750883797262155},
                                {0.28, 0.0069912969132893970509},
                                {0.29, 0.0077425780185088787319},
                                {1.0, 0.21460183660255169038},
                                {10.0, 8.5288723256962654081},
                                {1000.0, 998.43020367287177025}}) {
    EXPECT_NEAR(involute_of_roll(xi), inv, 20 * kEps * inv) << xi;  // the closed formula loses
                                                                    // 3ε/(2ξ²) = 18 ε at 0.29
    EXPECT_EQ(involute_of_roll(-xi), -involute_of_roll(xi));
  }
}

TEST(Involute, series_meet_the_formulas_at_their_seams) {
  for (const double alpha : {0.44, 0.45, 0.459}) {
    EXPECT_NEAR(detail::tan_minus_self_series(alpha), std::tan(alpha) - alpha, 4 * kEps * alpha);
  }
  for (const double xi : {0.26, 0.27, 0.279}) {
    EXPECT_NEAR(detail::self_minus_atan_series(xi), xi - std::atan(xi), 4 * kEps * xi);
  }
}

TEST(Involute, inverse_known_values) {
  for (const auto& [y, alpha] : {Known{1e-12, 0.0001442249566307408393},
                                 {1e-4, 0.066903318047788568141},
                                 {0.0149, 0.34903275478897458393},
                                 {0.59, 1.0130535839976467127},
                                 {0.6, 1.0169115882410347139},
                                 {5.0, 1.416184343923839932},
                                 {1000.0, 1.5697978944641562422}}) {
    EXPECT_NEAR(inverse_involute(y), alpha, 4 * kEps * alpha) << y;
    EXPECT_EQ(inverse_involute(-y), -inverse_involute(y));
  }
  EXPECT_EQ(inverse_involute(0.0), 0.0);
}

// inverse_involute divides an error of inv α by its derivative tan² α. An error of 16 ε relative in
// inv α becomes 16 ε inv α/tan² α, which is about 16 ε α/3 for small α and less for larger α.
TEST(Involute, inverse_undoes_it) {
  for (double alpha = 1e-8; alpha < 1.55; alpha *= 1.07) {
    EXPECT_NEAR(inverse_involute(involute(alpha)), alpha, 16 * kEps * alpha) << alpha;
  }
}

TEST(Involute, inverse_of_the_smallest_numbers_is_finite) {
  for (const double y : {std::numeric_limits<double>::denorm_min(), 1e-300, 1e-100, 1e6, 1e12}) {
    const double alpha = inverse_involute(y);
    EXPECT_GT(alpha, 0.0);
    EXPECT_LT(alpha, std::numbers::pi / 2);
  }
}

TEST(InvoluteDeathTest, a_right_angle_has_none) {
  GW_EXPECT_VIOLATION(involute(90.1 * kDegree));
  GW_EXPECT_VIOLATION(inverse_involute(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace gearwright
