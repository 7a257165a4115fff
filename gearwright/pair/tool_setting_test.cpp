#include "gearwright/pair/arc_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gearwright {
namespace {

constexpr double kDeg = std::numbers::pi / 180;

// Example 1 of Litvin and Tsay, in inches. As in the paper, the pitch radii follow from a lead
// angle of 65°, but the teeth from a lead angle of 75°.
ArcMeshInput example_1() {
  ArcMeshInput in{};
  in.convex = {0.7, 0.21121778264910707, 0.12194664367009782};
  in.concave = {0.775, 0.27616968793293994, 0.1594466436700978};
  in.pitch_radius_convex = 3.3101337568874754;
  in.pitch_radius_concave = 25.929381095618556;
  in.lead_angle = Angle::degrees(75);
  in.center_distance = in.pitch_radius_convex + in.pitch_radius_concave;
  return in;
}

TEST(ToolSetting, example_1_of_the_paper) {
  const ArcMeshInput in = example_1();
  // The paper prints 29.239515, 12.81412° and −0.021.
  EXPECT_NEAR(in.center_distance, 29.239515, 5e-7);
  ArcMeshInput displaced = in;
  displaced.center_distance += 0.021;
  const auto theta = contact_angle(displaced);
  ASSERT_TRUE(theta);
  EXPECT_NEAR(theta->rad() / kDeg, 12.814128904862558, 1e-10);
  const double exact = tool_setting_change(in, Angle::degrees(30), 0.021);
  EXPECT_NEAR(exact, -0.0209789493999995, 1e-14);
  displaced.convex.b += exact;
  EXPECT_NEAR(contact_angle(displaced)->rad() / kDeg, 30.0, 1e-10);
  // The difference from 30° is the error of the paper's first-order formula.
  displaced.convex.b = in.convex.b - 0.021;
  EXPECT_NEAR(contact_angle(displaced)->rad() / kDeg, 30.0185, 5e-5);
}

TEST(ToolSetting, nothing_to_do_without_a_change) {
  EXPECT_NEAR(tool_setting_change(example_1(), Angle::degrees(30), 0.0), 0.0, 1e-15);
}

TEST(ToolSetting, brings_the_contact_back_from_either_side) {
  for (const double delta : {-0.03, -0.004, 0.002, 0.05}) {
    for (const double theta : {18.0, 25.0, 30.0, 38.0}) {
      ArcMeshInput in = example_1();
      const double change = tool_setting_change(in, Angle::degrees(theta), delta);
      in.convex.b += change;
      in.center_distance += delta;
      const auto back = contact_angle(in);
      ASSERT_TRUE(back);
      EXPECT_NEAR(back->rad() / kDeg, theta, 1e-9) << delta;
    }
  }
}

TEST(ToolSetting, thickness_is_that_of_the_moved_arc) {
  const WorkingArc arc{0.7, 0.2, 0.12};
  const double theta = 30 * kDeg;
  const double delta = -0.02;
  // Half thickness of the tooth at a height x: ρ cos θ − a with x = ρ sin θ − b.
  const double x = arc.radius * std::sin(theta) - arc.b;
  const double moved = std::asin((x + arc.b + delta) / arc.radius);
  EXPECT_NEAR(thickness_change(arc, Angle::radians(theta), delta),
              2 * arc.radius * (std::cos(moved) - std::cos(theta)), 1e-15);
  EXPECT_GT(thickness_change(arc, Angle::radians(theta), delta), 0.0);  // a smaller b makes the
                                                                        // tooth thicker
}

// [T8.23]: tests the exact offset of gear 2 with changed settings, and its backlash to first order,
// which depends only on Δb_F − Δb_P + ΔC.
TEST(ToolSetting, what_changed_settings_do) {
  const ArcMeshInput in = example_1();
  const double r_2 = in.pitch_radius_concave, c_0 = in.center_distance;
  const double sin_lambda = std::sin(in.lead_angle.rad()), tan_0 = std::tan(30 * kDeg);
  // The teeth of the example do not match its pitch radii exactly, so the offset is not 0 before
  // any change.
  const Angle before = arc_contact(in, *contact_angle(in)).rotation_offset;
  for (const double b_f : {-2e-4, 0.0, 3e-4}) {
    for (const double b_p : {-1e-4, 2e-4}) {
      for (const double more : {-2e-4, 1e-4}) {
        ArcMeshInput changed = in;
        changed.convex.b += b_f;
        changed.concave.b += b_p;
        changed.center_distance += more;
        const ArcContact at = arc_contact(changed, *contact_angle(changed));
        const double theta = at.theta.rad();
        const double difference = in.convex.radius - in.concave.radius;
        const double w = difference * std::sin(theta) - changed.convex.b + changed.concave.b;
        const double ahead =
            c_0 * at.mu.rad() - w / std::tan(theta) * sin_lambda +
            (difference * std::cos(theta) - in.convex.a + in.concave.a) / sin_lambda;
        EXPECT_NEAR(r_2 * at.rotation_offset.rad(), ahead, 1e-13);
        const double play = -2 * (at.rotation_offset - before).rad();
        const double change = b_f - b_p + more;
        // The limit covers two second-order terms. The first results from
        // dθ = Δ/((ρ_F − ρ_P) cos θ_0). The second, 2 cot θ_0 sin² λ ΔC²/C_0, results from the
        // rotation μ, and its factor sin² λ is replaced by 1.
        const double cos_0 = std::cos(30 * kDeg);
        const double second = change * change / (std::abs(difference) * cos_0 * cos_0 * cos_0);
        const double turned = 2 * more * more / (tan_0 * c_0);
        EXPECT_NEAR(play * r_2 * sin_lambda, 2 * tan_0 * change, 1.2 * second + turned);
      }
    }
  }
}

}  // namespace
}  // namespace gearwright
