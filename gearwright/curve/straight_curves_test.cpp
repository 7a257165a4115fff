#include "gearwright/curve/basic_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gearwright {
namespace {

TEST(StraightCurves, laws_of_the_header) {
  const StretchedCircle circle({4, -1}, 2.0, 1.0), ellipse({4, -1}, 2.0, 1.3);
  for (double t = -3.0; t < 7.0; t += 0.37) {
    EXPECT_NEAR(circle.at(t).curvature, 0.5, 1e-15);
    const Vec2 p = ellipse.point(t) - Vec2(4, -1);
    EXPECT_NEAR(std::hypot(p.x(), p.y() / 1.3), 2.0, 1e-15);
    EXPECT_LT(std::abs(ellipse.at(t).tangent_angle - t - M_PI / 2), M_PI / 2);
  }
}

}  // namespace
}  // namespace gearwright
