// Golden: values of printed tables (R. A. Fisher's and others) to the printed digits, and closed
// forms.
// Laws: (1) an inverse undoes its function   (2) I_x(p, q) = 1 − I_{1−x}(q, p).
#include "gearwright/math/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gearwright {
namespace {

TEST(Probability, NormalDistribution) {
  // Abramowitz and Stegun, table 26.1 (to 15 digits) and 26.5.
  EXPECT_NEAR(normal_cdf(1.0), 0.841344746068543, 1e-15);
  EXPECT_NEAR(normal_cdf(2.0), 0.977249868051821, 1e-15);
  EXPECT_DOUBLE_EQ(normal_cdf(0.0), 0.5);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.95), 1.644853626951473, 1e-14);
  EXPECT_EQ(normal_quantile(0.5), 0.0);
}

TEST(Probability, InversesUndo) {
  for (const double u : {1e-10, 1e-4, 0.02, 0.3, 0.5, 0.77, 0.999, 1 - 1e-9}) {
    EXPECT_NEAR(normal_cdf(normal_quantile(u)), u, 1e-14 * u) << u;
    for (const double p : {0.5, 1.0, 2.0, 3.0, 40.0, 4097.0}) {
      for (const double q : {0.5, 1.0, 2.0, 3.0, 41.0, 4096.0}) {
        const double x = beta_quantile(u, p, q);
        // The spacing of doubles near 1 is 1e-16, and for q = ½ the slope of the function is
        // infinite there.
        const double rounding = q < 1.0 ? 2e-8 : 1e-12;
        EXPECT_NEAR(beta_cdf(x, p, q), u, p * rounding + 1e-11 * u) << u << " " << p << " " << q;
      }
    }
  }
}

TEST(Probability, BetaHasClosedForms) {
  for (const double x : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(beta_cdf(x, 1, 1), x, 1e-15);
    EXPECT_NEAR(beta_cdf(x, 2, 3), x * x * (6 - 8 * x + 3 * x * x), 1e-15);
    EXPECT_NEAR(beta_cdf(x, 0.5, 0.5), 2 / M_PI * std::asin(std::sqrt(x)), 1e-15);
    EXPECT_NEAR(beta_cdf(x, 3, 7), 1 - beta_cdf(1 - x, 7, 3), 1e-14);
  }
}

TEST(Probability, StudentHasClosedForms) {
  for (const double u : {0.01, 0.3, 0.5, 0.9, 0.9999}) {
    const double cauchy = std::tan(M_PI * (u - 0.5));
    EXPECT_NEAR(student_quantile(u, 1), cauchy, 1e-11 * std::abs(cauchy)) << u;
    const double v = 2 * u - 1;
    EXPECT_NEAR(student_quantile(u, 2), v * std::sqrt(2 / (1 - v * v)), 1e-11) << u;
  }
  EXPECT_NEAR(student_quantile(0.975, 7), 2.365, 5e-4);  // [S13] and every printed table
}

}  // namespace
}  // namespace gearwright
