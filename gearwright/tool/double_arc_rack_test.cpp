#include "gearwright/tool/double_arc_rack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gearwright {
namespace {

// GB/T 12759-1991, basic rack parameters: those numbers of its table that can be derived from the
// others.
struct Row {
  double module, concave_offset, root_radius, step_radius, concave_end_deg;
  double convex_begin_deg;  // 0: not known
};
constexpr Row kRows[] = {{2.0, 0.7086, 0.4030, 0.5049, 9 + 25.0 / 60 + 31.0 / 3600, 6.347777778},
                         {5.0, 0.6994, 0.4004, 0.5043, 9 + 19.0 / 60 + 30.0 / 3600, 0.0},
                         {12.0, 0.6820, 0.3663, 0.4877, 9 + 0.0 / 60 + 59.0 / 3600, 0.0},
                         {40.0, 0.6455, 0.3520, 0.4858, 8 + 35.0 / 60 + 1.0 / 3600, 0.0}};

// The lengths are printed with four decimals, and the angles are printed to the second. Both were
// computed from rounded inputs.
constexpr double kPrinted = 1.5e-4;
constexpr double kPrintedAngle = 2e-3;  // degrees
// A rounding error of 5e-5 in l_f changes the root radius by l_f/(ρ_f − x_f − h_f) times this
// error, that is 2.6 to 2.8 times. The rounding of ρ_f and x_f changes the root radius by the same
// amount.
constexpr double kPrintedRoot = 3e-4;

TEST(DoubleArcRack, the_standards_table_closes) {
  for (const Row& row : kRows) {
    const auto rack = gbt12759_rack(row.module);
    ASSERT_TRUE(rack);
    const auto d = derived(*rack);
    ASSERT_TRUE(d) << d.error().message();
    EXPECT_NEAR(d->convex_contact_height, 0.545, kPrinted);
    EXPECT_NEAR(d->concave_contact_depth, 0.545, kPrinted);
    EXPECT_NEAR(d->contact_thickness, 1.1173, kPrinted);
    EXPECT_NEAR(d->concave_offset, row.concave_offset, kPrinted) << row.module;
    EXPECT_NEAR(d->root_radius, row.root_radius, kPrintedRoot) << row.module;
    EXPECT_NEAR(d->step_radius, row.step_radius, kPrinted) << row.module;
    EXPECT_NEAR(d->concave_end.deg(), row.concave_end_deg, kPrintedAngle) << row.module;
    if (row.convex_begin_deg > 0.0) {
      EXPECT_NEAR(d->convex_begin.deg(), row.convex_begin_deg, kPrintedAngle);
    }
  }
}

// The step is tangent to the convex arc and meets the concave arc at the end of the concave arc.
// The full radius is tangent to the concave arc, and its centre lies in the middle of the cutter's
// tip.
TEST(DoubleArcRack, arcs_follow_each_other) {
  for (const Row& row : kRows) {
    const DoubleArcRack rack = *gbt12759_rack(row.module);
    const auto arcs = arcs_of(rack);
    ASSERT_TRUE(arcs) << arcs.error().message();
    ASSERT_EQ(arcs->arcs.size(), 4u);
    for (std::size_t i = 0; i + 1 < 4; ++i) {
      const RackArc &a = arcs->arcs[i], &b = arcs->arcs[i + 1];
      EXPECT_NEAR((point_at(a, a.end) - point_at(b, b.begin)).norm(), 0.0, 1e-15);
      const bool corner = i == 1;
      EXPECT_EQ(a.end == b.begin, !corner);
    }
    EXPECT_EQ(arcs->arcs[0].center_offset, std::numbers::pi / 2);
    EXPECT_NEAR(point_at(arcs->arcs[1], arcs->arcs[1].end).x(), -rack.step_depth, 1e-15);
    EXPECT_NEAR(point_at(arcs->arcs[3], arcs->arcs[3].begin).x(), rack.step_height, 1e-15);
    EXPECT_NEAR(point_at(arcs->arcs[3], arcs->arcs[3].end).y(), 0.0, 1e-15);
    // The contact point lies where the table gives it, with the same pressure angle on both arcs.
    const auto d = derived(rack);
    const Vec2 convex = point_at(arcs->arcs[3], rack.pressure_angle);
    const Vec2 concave = point_at(arcs->arcs[1], rack.pressure_angle);
    EXPECT_NEAR(convex.x(), d->convex_contact_height, 1e-15);
    EXPECT_NEAR(2 * convex.y(), d->contact_thickness, 1e-15);
    EXPECT_NEAR(-concave.x(), d->concave_contact_depth, 1e-15);
    EXPECT_NEAR(std::numbers::pi - 2 * concave.y(), rack.space_width, 1e-15);
  }
}

TEST(DoubleArcRack, unknown_modules_are_refused_with_what_helps) {
  for (const double m : {1.49, 6.5, 10.0, 16.5, 32.0, 51.0, double{NAN}}) {
    const auto rack = gbt12759_rack(m);
    ASSERT_FALSE(rack) << m;
    EXPECT_EQ(rack.error().field, "rack");
    EXPECT_NE(rack.error().message().find("double_circular_arc"), std::string::npos);
  }
  for (const double m : {1.5, 3.0, 3.01, 6.0, 10.01, 16.0, 32.01, 50.0})
    EXPECT_TRUE(gbt12759_rack(m));
}

TEST(DoubleArcRack, what_is_impossible_is_named) {
  const auto key = [](auto change) {
    DoubleArcRack rack;
    change(rack);
    const auto arcs = arcs_of(rack);
    if (arcs) return std::string("made");
    EXPECT_NE(arcs.error().message().find(arcs.error().field), std::string::npos);
    return arcs.error().field;
  };
  EXPECT_EQ(key([](DoubleArcRack&) {}), "made");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.pressure_angle = Angle::degrees(90); }),
            "rack.pressure_angle");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.convex_radius = -1.0; }), "rack.convex_radius");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.concave_height = NAN; }), "rack.concave_height");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.step_height = 0.01; }), "rack.step_height");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.step_depth = 1.45; }), "rack.step_depth");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.step_depth = 1.05; }), "rack.step_depth");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.space_width = 1.8; }), "rack.space_width");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.space_width = 0.6; }), "rack.space_width");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.dedendum = 1.25; }), "rack.dedendum");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.addendum = 1.2; }), "rack.addendum");
  EXPECT_EQ(key([](DoubleArcRack& r) { r.convex_offset = 1.3; }), "rack.convex_offset");
}

}  // namespace
}  // namespace gearwright
