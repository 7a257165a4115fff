// Compares root radius, neck, form radius and pointed radius of the swept tooth with the few-tooth
// cases.
#include "tests/oracle/swept_tooth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/oracle/few_tooth_cases.hpp"
#include "tests/oracle/numbers.hpp"

namespace gearwright::oracle {
namespace {

TEST(SweptTooth, few_tooth_cases) {
  for (const FewToothCase& c : few_tooth_cases()) {
    SCOPED_TRACE(c.name);
    const SweptRack rack(c.rack);
    EXPECT_FALSE(severed(rack));
    EXPECT_NEAR(root_radius(rack), c.root_radius, 1e-12);
    EXPECT_NEAR(material_half_angle(rack, c.neck_radius), c.neck_half_angle, 1e-10);

    // If the tooth is undercut, the tolerance is 1e-11 mm divided by the sine of the crossing
    // angle, which is at least 0.1 here. Otherwise the quadratic departure of the fillet is
    // extrapolated, except for R19, which begins 8 µm from its base circle.
    const auto form = form_radius(rack);
    ASSERT_TRUE(form.has_value());
    const double m = c.rack.normal_module;
    const bool extrapolated = c.form_radius - rack.base_radius() > 1e-3 * m;
    EXPECT_NEAR(*form, c.form_radius, c.undercut ? 1e-10 : extrapolated ? 1e-7 * m : 1e-6);

    // The tip is either a point, or a land cut by the bottom of the cutter. There is no material
    // just outside the tip.
    if (c.tip_half_angle == 0.0) {
      const auto pointed = pointed_radius(rack);
      ASSERT_TRUE(pointed.has_value());
      EXPECT_NEAR(*pointed, c.tip_radius, 1e-11);
    } else {
      // At δ below the land, the arc is longer by δ times the slope of the flank (less than 10). If
      // a tip fillet leaves the land along its tangent, it is longer by sqrt(2 δ R), R < 2 mm.
      constexpr double kBelow = 1e-9;
      const double longer =
          c.rack.tip_fillet_radius > 0 ? std::sqrt(2 * kBelow * 2.0) : 10 * kBelow;
      const double half_angle = material_half_angle(rack, c.tip_radius - kBelow);
      EXPECT_GE(half_angle, c.tip_half_angle);
      EXPECT_LE(half_angle, c.tip_half_angle + longer / c.tip_radius);
      EXPECT_EQ(material_half_angle(rack, c.tip_radius + 1e-9), 0.0);
    }
    EXPECT_NEAR(material_half_angle(rack, c.root_radius - 1e-9), std::numbers::pi / c.rack.teeth,
                0.0);
  }
}

// The neck in the table is the least value on a grid. The true value is at most 7e-7 rad smaller.
// R14 was solved to 30 digits from dθ/dτ = 0 on the rolled rounding.
TEST(SweptTooth, neck_is_the_true_minimum) {
  for (const FewToothCase& c : few_tooth_cases()) {
    const auto found = neck(SweptRack(c.rack));
    ASSERT_TRUE(found.has_value()) << c.name;
    EXPECT_LE(found->half_angle, c.neck_half_angle + 1e-9) << c.name;
    EXPECT_GE(found->half_angle, c.neck_half_angle - 7e-7) << c.name;
  }
  const FewToothCase& r14 = few_tooth_cases()[4];
  ASSERT_STREQ(r14.name, "R14");
  const auto found = neck(SweptRack(r14.rack));
  EXPECT_NEAR(found->half_angle, 0.346960657308791339910, 1e-11);
  EXPECT_NEAR(found->radius, 4.15308513561007780310, 1e-5);
}

// R09 and R10 of the same source: the rack passes the axis, so there is no tooth.
TEST(SweptTooth, severed_teeth) {
  const double a = 20 * kDegree;
  const RackNumbers r10{.teeth = 2,
                        .normal_module = 2,
                        .normal_pressure_angle = a,
                        .dedendum = 1 + 0.38 * (1 - std::sin(a)),
                        .root_fillet_radius = 0.38,
                        .tool_addendum = 1.0};
  RackNumbers r09 = r10;
  r09.teeth = 1;
  r09.helix_angle = 30 * kDegree;
  r09.profile_shift = 0.2;
  for (const RackNumbers& n : {r09, r10}) {
    const SweptRack rack(n);
    EXPECT_TRUE(severed(rack));
    EXPECT_EQ(root_radius(rack), 0.0);
    EXPECT_FALSE(neck(rack).has_value());
    EXPECT_FALSE(pointed_radius(rack).has_value());
  }
  EXPECT_NEAR(SweptRack(r10).deepest_radius(), -0.50006469107249176, 1e-14);
  EXPECT_NEAR(SweptRack(r09).deepest_radius(), -0.94536415269324023, 1e-14);
}

TEST(SweptTooth, blank_ends_the_tooth) {
  RackNumbers n{.teeth = 17,
                .normal_module = 1,
                .normal_pressure_angle = 20 * kDegree,
                .root_fillet_radius = 0.38,
                .tip_radius = 9.5};
  const SweptRack rack(n);
  EXPECT_FALSE(pointed_radius(rack).has_value());
  EXPECT_GT(material_half_angle(rack, 9.5), 0.0);
  EXPECT_EQ(material_half_angle(rack, 9.5 + 1e-9), 0.0);
  n.tip_radius = 30.0;
  EXPECT_TRUE(pointed_radius(SweptRack(n)).has_value());
}

// On the flank, the half angle is that of the involute. On the reference circle, half of the arc is
// π m/4 + x m tan α.
TEST(SweptTooth, half_angle_on_the_flank_is_the_involute) {
  const RackNumbers n{.teeth = 23,
                      .normal_module = 3,
                      .normal_pressure_angle = 20 * kDegree,
                      .helix_angle = -25 * kDegree,
                      .profile_shift = 0.4,
                      .root_fillet_radius = 0.3};
  const SweptRack rack(n);
  const double r = rack.reference_radius();
  EXPECT_NEAR(involute_half_angle(rack, r) * r,
              (std::numbers::pi / 4 + 0.4 * std::tan(20 * kDegree)) * 3 / std::cos(25 * kDegree),
              1e-13);
  for (const double rho : {r - 1.0, r, r + 1.0, r + 3.0}) {
    EXPECT_NEAR(material_half_angle(rack, rho), involute_half_angle(rack, rho), 1e-13) << rho;
  }
}

}  // namespace
}  // namespace gearwright::oracle
