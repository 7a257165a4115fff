// For random positions, the active set method is compared with a slow search that shares no code
// with it. This search solves the dual problem by non-negative least squares (Lawson and Hanson).
// The laws of the result are also tested.
#include "gearwright/load/complementarity.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>
#include <random>
#include <vector>

namespace gearwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ContactProblem random_problem(unsigned seed, int n) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  ContactProblem q;
  const MatrixXd root = MatrixXd::NullaryExpr(n, n, [&] { return unit(random) - 0.4; });
  q.yield = std::make_shared<const MatrixXd>(
      1e-6 * (root * root.transpose() + 0.2 * MatrixXd::Identity(n, n)));
  q.gap = VectorXd::NullaryExpr(n, [&] { return 4e-3 * unit(random); });
  q.arm = VectorXd::NullaryExpr(n, [&] { return 40 + unit(random); });
  q.radius = VectorXd::Constant(n, 8.0);
  q.length = 1.0;
  q.moment = 4e4 * unit(random) + 1.0;
  return q;
}

// Minimises ½ pᵀA p + gᵀp under Σ p arm = M and p ≥ 0 by non-negative least squares. With A = LLᵀ,
// the objective is ½ |Lᵀp + L⁻¹g|² plus a constant. The moment is an additional row with a large
// weight.
VectorXd least_squares_answer(const ContactProblem& q) {
  const auto n = q.gap.size();
  const Eigen::LLT<MatrixXd> llt(*q.yield);
  const MatrixXd upper = llt.matrixU();
  const double heavy = 1e5 * upper.norm();
  MatrixXd a(n + 1, n);
  VectorXd b(n + 1);
  a.topRows(n) = upper;
  b.head(n) = -llt.matrixL().solve(q.gap);
  a.row(n) = heavy * q.arm.transpose() / q.arm[0];
  b[n] = heavy * q.moment / q.arm[0] / q.length;
  std::vector<char> in(n, 0);
  VectorXd x = VectorXd::Zero(n);
  const auto solve = [&] {
    std::vector<Eigen::Index> at;
    for (Eigen::Index i = 0; i < n; ++i)
      if (in[i]) at.push_back(i);
    MatrixXd s(n + 1, static_cast<Eigen::Index>(at.size()));
    for (std::size_t i = 0; i < at.size(); ++i) s.col(i) = a.col(at[i]);
    const VectorXd y = s.colPivHouseholderQr().solve(b);
    VectorXd z = VectorXd::Zero(n);
    for (std::size_t i = 0; i < at.size(); ++i) z[at[i]] = y[i];
    return z;
  };
  for (int turn = 0; turn < 500; ++turn) {
    const VectorXd w = a.transpose() * (b - a * x);
    Eigen::Index best = -1;
    for (Eigen::Index i = 0; i < n; ++i)
      if (!in[i] && w[i] > 1e-9 * heavy * heavy * 1e-12 && (best < 0 || w[i] > w[best])) best = i;
    if (best < 0) break;
    in[best] = 1;
    VectorXd z = solve();
    while (true) {
      double step = 1.0;
      for (Eigen::Index i = 0; i < n; ++i)
        if (in[i] && z[i] <= 0.0) step = std::min(step, x[i] / (x[i] - z[i]));
      if (step == 1.0) break;
      x += step * (z - x);
      for (Eigen::Index i = 0; i < n; ++i)
        if (in[i] && x[i] <= 1e-12 * x.maxCoeff()) in[i] = 0, x[i] = 0.0;
      z = solve();
    }
    x = z;
  }
  return x;
}

TEST(Complementarity, AgreesWithNonNegativeLeastSquares) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    const ContactProblem q = random_problem(seed, 3 + static_cast<int>(seed % 14));
    const ContactSolution x = solve_contact(q);
    ASSERT_TRUE(x.found()) << seed;
    const VectorXd other = least_squares_answer(q);
    EXPECT_LT((x.line_load - other).cwiseAbs().maxCoeff(), 1e-5 * x.line_load.maxCoeff()) << seed;
  }
}

TEST(Complementarity, HoldsItsConditions) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    ContactProblem q = random_problem(1000 + seed, 2 + static_cast<int>(seed % 40));
    q.local = 2e-7;
    q.half_width = 3.0;  // far above every contact width, so the local term increases with the load
    q.reduced_modulus = 1.1e5;
    const ContactSolution x = solve_contact(q);
    ASSERT_TRUE(x.found()) << seed;
    EXPECT_NEAR(q.length * x.line_load.dot(q.arm), q.moment, 1e-12 * q.moment);
    for (Eigen::Index i = 0; i < q.gap.size(); ++i) {
      const double p = x.line_load[i];
      ASSERT_GE(p, 0.0);
      double w = q.yield->row(i).dot(x.line_load);
      if (p > 0.0)
        w += q.local * std::log(q.half_width / hertz_half_width(p, 8.0, q.reduced_modulus)) * p;
      const double s = w + q.gap[i] - x.approach * q.arm[i];
      const double scale = x.approach * q.arm[i];
      if (p > 0.0) {
        EXPECT_NEAR(s, 0.0, 1e-9 * scale) << seed;
      } else {
        EXPECT_GE(s, -1e-9 * scale) << seed;
      }
    }
  }
}

TEST(Complementarity, TheStartChangesNothing) {
  const ContactProblem q = random_problem(7, 20);
  const ContactSolution all = solve_contact(q);
  VectorXd one = VectorXd::Zero(20);
  one[11] = 1.0;
  const ContactSolution other = solve_contact(q, one);
  EXPECT_LT((all.line_load - other.line_load).cwiseAbs().maxCoeff(),
            1e-10 * all.line_load.maxCoeff());
}

TEST(Complementarity, TheTangentIsTheSlopeOfTheApproach) {
  ContactProblem q = random_problem(3, 12);
  const ContactSolution here = solve_contact(q);
  q.moment *= 1 + 1e-6;
  const ContactSolution there = solve_contact(q);
  EXPECT_NEAR((there.approach - here.approach) / (1e-6 * q.moment), here.yield_per_moment,
              1e-4 * here.yield_per_moment);
}

TEST(Complementarity, TheSlopeByAGapIsThatOfADifference) {
  ContactProblem q = random_problem(5, 16);
  q.local = 2e-7;
  q.half_width = 3.0;
  q.reduced_modulus = 1.1e5;
  const ContactSolution here = solve_contact(q);
  ASSERT_TRUE(here.found());
  EXPECT_NEAR(here.approach_per_gap.dot(q.arm), 1.0, 1e-12);
  for (Eigen::Index i = 0; i < q.gap.size(); ++i) {
    constexpr double kStep = 1e-8;  // mm, far below the gaps
    const auto moved = [&](double by) {
      ContactProblem other = q;
      other.gap[i] += by;
      return solve_contact(other, here.line_load).approach;
    };
    EXPECT_NEAR((moved(kStep) - moved(-kStep)) / (2 * kStep), here.approach_per_gap[i],
                1e-5 * here.approach_per_gap.maxCoeff())
        << i;
  }
}

// The derivatives of the loads agree with central differences, with and without the local term.
TEST(Complementarity, LoadSlopesAreThoseOfDifferences) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    for (const double local : {0.0, 4e-7}) {
      ContactProblem q = random_problem(seed, 9);
      q.local = local;
      q.reduced_modulus = 1e5;
      q.half_width = 20.0;
      q.moment = 2e6;  // loads most of the places
      const ContactSolution x = solve_contact(q);
      ASSERT_TRUE(x.found());
      ASSERT_GT((x.line_load.array() > 0.0).count(), 3);
      const MatrixXd gap_slopes = MatrixXd::Identity(9, 9);
      const MatrixXd slopes = load_slopes(q, x, gap_slopes);
      const double greatest = slopes.cwiseAbs().maxCoeff();
      for (Eigen::Index k = 0; k < 9; ++k) {
        constexpr double kStep = 1e-7;  // mm
        ContactProblem above = q, below = q;
        above.gap[k] += kStep;
        below.gap[k] -= kStep;
        const VectorXd difference =
            (solve_contact(above).line_load - solve_contact(below).line_load) / (2 * kStep);
        EXPECT_LT((slopes.col(k) - difference).cwiseAbs().maxCoeff(), 1e-5 * greatest) << seed;
      }
    }
  }
}

}  // namespace
}  // namespace gearwright
