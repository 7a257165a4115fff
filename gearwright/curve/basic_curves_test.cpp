#include "gearwright/curve/basic_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "gearwright/base/overloaded.hpp"
#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

using testing::kEps;

TEST(AxisCircle, is_a_circle) {
  const AxisCircle circle(7.5);
  for (const double theta : {-1.0, 0.0, 0.3, 2.0}) {
    EXPECT_NEAR(circle.point(theta).norm(), 7.5, 2 * kEps * 7.5);
    EXPECT_EQ(circle.polar_angle(theta), theta);
    EXPECT_EQ(circle.at(theta).curvature, 1.0 / 7.5);
  }
}

TEST(Involute, laws_of_the_header) {
  const Involute curve(20.0, 0.12);
  for (const double xi : {0.0, 1e-6, 0.1, 0.27, 0.5, 1.3}) {
    const Vec2 p = curve.point(xi);
    EXPECT_NEAR(p.norm(), 20.0 * std::hypot(1.0, xi), 4 * kEps * 30);              // (1)
    EXPECT_NEAR(std::atan2(p.y(), p.x()), 0.12 - (xi - std::atan(xi)), 8 * kEps);  // (2)
    EXPECT_NEAR(curve.polar_angle(xi), std::atan2(p.y(), p.x()), 8 * kEps);
    if (xi == 0.0) continue;
    EXPECT_EQ(curve.at(xi).curvature, -1.0 / (20.0 * xi));  // (3)
  }
}

TEST(Involute, normals_touch_the_base_circle) {
  const Involute curve(20.0, 0.12);
  for (const double xi : {0.05, 0.4, 1.0}) {
    const CurvePoint p = curve.at(xi);
    const Vec2 normal(-std::sin(p.tangent_angle), std::cos(p.tangent_angle));
    const double distance = std::abs(p.point.x() * normal.y() - p.point.y() * normal.x());
    EXPECT_NEAR(distance, 20.0, 8 * kEps * 20);
  }
}

TEST(Involute, parameter_at_radius_is_closed) {
  const Involute curve(20.0, 0.12);
  EXPECT_TRUE(curve.radius_is_closed_form());
  EXPECT_EQ(curve.roll_at(20.0), 0.0);
  EXPECT_EQ(curve.roll_at(19.0), 0.0);
  EXPECT_EQ(curve.parameter_at_radius(10.0, 0.2, 0.9), 0.2);
  EXPECT_EQ(curve.parameter_at_radius(100.0, 0.9, 0.2), 0.9);
  for (const double xi : {0.25, 0.5, 0.8}) {
    const double rho = curve.point(xi).norm();
    EXPECT_NEAR(curve.parameter_at_radius(rho, 0.2, 0.9), xi, 4 * kEps / xi);
  }
}

// A curve that provides only its points. The base class finds the parameter at a radius in a
// bracket.
class Spiral final : public Curve {
 public:
  Vec2 point(double t) const override { return {(1 + t) * std::cos(t), (1 + t) * std::sin(t)}; }
  CurvePoint at(double t) const override { return {point(t), 0.0, 0.0}; }
};

TEST(Curve, solves_for_a_radius_either_way_round) {
  const Spiral spiral;
  EXPECT_FALSE(spiral.radius_is_closed_form());
  EXPECT_NEAR(spiral.parameter_at_radius(1.5, 0.0, 1.0), 0.5, 8 * kEps);
  EXPECT_EQ(spiral.parameter_at_radius(0.5, 0.0, 1.0), 0.0);
  EXPECT_EQ(spiral.parameter_at_radius(5.0, 0.0, 1.0), 1.0);
  EXPECT_NEAR(spiral.polar_angle(0.5), 0.5, 4 * kEps);
}

TEST(Curve, says_of_which_kind_it_is) {
  const Involute involute(10.0, 0.1);
  const AxisCircle circle(10.0);
  const Spiral spiral;
  const Curve& curve = involute;
  EXPECT_EQ(curve_if<Involute>(curve), &involute);
  EXPECT_EQ(&curve_as<Involute>(curve), &involute);
  EXPECT_EQ(curve_if<OffsetCircle>(curve), nullptr);
  EXPECT_EQ(curve_if<Involute>(circle), nullptr);
  EXPECT_EQ(curve_if<AxisCircle>(circle), &circle);
  EXPECT_EQ(curve_if<Curve>(spiral), &spiral);
  const auto name =
      Overloaded{[](const Involute*) { return "involute"; },
                 [](const AxisCircle*) { return "circle"; }, [](const Curve*) { return "other"; }};
  const auto visited = [&](const Curve& c) {
    return std::string(visit_curve<AxisCircle, Involute>(c, name));
  };
  EXPECT_EQ(visited(involute), "involute");
  EXPECT_EQ(visited(circle), "circle");
  EXPECT_EQ(visited(spiral), "other");
  GW_EXPECT_VIOLATION(static_cast<void>(curve_as<Involute>(circle)));
}

}  // namespace
}  // namespace gearwright
