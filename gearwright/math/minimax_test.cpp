// The linear program is compared with the best vertex of all, and the descent with published
// minima.
//
// Sources   C. Charalambous, A. R. Conn, SIAM J. Numer. Anal. 15 (1978), problems CB2 and CB3;
//           K. Madsen, J. Inst. Maths Applics 16 (1975), problem 1
#include "gearwright/math/minimax.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace gearwright {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Planes {
  std::vector<Tangent> at_zero;  // value at x = 0, and slope
  Tangent operator()(const VectorXd& x) const {
    Tangent best{-kInfinity, {}};
    for (const Tangent& p : at_zero)
      if (const double v = p.value + p.slope.dot(x); v > best.value) best = {v, p.slope};
    return best;
  }
};

Planes random_planes(std::mt19937& random, int count, Index variables) {
  std::normal_distribution<double> normal;
  Planes planes;
  for (int k = 0; k < count; ++k)
    planes.at_zero.push_back(
        {normal(random), VectorXd::NullaryExpr(variables, [&] { return normal(random); })});
  return planes;
}

// A function is convex, so its least value in a box is the least value on the smaller boxes around
// the result. Any direction in which it decreases would appear there.
TEST(Minimax, NoDirectionLeadsBelowTheLowestOfTangents) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    const Index n = 1 + trial % 5;
    const Planes planes = random_planes(random, 1 + trial % 40, n);
    const VectorXd hi = VectorXd::Constant(n, 0.1 + trial % 3);
    const VectorXd x = lowest_of_tangents(planes, -hi, hi);
    ASSERT_TRUE((x.array().abs() <= hi.array()).all());
    const double least = planes(x).value;
    for (int k = 0; k < 200; ++k) {
      const VectorXd step =
          std::pow(10.0, -k % 6) * VectorXd::NullaryExpr(n, [&] { return normal(random); });
      EXPECT_GE(planes((x + step).cwiseMax(-hi).cwiseMin(hi)).value, least - 1e-9) << trial;
    }
  }
}

TEST(Minimax, ADegenerateBoxOrRepeatedPlanesAreNoObstacle) {
  const VectorXd point = VectorXd::Constant(2, 0.5);
  const Planes same{{{1.0, VectorXd::Unit(2, 0)}, {1.0, VectorXd::Unit(2, 0)}}};
  EXPECT_EQ(lowest_of_tangents(same, point, point), point);
  EXPECT_EQ(lowest_of_tangents(same, -point, point)[0], -0.5);
  const Planes flat{{{3.0, VectorXd::Zero(2)}}};
  EXPECT_EQ(flat(lowest_of_tangents(flat, -point, point)).value, 3.0);
}

struct Functions {
  std::vector<std::function<Tangent(double, double)>> all;
  int* evaluations;

  Tangents operator()(const std::vector<double>& at) const {
    ++*evaluations;
    Planes planes;
    for (const auto& f : all) planes.at_zero.push_back(f(at[0], at[1]));
    return {planes(VectorXd::Zero(2)).value, planes};
  }
};

Tangent tangent(double value, double x, double y) { return {value, Eigen::Vector2d(x, y)}; }

TEST(Minimax, FindsPublishedMinima) {
  const auto f2 = [](double x, double y) {
    return tangent((2 - x) * (2 - x) + (2 - y) * (2 - y), 2 * (x - 2), 2 * (y - 2));
  };
  const auto f3 = [](double x, double y) {
    const double v = 2 * std::exp(y - x);
    return tangent(v, -v, v);
  };
  struct Case {
    std::vector<std::function<Tangent(double, double)>> functions;
    std::vector<double> start;
    double least;
  };
  const auto signs = [](auto f) {
    return [f](double x, double y) {
      Tangent t = f(x, y);
      return Tangent{-t.value, -t.slope};
    };
  };
  const auto m1 = [](double x, double y) {
    return tangent(x * x + y * y + x * y, 2 * x + y, 2 * y + x);
  };
  const auto m2 = [](double x, double) { return tangent(std::sin(x), std::cos(x), 0.0); };
  const auto m3 = [](double, double y) { return tangent(std::cos(y), 0.0, -std::sin(y)); };
  const std::vector<Case> cases{
      {{[](double x, double y) {
          return tangent(x * x + std::pow(y, 4), 2 * x, 4 * std::pow(y, 3));
        },
        f2, f3},
       {1.0, -0.1},
       1.95222449},
      {{[](double x, double y) {
          return tangent(std::pow(x, 4) + y * y, 4 * std::pow(x, 3), 2 * y);
        },
        f2, f3},
       {1.0, -0.1},
       2.0},
      {{m1, m2, m3, signs(m1), signs(m2), signs(m3)}, {3.0, 1.0}, 0.61643244}};
  for (const Case& c : cases) {
    int evaluations = 0;
    const Functions f{c.functions, &evaluations};
    const MinimaxTask task{
        .lo = {-5.0, -5.0}, .hi = {5.0, 5.0}, .last_radius = 1e-9, .relative_gain = 1e-12, .f = f};
    const std::vector<double> found = minimax_descent(task, c.start);
    EXPECT_LE(evaluations, 45);
    EXPECT_NEAR(f(found).value, c.least, 1e-7) << c.least;
  }
}

// Law: f at the result is not greater than f at the start. A start without a value stays.
TEST(Minimax, TheDescentNeverClimbs) {
  int evaluations = 0;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto wave = [](double x, double y) {
    return tangent(std::sin(9 * x) + y * y, 9 * std::cos(9 * x), 2 * y);
  };
  const Functions f{{wave}, &evaluations};
  for (int most : {1, 2, 5, 60}) {
    const MinimaxTask task{.lo = {-1.0, -1.0}, .hi = {1.0, 1.0}, .most = most, .f = f};
    const std::vector<double> start{unit(random), unit(random)};
    EXPECT_LE(f(minimax_descent(task, start)).value, f(start).value);
  }
  const MinimaxTask none{
      .lo = {0.0}, .hi = {1.0}, .f = [](const std::vector<double>&) { return Tangents{}; }};
  EXPECT_EQ(minimax_descent(none, {0.5}), std::vector{0.5});
}

}  // namespace
}  // namespace gearwright
