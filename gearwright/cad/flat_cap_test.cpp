#include "gearwright/cad/flat_cap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gearwright/cad/bore_loop.hpp"

namespace gearwright {
namespace {

double area(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 ab = b - a, ac = c - a;
  return 0.5 * (ab.x() * ac.y() - ab.y() * ac.x());
}

double polygon_area(const std::vector<Vec2>& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += area(Vec2::Zero(), p[i], p[(i + 1) % p.size()]);
  return sum;
}

// All triangles are counter-clockwise, and their areas add up to the area of the region. No partial
// sum of areas exceeds `whole`, so N additions have a rounding error of at most N ε times `whole`.
void expect_covers(const std::vector<Triangle>& triangles, const std::vector<Vec2>& points,
                   double region, double whole) {
  double sum = 0.0;
  for (const Triangle& t : triangles) {
    const double one = area(points[t[0]], points[t[1]], points[t[2]]);
    EXPECT_GT(one, 0.0);
    sum += one;
  }
  EXPECT_NEAR(sum, region,
              static_cast<double>(points.size() + triangles.size()) *
                  std::numeric_limits<double>::epsilon() * whole);
}

std::vector<Vec2> regular(std::size_t m, double radius, double offset) {
  std::vector<Vec2> points;
  for (std::size_t j = 0; j < m; ++j) {
    const double angle =
        offset + 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(m);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

TEST(FlatCap, EarsCoverAPolygonWithPocketsAndPointsInLine) {
  // A comb is neither convex nor monotone in any direction. Its back contains collinear points.
  std::vector<Vec2> comb;
  for (int i = 0; i <= 20; ++i) comb.emplace_back(i, 0.0);
  for (int i = 20; i > 0; --i) {
    comb.emplace_back(i, 5.0);
    comb.emplace_back(i - 0.4, 5.0);
    comb.emplace_back(i - 0.3, 1.0);
    comb.emplace_back(i - 0.9, 1.0);
  }
  comb.emplace_back(0.0, 1.5);
  const auto triangles = clip_ears(comb);
  ASSERT_TRUE(triangles);
  EXPECT_EQ(triangles->size(), comb.size() - 2);
  expect_covers(*triangles, comb, polygon_area(comb), polygon_area(comb));
}

TEST(FlatCap, EarsOfASpiral) {
  std::vector<Vec2> spiral;
  for (int i = 0; i <= 200; ++i) {
    const double t = 0.08 * i;
    spiral.emplace_back((1.0 + t) * Vec2(std::cos(t), std::sin(t)));
  }
  for (int i = 200; i >= 0; --i) {
    const double t = 0.08 * i;
    spiral.emplace_back((0.4 + t) * Vec2(std::cos(t), std::sin(t)));
  }
  const auto triangles = clip_ears(spiral);
  ASSERT_TRUE(triangles);
  expect_covers(*triangles, spiral, polygon_area(spiral), 500.0);
}

TEST(FlatCap, NoEarsOnAPolygonThatCrossesItself) {
  EXPECT_FALSE(clip_ears({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
}

TEST(FlatCap, RingWithKeywayAtEveryOffset) {
  // The cases include thin and thick walls around the slot, and coarse and fine circles. In all of
  // them R cos δ ≥ r.
  for (const double width : {0.5, 6.0, 19.0}) {
    for (const double depth : {0.0, 0.01, 3.0, 30.0}) {
      const Bore bore{20.0, width, depth};
      std::vector<Vec2> inner;
      for (const Column& c : bore_columns(bore, 0.01, 0.26)) inner.push_back(c.point);
      for (const double wall : {1e-3, 0.1, 20.0}) {
        const double reach = bore_reach(bore);
        const double radius = reach + wall;
        const double step = std::min(std::acos(reach / radius), std::numbers::pi / 4);
        const std::size_t m = static_cast<std::size_t>(std::ceil(2 * std::numbers::pi / step));
        for (int turn = 0; turn < 40; ++turn) {
          const std::vector<Vec2> outer = regular(m, radius, 0.177 * turn);
          const std::vector<Triangle> triangles = zip_ring(inner, outer);
          EXPECT_EQ(triangles.size(), inner.size() + outer.size());
          std::vector<Vec2> points = inner;
          points.insert(points.end(), outer.begin(), outer.end());
          expect_covers(triangles, points, polygon_area(outer) - polygon_area(inner),
                        polygon_area(outer));
        }
      }
    }
  }
}

TEST(BoreLoop, IsMirroredBitForBitAndTurnsOnce) {
  for (const Bore& bore : {Bore{20.0}, Bore{20.0, 6.0, 2.8}}) {
    const std::vector<Column> loop = bore_columns(bore, 0.005, 0.26);
    const std::size_t n = loop.size();
    EXPECT_EQ(loop[0].point, Vec2(0.0, -10.0));
    for (std::size_t i = 1; i < n; ++i) {
      const Column &a = loop[i], &b = loop[n - i];
      EXPECT_EQ(a.point, Vec2(-b.point.x(), b.point.y()));
      EXPECT_EQ(a.after, Vec2(-b.before.x(), b.before.y()));
    }
    std::vector<Vec2> points;
    for (const Column& c : loop) points.push_back(c.point);
    EXPECT_GT(polygon_area(points), 0.99 * std::numbers::pi * 100.0);
  }
  EXPECT_EQ(bore_reach({20.0, 6.0, 2.8}), std::hypot(3.0, 12.8));
  EXPECT_EQ(bore_reach({20.0, 0.0, 2.8}), 10.0);
}

}  // namespace
}  // namespace gearwright
