#include "gearwright/math/bspline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

Eigen::MatrixXd sample_at_greville(const BSplineBasis& basis, double (*x)(double),
                                   double (*y)(double)) {
  Eigen::MatrixXd samples(basis.poles(), 2);
  for (int i = 0; i < basis.poles(); ++i) {
    const double u = basis.greville()[static_cast<std::size_t>(i)];
    samples(i, 0) = x(u);
    samples(i, 1) = y(u);
  }
  return samples;
}

double worst(const BSplineBasis& basis, const Eigen::MatrixXd& poles, double (*x)(double),
             double (*y)(double)) {
  double result = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double u = i / 1000.0;
    result = std::max(result, (basis.evaluate(poles, u) - Eigen::Vector2d(x(u), y(u))).norm());
  }
  return result;
}

double quintic(double u) { return ((((2 * u - 1) * u + 3) * u - 2) * u + 1) * u - 4; }
double cube(double u) { return u * u * u - u; }
double sine(double u) { return std::sin(3 * u); }
double exponential(double u) { return std::exp(u); }

TEST(BSplineBasis, KnotsAreClampedAndUniform) {
  const BSplineBasis basis(3, 6);
  EXPECT_EQ(basis.knots(), (std::vector<double>{0, 0, 0, 0, 1.0 / 3, 2.0 / 3, 1, 1, 1, 1}));
  EXPECT_EQ(basis.distinct_knots(), (std::vector<double>{0, 1.0 / 3, 2.0 / 3, 1}));
  EXPECT_EQ(basis.multiplicities(), (std::vector<int>{4, 1, 1, 4}));
  ASSERT_EQ(basis.greville().size(), 6U);
  EXPECT_EQ(basis.greville().front(), 0.0);
  EXPECT_EQ(basis.greville().back(), 1.0);
}

TEST(BSplineBasis, PartitionOfUnityAndLinearPrecision) {
  for (int degree = 1; degree <= 7; ++degree) {
    const BSplineBasis basis(degree, degree + 9);
    for (int i = 0; i <= 97; ++i) {
      const double u = i / 97.0;
      const BSplineBasis::Local here = basis.local(u);
      double sum = 0.0;
      double mean = 0.0;
      for (int j = 0; j <= degree; ++j) {
        const double value = here.values[static_cast<std::size_t>(j)];
        EXPECT_GE(value, 0.0);
        sum += value;
        mean += value * basis.greville()[static_cast<std::size_t>(here.first + j)];
      }
      EXPECT_NEAR(sum, 1.0, 4e-16 * degree);
      EXPECT_NEAR(mean, u, 4e-16 * degree);
    }
  }
}

TEST(BSplineBasis, EndsAreInterpolatedBitForBit) {  // law 1
  const BSplineBasis basis(5, 14);
  const Eigen::MatrixXd samples = sample_at_greville(basis, sine, exponential);
  const Eigen::MatrixXd poles = basis.interpolate(samples);
  EXPECT_EQ(poles.row(0), samples.row(0));
  EXPECT_EQ(poles.row(13), samples.row(13));
  EXPECT_EQ(basis.evaluate(poles, 0.0).transpose(), samples.row(0));
  EXPECT_EQ(basis.evaluate(poles, 1.0).transpose(), samples.row(13));
}

TEST(BSplineBasis, PolynomialsAreReproduced) {  // law 2
  const BSplineBasis uniform(5, 20);
  EXPECT_LT(worst(uniform, uniform.interpolate(sample_at_greville(uniform, quintic, cube)), quintic,
                  cube),
            2e-14);
  const BSplineBasis given(
      5, std::vector<double>{0, 0, 0, 0, 0, 0, 0.1, 0.15, 0.15, 0.7, 1, 1, 1, 1, 1, 1});
  EXPECT_LT(
      worst(given, given.interpolate(sample_at_greville(given, quintic, cube)), quintic, cube),
      2e-14);
}

TEST(BSplineBasis, MirroredPolesDrawTheCurveBackwards) {  // law 3
  const BSplineBasis basis(4, 11);
  const Eigen::MatrixXd poles = basis.interpolate(sample_at_greville(basis, sine, exponential));
  const Eigen::MatrixXd mirrored = poles.colwise().reverse();
  for (int i = 0; i <= 64; ++i) {
    const double u = i / 64.0;
    EXPECT_LT((basis.evaluate(poles, u) - basis.evaluate(mirrored, 1.0 - u)).norm(), 4e-15);
  }
}

TEST(BSplineBasis, ErrorFallsWithTheOrder) {
  // The error of degree p is of the order h^(p+1), so halving the spans of a quintic must reduce it
  // by nearly 2^6.
  const BSplineBasis coarse(5, 5 + 8);
  const BSplineBasis fine(5, 5 + 16);
  const double e_coarse = worst(
      coarse, coarse.interpolate(sample_at_greville(coarse, sine, exponential)), sine, exponential);
  const double e_fine =
      worst(fine, fine.interpolate(sample_at_greville(fine, sine, exponential)), sine, exponential);
  EXPECT_GT(e_coarse / e_fine, 32.0);
  EXPECT_LT(e_fine, 1e-8);
}

TEST(BSplineBasis, DerivativesAgreeWithTheFunction) {
  const BSplineBasis basis(7, 24);
  const Eigen::MatrixXd poles = basis.interpolate(sample_at_greville(basis, sine, exponential));
  for (int i = 0; i <= 50; ++i) {
    const double u = i / 50.0;
    EXPECT_NEAR(basis.derivative(poles, u, 0)(0), std::sin(3 * u), 1e-11);
    EXPECT_NEAR(basis.derivative(poles, u, 1)(0), 3 * std::cos(3 * u), 1e-8);
    EXPECT_NEAR(basis.derivative(poles, u, 2)(0), -9 * std::sin(3 * u), 1e-6);
    EXPECT_NEAR(basis.derivative(poles, u, 1)(1), std::exp(u), 1e-8);
  }
  EXPECT_EQ(basis.derivative(poles, 0.3, 8).norm(), 0.0);
  // A spline of degree 5 reproduces a quintic, so all derivatives are exact up to rounding.
  const BSplineBasis five(5, 9);
  const Eigen::MatrixXd q = five.interpolate(sample_at_greville(five, quintic, cube));
  for (double u : {0.0, 0.21, 0.5, 1.0}) EXPECT_NEAR(five.derivative(q, u, 3)(1), 6.0, 1e-10);
}

TEST(BSplineBasisDeathTest, Contracts) {
  GW_EXPECT_VIOLATION(BSplineBasis(3, 3));
  GW_EXPECT_VIOLATION(BSplineBasis(2, std::vector<double>{0, 0, 0.5, 1, 1, 1}));
  GW_EXPECT_VIOLATION(BSplineBasis(2, std::vector<double>{0, 0, 0, 0.6, 0.5, 1, 1, 1}));
  GW_EXPECT_VIOLATION(BSplineBasis(2, std::vector<double>{0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}));
  GW_EXPECT_VIOLATION(BSplineBasis(3, 5).interpolate(Eigen::MatrixXd::Zero(4, 2)));
}

}  // namespace
}  // namespace gearwright
