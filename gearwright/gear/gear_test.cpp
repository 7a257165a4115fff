#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <type_traits>

#include "gearwright/base/numbers.hpp"
#include "gearwright/gear/testing/made.hpp"

namespace gearwright {
namespace {

using testing::made;

using namespace literals;

// The type is not an aggregate. C++20 would accept values for some members of an aggregate and set
// the others to 0.
static_assert(!std::is_constructible_v<Gear, CylindricalSpec>);
static_assert(!std::is_aggregate_v<Gear>);

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

CylindricalSpec spec(int teeth) {
  CylindricalSpec s = testing::plain_spec({.teeth = teeth, .module = 2.0, .face_width = 20.0});
  s.rack = *iso53_rack("ISO53-A");
  return s;
}

TEST(MakeGear, defaults_from_the_rack) {
  CylindricalSpec s = spec(30);
  s.profile_shift = 0.25;
  const Gear gear = made(s);
  EXPECT_EQ(gear.tip_diameter, 60 + 4 * 1.25);
  EXPECT_EQ(gear.root_diameter, 60 + 4 * (0.25 - 1.25));
  EXPECT_EQ(gear.lead, 0.0);
  EXPECT_EQ(gear.twist(), 0.0);
  EXPECT_EQ(gear.actual_tip_radius(), 32.5);
  EXPECT_EQ(gear.tip_form_radius(), 32.5);
  EXPECT_TRUE(gear.exists());
  EXPECT_FALSE(gear.internal());
  EXPECT_FALSE(gear.undercut);
  EXPECT_TRUE(gear.warnings.empty());
}

TEST(MakeGear, lead_has_the_sign_of_the_hand) {
  CylindricalSpec s = spec(30);
  s.helix_angle = 15_deg;
  const Gear right = made(s);
  s.helix_angle = -15_deg;
  const Gear left = made(s);
  EXPECT_GT(right.lead, 0.0);
  EXPECT_EQ(left.lead, -right.lead);
  EXPECT_EQ(left.twist(), -right.twist());
  EXPECT_NEAR(right.lead, std::numbers::pi * 30 * 2.0 / std::sin(std::numbers::pi / 12),
              1e-12 * right.lead);
}

// A thickness allowance thins the tooth. Flanks and root follow from x_E, and the tip follows from
// x.
TEST(MakeGear, allowance_moves_the_root_and_not_the_tip) {
  CylindricalSpec s = spec(30);
  s.thickness_allowance = -0.1;
  const Gear gear = made(s);
  EXPECT_EQ(gear.tip_diameter, 64.0);
  EXPECT_LT(gear.root_diameter, 55.0);
  EXPECT_NEAR(gear.root_diameter, 55.0 - 0.1 / std::tan(std::numbers::pi / 9), 1e-12);
  EXPECT_NEAR(gear.reference().reference_tooth_thickness_normal, std::numbers::pi - 0.1, 1e-15 * 4);
}

TEST(MakeGear, undercut_begins_where_the_shift_says) {
  CylindricalSpec s = spec(12);
  const double limit = *made(s).involute()->undercut_free_profile_shift;
  const double sin_a = std::sin(std::numbers::pi / 9);
  EXPECT_NEAR(limit, 1.25 - 0.38 * (1 - sin_a) - 6 * sin_a * sin_a, 1e-15 * 4);
  s.profile_shift = limit + 1e-9;
  EXPECT_FALSE(made(s).undercut);
  s.profile_shift = limit - 1e-9;
  EXPECT_TRUE(made(s).undercut);
  EXPECT_TRUE(warns(made(s), WarningCode::undercut));
}

TEST(MakeGear, warnings_say_what_happened) {
  CylindricalSpec pointed = spec(10);
  pointed.profile_shift = 0.9;
  EXPECT_TRUE(warns(made(pointed), WarningCode::pointed));
  EXPECT_EQ(made(pointed).tip_tooth_thickness_normal, 0.0);
  CylindricalSpec thin = spec(10);
  thin.profile_shift = 0.65;
  EXPECT_TRUE(warns(made(thin), WarningCode::thin_tip));
  CylindricalSpec axis = spec(2);
  EXPECT_TRUE(warns(made(axis), WarningCode::through_axis));
  EXPECT_FALSE(made(axis).exists());
  CylindricalSpec severed = spec(4);
  severed.profile_shift = -0.6;
  EXPECT_TRUE(warns(made(severed), WarningCode::severed));
  EXPECT_FALSE(made(severed).exists());
  CylindricalSpec topped = spec(30);
  topped.straight_rack().tip_fillet_radius = 0.1;
  topped.tip_diameter = 65.0;
  EXPECT_TRUE(warns(made(topped), WarningCode::tip_cut_by_rack));
  EXPECT_EQ(made(topped).actual_tip_radius(), 32.0);
  CylindricalSpec steep = spec(30);
  steep.normal_pressure_angle = 30_deg;
  EXPECT_TRUE(warns(made(steep), WarningCode::full_radius_root));
}

TEST(MakeGear, tip_thickness_is_that_of_the_finished_tooth) {
  const Gear gear = made(spec(25));
  const double s_at = 2 * gear.tooth->outline.arcs.back().begin * gear.actual_tip_radius();
  EXPECT_NEAR(*gear.tip_tooth_thickness_normal, s_at, 1e-12);
  CylindricalSpec round = spec(25);
  round.straight_rack().tip_fillet_radius = 0.2;
  EXPECT_LT(*made(round).tip_tooth_thickness_normal, *gear.tip_tooth_thickness_normal - 0.1);
}

// If the blank is turned to the base circle, the computed tip may lie an ulp inside it.
TEST(MakeGear, tip_on_the_base_circle) {
  for (int teeth = 60; teeth < 160; ++teeth) {
    CylindricalSpec s = spec(teeth);
    s.tip_diameter = made(s).reference().base_diameter;
    const auto gear = make_gear(s);
    if (gear && gear->exists() && !gear->tooth->pointed) {
      EXPECT_GT(*gear->tip_tooth_thickness_normal, 0.0);
    }
  }
}

TEST(MakeGear, ring) {
  CylindricalSpec s = spec(-60);
  s.profile_shift = 0.1;
  const Gear ring = made(s);
  EXPECT_TRUE(ring.internal());
  EXPECT_FALSE(ring.tooth);
  EXPECT_EQ(ring.tip_diameter, 120 - 4 * 1.1);
  EXPECT_EQ(ring.root_diameter, 120 + 4 * (1.25 - 0.1));
  EXPECT_FALSE(ring.root_form_radius());
  EXPECT_EQ(ring.tip_form_radius(), ring.tip_diameter / 2);
  EXPECT_FALSE(ring.undercut);
  EXPECT_FALSE(ring.undercut_free_shift());
}

// Only an internal gear has a body bore by default: the outside of a rim of 2.5 modules.
TEST(MakeGear, body_bore) {
  Gear external = made(spec(60)), ring = made(spec(-60));
  EXPECT_FALSE(body_bore(external));
  EXPECT_EQ(body_bore(ring)->diameter, ring.root_diameter + 2 * 2.5 * 2.0);
  for (Gear* const gear : {&external, &ring}) {
    gear->bore = Bore{150.0};
    EXPECT_EQ(body_bore(*gear)->diameter, 150.0);
  }
}

TEST(MakeGear, errors_name_their_key) {
  const auto key = [](auto change) {
    CylindricalSpec s = spec(20);
    change(s);
    const auto gear = make_gear(s);
    if (gear) return std::string("made");
    const std::string& k = gear.error().field;
    EXPECT_NE(gear.error().message().find(k), std::string::npos) << gear.error().message();
    EXPECT_FALSE(gear.error().value.empty());
    return k;
  };
  EXPECT_EQ(key([](CylindricalSpec&) {}), "made");
  EXPECT_EQ(key([](CylindricalSpec& s) { s.teeth = 0; }), "teeth");
  for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.normal_module = bad; }), "normal_module");
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.face_width = bad; }), "face_width");
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.tip_diameter = bad; }), "tip_diameter");
  }
  for (const double bad : {0.0, 90.0, -20.0, kNaN, kInfinity}) {
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.normal_pressure_angle = Angle::degrees(bad); }),
              "normal_pressure_angle");
  }
  for (const double bad : {90.0, -90.0, kNaN, kInfinity}) {
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.helix_angle = Angle::degrees(bad); }), "helix_angle");
  }
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.profile_shift = bad; }), "profile_shift");
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.thickness_allowance = bad; }), "thickness_allowance");
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.straight_rack().addendum = bad; }), "rack.addendum");
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.straight_rack().dedendum = bad; }), "rack.dedendum");
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.straight_rack().root_fillet_radius = bad; }),
              "rack.root_fillet_radius");
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.straight_rack().tip_fillet_radius = bad; }),
              "rack.tip_fillet_radius");
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.straight_rack().tool_addendum = bad; }),
              "rack.tool_addendum");
    EXPECT_EQ(key([&](CylindricalSpec& s) { s.straight_rack().protuberance = bad; }),
              "rack.protuberance");
  }
  EXPECT_EQ(key([](CylindricalSpec& s) { s.tip_diameter = 30.0; }), "tip_diameter");
  EXPECT_EQ(key([](CylindricalSpec& s) {
              s.teeth = -20;
              s.tip_diameter = 50.0;
            }),
            "tip_diameter");
  // The teeth of this internal gear would extend beyond its axis.
  EXPECT_EQ(key([](CylindricalSpec& s) {
              s.teeth = -4;
              s.profile_shift = 2.0;
            }),
            "tip_diameter");
}

}  // namespace
}  // namespace gearwright
