// Tests the roots of polynomials that are constructed from known roots.
#include "gearwright/math/root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

// Π (x − r), lowest power first.
std::vector<double> from_roots(const std::vector<double>& roots) {
  std::vector<double> c{1.0};
  for (const double r : roots) {
    c.push_back(0.0);
    for (std::size_t i = c.size() - 1; i > 0; --i) c[i] = c[i - 1] - r * c[i];
    c[0] *= -r;
  }
  return c;
}

TEST(Polynomial, evaluates_by_powers) {
  const std::vector<double> c{1.0, -2.0, 3.0};
  EXPECT_EQ(evaluate_polynomial(c, 2.0), 9.0);
  EXPECT_EQ(evaluate_polynomial(c, 0.0), 1.0);
  EXPECT_EQ(evaluate_polynomial({}, 5.0), 0.0);
}

TEST(Polynomial, finds_all_roots_in_order) {
  const std::vector<double> wanted{-0.75, -0.5, 0.125, 0.25, 0.875};  // exact in binary
  const std::vector<double> found = polynomial_roots(from_roots(wanted), -1.0, 1.0);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    // A root is computed with an error of Σ|c_i||x|^i ε/|p'(x)|. The closest two roots are 1/8
    // apart, and |p'| ≥ 0.04.
    EXPECT_NEAR(found[i], wanted[i], 100 * std::numeric_limits<double>::epsilon());
  }
}

TEST(Polynomial, only_those_in_the_interval) {
  const std::vector<double> c = from_roots({-2.0, 0.5, 3.0});
  EXPECT_EQ(polynomial_roots(c, 0.0, 1.0), std::vector<double>{0.5});
  EXPECT_TRUE(polynomial_roots(c, 0.75, 2.0).empty());
}

TEST(Polynomial, touching_zero_is_no_change_of_sign) {
  EXPECT_TRUE(polynomial_roots(from_roots({0.5, 0.5}), 0.0, 1.0).empty());
  const std::vector<double> triple = polynomial_roots(from_roots({0.5, 0.5, 0.5}), 0.0, 1.0);
  EXPECT_LE(triple.size(), 1u);
}

TEST(Polynomial, degenerate_ones) {
  EXPECT_TRUE(polynomial_roots(std::vector<double>{}, 0.0, 1.0).empty());
  EXPECT_TRUE(polynomial_roots(std::vector<double>{3.0}, 0.0, 1.0).empty());
  EXPECT_TRUE(polynomial_roots(std::vector<double>{0.0, 0.0, 0.0}, 0.0, 1.0).empty());
  EXPECT_TRUE(polynomial_roots(std::vector<double>{-0.5, 1.0}, 0.6, 0.6).empty());
  // Leading zeros do not raise the degree.
  EXPECT_EQ(polynomial_roots(std::vector<double>{-0.5, 1.0, 0.0, 0.0}, 0.0, 1.0),
            std::vector<double>{0.5});
}

// Bisection ends when two neighbouring doubles bracket the root, so the value changes its sign
// within one ulp.
TEST(Polynomial, brackets_to_neighbouring_doubles) {
  const std::vector<double> c{-2.0, 0.0, 1.0};  // √2
  const std::vector<double> found = polynomial_roots(c, 0.0, 2.0);
  ASSERT_EQ(found.size(), 1u);
  const double next = std::nextafter(found[0], 2.0);
  EXPECT_LE(evaluate_polynomial(c, found[0]) * evaluate_polynomial(c, next), 0.0);
}

TEST(PolynomialDeathTest, the_interval_runs_upward) {
  GW_EXPECT_VIOLATION(polynomial_roots(std::vector<double>{-0.5, 1.0}, 1.0, 0.0));
}

}  // namespace
}  // namespace gearwright
