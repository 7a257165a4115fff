// Compares the spline through a topography with cubics and with splines written as truncated
// powers.
#include "gearwright/gear/topography.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <random>

namespace gearwright {
namespace {

using Long = long double;
using LongVector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;

Topography sampled(std::vector<double> d, std::vector<double> z,
                   const std::function<double(double, double)>& f) {
  Topography t{std::move(d), std::move(z), {}};
  for (const double x : t.diameters) {
    for (const double y : t.heights) t.removed.push_back(f(x, y));
  }
  return t;
}

std::vector<double> uneven(std::mt19937& random, std::size_t n, double from, double to) {
  std::uniform_real_distribution<double> step(0.3, 1.7);
  std::vector<double> x{0.0};
  while (x.size() < n) x.push_back(x.back() + step(random));
  const double scale = (to - from) / x.back();
  for (double& v : x) v = from + v * scale;
  return x;
}

// The not-a-knot spline on n ≥ 4 points is a cubic whose third derivative jumps at every inner
// point except the first and the last inner point. Its basis is 1, x, x², x³ and (x − x_j)³ for x >
// x_j. This function returns the basis and two derivatives at a point.
LongMatrix powers(const std::vector<double>& x, Long at) {
  const auto n = static_cast<Eigen::Index>(x.size());
  LongMatrix b(n, 3);
  const Long scale = x.back() - x.front();
  const Long v = (at - x.front()) / scale;
  for (Eigen::Index k = 0; k < 4; ++k) {
    const auto e = static_cast<Long>(k);
    b(k, 0) = std::pow(v, e);
    b(k, 1) = k < 1 ? 0 : e * std::pow(v, e - 1) / scale;
    b(k, 2) = k < 2 ? 0 : e * (e - 1) * std::pow(v, e - 2) / (scale * scale);
  }
  for (Eigen::Index k = 4; k < n; ++k) {
    const Long knot = (x[static_cast<std::size_t>(k - 2)] - x.front()) / scale;
    const Long r = std::max<Long>(v - knot, 0);
    b(k, 0) = r * r * r;
    b(k, 1) = 3 * r * r / scale;
    b(k, 2) = 6 * r / (scale * scale);
  }
  return b;
}

// Weights of the samples in s, s′ and s″ at a point.
LongMatrix weights(const std::vector<double>& x, Long at) {
  const auto n = static_cast<Eigen::Index>(x.size());
  LongMatrix collocation(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    collocation.row(i) = powers(x, x[static_cast<std::size_t>(i)]).col(0).transpose();
  return LongMatrix(collocation.transpose()).fullPivLu().solve(powers(x, at));
}

// The limit is 1e-11: rounding errors of 1e-16 in values of size 1, times 1/h² for second
// derivatives with h ≥ 0.06, times about 10 for the elimination.
TEST(Topography, is_the_not_a_knot_spline) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (const auto& [rows, columns] : {std::pair(4, 4), std::pair(5, 9), std::pair(12, 6)}) {
    const Topography t = sampled(uneven(random, static_cast<std::size_t>(rows), 40.0, 46.0),
                                 uneven(random, static_cast<std::size_t>(columns), -9.0, 11.0),
                                 [&](double, double) { return value(random); });
    const TopographySpline spline(t);
    std::uniform_real_distribution<double> in_d(40.0, 46.0), in_z(-9.0, 11.0);
    for (int k = 0; k < 60; ++k) {
      const double d = in_d(random);
      const double z = in_z(random);
      const LongMatrix a = weights(t.diameters, d);
      const LongMatrix b = weights(t.heights, z);
      LongMatrix samples(rows, columns);
      for (Eigen::Index i = 0; i < rows; ++i) {
        for (Eigen::Index j = 0; j < columns; ++j)
          samples(i, j) = t.removed[static_cast<std::size_t>(i * columns + j)];
      }
      const LongMatrix expected = a.transpose() * samples * b;
      const auto got = spline.at(d, z);
      EXPECT_NEAR(got.s, static_cast<double>(expected(0, 0)), 1e-11);
      EXPECT_NEAR(got.d, static_cast<double>(expected(1, 0)), 1e-11);
      EXPECT_NEAR(got.z, static_cast<double>(expected(0, 1)), 1e-11);
      EXPECT_NEAR(got.dd, static_cast<double>(expected(2, 0)), 1e-11);
      EXPECT_NEAR(got.dz, static_cast<double>(expected(1, 1)), 1e-11);
      EXPECT_NEAR(got.zz, static_cast<double>(expected(0, 2)), 1e-11);
    }
  }
}

// Crowning and twist are reproduced up to the edge, where the second derivative of a natural spline
// would be 0.
TEST(Topography, gives_back_cubics_beyond_the_edge_too) {
  std::mt19937 random(11);
  const auto f = [](double d, double z) {
    const double x = d - 43;
    return (1 + x - 2 * x * x + x * x * x / 3) * (2 - z + z * z / 4 - z * z * z / 8);
  };
  const TopographySpline spline(
      sampled(uneven(random, 6, 40.0, 46.0), uneven(random, 7, -2.0, 2.0), f));
  std::uniform_real_distribution<double> in_d(39.5, 46.5), in_z(-2.3, 2.3);
  for (int k = 0; k < 100; ++k) {
    const double d = in_d(random);
    const double z = in_z(random);
    const double x = d - 43;
    const double p[] = {1 + x - 2 * x * x + x * x * x / 3, 1 - 4 * x + x * x, -4 + 2 * x};
    const double q[] = {2 - z + z * z / 4 - z * z * z / 8, -1 + z / 2 - 3 * z * z / 8,
                        0.5 - 3 * z / 4};
    const auto got = spline.at(d, z);
    EXPECT_NEAR(got.s, p[0] * q[0], 1e-10);
    EXPECT_NEAR(got.d, p[1] * q[0], 1e-10);
    EXPECT_NEAR(got.z, p[0] * q[1], 1e-10);
    EXPECT_NEAR(got.dd, p[2] * q[0], 1e-10);
    EXPECT_NEAR(got.dz, p[1] * q[1], 1e-10);
    EXPECT_NEAR(got.zz, p[0] * q[2], 1e-10);
  }
}

TEST(Topography, two_points_are_a_line_and_three_a_parabola) {
  const auto f = [](double d, double z) { return (3 - 2 * d) * (1 + z - z * z); };
  const TopographySpline spline(sampled({40, 47}, {-3, 1, 4}, f));
  const auto got = spline.at(42.5, -1.25);
  EXPECT_NEAR(got.s, f(42.5, -1.25), 1e-11);
  EXPECT_NEAR(got.d, -2 * (1 - 1.25 - 1.5625), 1e-11);
  EXPECT_NEAR(got.z, (3 - 85) * 3.5, 1e-11);
  EXPECT_NEAR(got.dd, 0.0, 1e-11);
  EXPECT_NEAR(got.zz, 2 * 82.0, 1e-11);
}

// Curvature is continuous from cell to cell, and the surface passes through the points of the grid
// within two units in the last place.
TEST(Topography, is_smooth_to_the_second_derivative) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  const Topography t = sampled(uneven(random, 8, 40.0, 46.0), uneven(random, 8, -9.0, 11.0),
                               [&](double, double) { return value(random); });
  const TopographySpline spline(t);
  for (std::size_t i = 1; i + 1 < 8; ++i) {
    for (std::size_t j = 1; j + 1 < 8; ++j) {
      const double d = t.diameters[i];
      const double z = t.heights[j];
      EXPECT_NEAR(spline.at(d, z).s, t.removed[i * 8 + j], 3e-16);
      const double below_d = std::nextafter(d, 0.0);
      const double below_z = std::nextafter(z, -100.0);
      EXPECT_NEAR(spline.at(below_d, z).dd, spline.at(d, z).dd, 1e-11);
      EXPECT_NEAR(spline.at(d, below_z).zz, spline.at(d, z).zz, 1e-11);
      EXPECT_NEAR(spline.at(below_d, below_z).dz, spline.at(d, z).dz, 1e-11);
    }
  }
}

TEST(Topography, knows_a_grid) {
  EXPECT_TRUE(is_grid({{1, 2}, {0, 1}, {0, 0, 0, 0}}));
  EXPECT_FALSE(is_grid({{1, 2}, {0, 1}, {0, 0, 0}}));
  EXPECT_FALSE(is_grid({{1, 1}, {0, 1}, {0, 0, 0, 0}}));
  EXPECT_FALSE(is_grid({{1, 2}, {1, 0}, {0, 0, 0, 0}}));
  EXPECT_FALSE(is_grid({{1, NAN}, {0, 1}, {0, 0, 0, 0}}));
  EXPECT_FALSE(is_grid({{1}, {0, 1}, {0, 0}}));
}

}  // namespace
}  // namespace gearwright
