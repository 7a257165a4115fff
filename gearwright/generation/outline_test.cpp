#include "gearwright/generation/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "gearwright/base/testing/violation.hpp"
#include "gearwright/curve/basic_curves.hpp"

namespace gearwright {
namespace {

Arc flank_arc() {
  const auto curve = std::make_shared<Involute>(20.0, 0.1);
  return {ArcName::flank, curve, 0.2, 0.6, curve->point(0.2), curve->point(0.6)};
}

Arc land() {  // Runs against the polar angle.
  const auto curve = std::make_shared<AxisCircle>(5.0);
  return {ArcName::root_land, curve, 0.4, 0.1, Vec2(1.0, 2.0), curve->point(0.1)};
}

TEST(Arc, ends_are_the_stored_points) {
  EXPECT_EQ(land().point(0.0), Vec2(1.0, 2.0));
  EXPECT_EQ(land().point(1.0), land().end_point);
  EXPECT_LE((flank_arc().point(0.5) - flank_arc().curve->point(0.4)).norm(), 1e-14);
}

TEST(Arc, tangent_runs_root_to_tip) {
  const CurvePoint up = flank_arc().at(0.5);
  const Vec2 ahead = flank_arc().point(0.5 + 1e-6) - flank_arc().point(0.5 - 1e-6);
  EXPECT_GT(ahead.dot(Vec2(std::cos(up.tangent_angle), std::sin(up.tangent_angle))), 0.0);
  // If an arc runs against the parameter of its curve, the tangent reverses and the curvature
  // changes its sign.
  const CurvePoint back = land().at(0.5);
  const Vec2 run = land().point(0.5 + 1e-6) - land().point(0.5 - 1e-6);
  EXPECT_GT(run.dot(Vec2(std::cos(back.tangent_angle), std::sin(back.tangent_angle))), 0.0);
  EXPECT_EQ(back.curvature, -0.2);
}

TEST(Outline, finds_the_first_of_a_name) {
  Outline outline;
  outline.arcs = {land(), flank_arc()};
  ASSERT_NE(outline.find(ArcName::flank), nullptr);
  EXPECT_EQ(outline.find(ArcName::flank), &outline.arcs[1]);
  EXPECT_EQ(outline.find(ArcName::tip_land), nullptr);
}

TEST(Sample, n_points_with_both_ends) {
  const std::vector<Vec2> points = sample(flank_arc(), 7);
  ASSERT_EQ(points.size(), 7u);
  EXPECT_EQ(points.front(), flank_arc().begin_point);
  EXPECT_EQ(points.back(), flank_arc().end_point);
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_GT(points[i].norm(), points[i - 1].norm());
  EXPECT_EQ(sample(land(), 2).front(), land().begin_point);
}

TEST(SampleDeathTest, two_points_at_least) { GW_EXPECT_VIOLATION(sample(flank_arc(), 1)); }

}  // namespace
}  // namespace gearwright
