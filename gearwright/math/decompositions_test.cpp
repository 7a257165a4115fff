// Each test substitutes the solution into the problem.
#include "gearwright/math/decompositions.hpp"

#include <gtest/gtest.h>

#include <random>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

using testing::kEps;

Eigen::MatrixXd random_matrix(std::mt19937& engine, int rows, int columns) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&](auto, auto) { return entry(engine); });
}

TEST(Decompositions, symmetric_eigen_rebuilds_the_matrix) {
  std::mt19937 engine(11);
  for (int i = 0; i < 200; ++i) {
    Eigen::Matrix2d m = random_matrix(engine, 2, 2);
    m(0, 1) = m(1, 0);
    const SymmetricEigen e = symmetric_eigen(m);
    EXPECT_LE(e.values[0], e.values[1]);
    const Eigen::Matrix2d rebuilt = e.vectors * e.values.asDiagonal() * e.vectors.transpose();
    EXPECT_LT((rebuilt - m).cwiseAbs().maxCoeff(), 16 * kEps);
    const Eigen::Matrix2d gram = e.vectors.transpose() * e.vectors;
    EXPECT_LT((gram - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff(), 16 * kEps);
  }
}

TEST(Decompositions, symmetric_eigen_reads_the_lower_triangle) {
  Eigen::Matrix2d m;
  m << 2.0, 1e9, 1.0, 2.0;
  const SymmetricEigen e = symmetric_eigen(m);
  EXPECT_NEAR(e.values[0], 1.0, 8 * kEps);
  EXPECT_NEAR(e.values[1], 3.0, 8 * kEps);
}

TEST(Decompositions, solve_linear_solves) {
  std::mt19937 engine(12);
  for (int n = 1; n <= 4; ++n) {
    for (int i = 0; i < 50; ++i) {
      // In each row, the diagonal entry is at least twice the sum of the magnitudes of the other
      // entries, so no entry of x exceeds 1.
      const Eigen::MatrixXd a =
          random_matrix(engine, n, n) + 2.0 * n * Eigen::MatrixXd::Identity(n, n);
      const Eigen::VectorXd b = random_matrix(engine, n, 1);
      EXPECT_LT((a * solve_linear(a, b) - b).cwiseAbs().maxCoeff(), 32 * n * kEps);
    }
  }
}

TEST(Decompositions, solve_linear_leaves_what_is_free_at_zero) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2, 2);
  a(0, 0) = 4.0;
  EXPECT_EQ(solve_linear(a, Eigen::Vector2d(8.0, 0.0)), Eigen::Vector2d(2.0, 0.0));
}

TEST(Decompositions, least_squares_leaves_a_residual_across_the_columns) {
  std::mt19937 engine(13);
  for (int i = 0; i < 100; ++i) {
    const Eigen::MatrixXd a = random_matrix(engine, 7, 3);
    const Eigen::VectorXd b = random_matrix(engine, 7, 1);
    const Eigen::VectorXd residual = a * least_squares(a, b) - b;
    EXPECT_LT((a.transpose() * residual).cwiseAbs().maxCoeff(), 256 * kEps);
  }
}

TEST(Decompositions, least_squares_takes_the_shortest) {
  // The equation x + y = 2 is given twice, and (1, 1) is its solution nearest to the origin.
  const Eigen::MatrixXd a = Eigen::MatrixXd::Ones(2, 2);
  const Eigen::VectorXd x = least_squares(a, Eigen::Vector2d(2.0, 2.0));
  EXPECT_NEAR(x[0], 1.0, 8 * kEps);
  EXPECT_NEAR(x[1], 1.0, 8 * kEps);
}

TEST(Decompositions, sums_do_not_depend_on_the_cache_of_the_processor) {
  // Eigen divides a long sum into parts that fit into the first-level cache. By default, the size
  // of the parts depends on the processor on which the program runs.
  EXPECT_EQ(Eigen::l1CacheSize(), 32768);
}

TEST(DecompositionsDeathTest, shapes_are_contracts) {
  GW_EXPECT_VIOLATION(solve_linear(Eigen::MatrixXd::Zero(2, 3), Eigen::Vector2d::Zero()));
  GW_EXPECT_VIOLATION(least_squares(Eigen::MatrixXd::Zero(3, 2), Eigen::Vector2d::Zero()));
}

}  // namespace
}  // namespace gearwright
