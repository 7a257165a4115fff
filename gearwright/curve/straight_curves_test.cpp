#include "gearwright/curve/basic_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gearwright {
namespace {

// Central differences with a step of 1e-4 leave an error of the order 1e-8.
constexpr double kStep = 1e-4, kDifference = 1e-7;

void expect_derivatives(const Curve& curve, double t) {
  const Vec2 before = curve.point(t - kStep), here = curve.point(t), after = curve.point(t + kStep);
  const Vec2 first = (after - before) / (2 * kStep);
  const Vec2 second = (after - 2 * here + before) / (kStep * kStep);
  const CurvePoint at = curve.at(t);
  EXPECT_EQ(at.point, here);
  EXPECT_NEAR(std::remainder(at.tangent_angle - std::atan2(first.y(), first.x()), 2 * M_PI), 0.0,
              kDifference);
  const double cross = first.x() * second.y() - first.y() * second.x();
  EXPECT_NEAR(at.curvature, cross / std::pow(first.norm(), 3), 1e-5);
}

TEST(StraightCurves, tangent_and_curvature_are_the_derivatives) {
  const StraightLine line({1, 2}, {-3, 5});
  const StretchedCircle circle({4, -1}, 2.0, 1.0), ellipse({4, -1}, 2.0, 1.3);
  for (double t = -3.0; t < 7.0; t += 0.37) {
    for (const Curve* curve : {static_cast<const Curve*>(&line), static_cast<const Curve*>(&circle),
                               static_cast<const Curve*>(&ellipse)})
      expect_derivatives(*curve, t);
    EXPECT_NEAR(circle.at(t).curvature, 0.5, 1e-15);
    const Vec2 p = ellipse.point(t) - Vec2(4, -1);
    EXPECT_NEAR(std::hypot(p.x(), p.y() / 1.3), 2.0, 1e-15);
    EXPECT_LT(std::abs(ellipse.at(t).tangent_angle - t - M_PI / 2), M_PI / 2);
  }
}

}  // namespace
}  // namespace gearwright
