#include "gearwright/base/testing/violation.hpp"
#include "gearwright/gear/finished_gear.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace gearwright {
namespace {

using testing::made;

using Cutter = ArcRack::Cutter;

CylindricalSpec spec_of(Cutter cutter, int teeth) {
  ArcRack rack = default_arc_rack(cutter);
  rack.arc_radius = cutter == Cutter::F ? 1.4 : 1.55;
  rack.center_a = cutter == Cutter::F ? 0.422436 : 0.552339;
  rack.center_b = cutter == Cutter::F ? 0.243893 : 0.318893;
  CylindricalSpec s =
      testing::plain_spec({.teeth = teeth, .module = 2.0, .beta_deg = 20, .face_width = 20.0});
  s.rack = rack;
  return s;
}

CylindricalSpec double_spec(int teeth) {
  CylindricalSpec s = spec_of(Cutter::F, teeth);
  s.rack = DoubleArcRack{};
  return s;
}

std::vector<ArcName> names(const Gear& gear) {
  std::vector<ArcName> list;
  for (const Arc& arc : gear.tooth->outline.arcs) list.push_back(arc.name);
  return list;
}

TEST(ArcGear, has_diameters_of_its_rack_and_no_involute) {
  const Gear gear = made(spec_of(Cutter::F, 20));
  const double d = 20 * 2.0 / std::cos(std::numbers::pi / 9);
  EXPECT_FALSE(gear.involute());
  ASSERT_TRUE(gear.arcs());
  EXPECT_DOUBLE_EQ(gear.reference_diameter, d);
  EXPECT_DOUBLE_EQ(gear.tip_diameter, d + 4 * 0.9);
  EXPECT_DOUBLE_EQ(gear.root_diameter, d - 4 * 0.3);
  GW_EXPECT_VIOLATION(static_cast<void>(gear.reference()));
  EXPECT_TRUE(gear.warnings.empty());
  EXPECT_EQ(names(gear), (std::vector{ArcName::root_land, ArcName::root_fillet, ArcName::flank,
                                      ArcName::tip_land}));
}

// The point of the rack's edge on the pitch line cuts the point of the flank on the pitch circle.
// Both points have the same distance from the centre line, measured along the pitch line and along
// the pitch circle.
TEST(ArcGear, thickness_on_the_reference_cylinder) {
  for (const double allowance : {0.0, -0.08}) {
    for (const Cutter cutter : {Cutter::F, Cutter::P}) {
      CylindricalSpec s = spec_of(cutter, 20);
      s.thickness_allowance = allowance;
      if (cutter == Cutter::P) s.tip_diameter = 20 * 2.0 / std::cos(std::numbers::pi / 9) + 0.2;
      const Gear gear = made(s);
      const Arc* flank = gear.tooth->outline.find(ArcName::flank);
      const double r = gear.reference_diameter / 2;
      const double tau = flank->curve->parameter_at_radius(r, flank->begin, flank->end);
      const double s_t = 2 * r * flank->curve->polar_angle(tau);
      EXPECT_NEAR(s_t * std::cos(s.helix_angle.rad()), *gear.arcs()->reference_thickness, 1e-12);
    }
  }
}

// The usable flank extends from the lowest to the highest of the three flank arcs.
TEST(ArcGear, double_arcs_have_three_flank_arcs) {
  const Gear gear = made(double_spec(25));
  EXPECT_EQ(names(gear), (std::vector{ArcName::root_fillet, ArcName::flank, ArcName::flank,
                                      ArcName::flank, ArcName::tip_land}));
  const auto& arcs = gear.tooth->outline.arcs;
  EXPECT_DOUBLE_EQ(*gear.root_form_radius(), arcs[1].begin_point.norm());
  EXPECT_DOUBLE_EQ(gear.tip_form_radius(), arcs[3].end_point.norm());
  // From root to tip, the concave part turns left and the convex part turns right.
  EXPECT_GT(arcs[1].at(0.5).curvature, 0.0);
  EXPECT_LT(arcs[3].at(0.5).curvature, 0.0);
}

TEST(ArcGear, flags_say_what_happened) {
  CylindricalSpec deep = spec_of(Cutter::F, 8);
  std::get<ArcRack>(deep.rack).dedendum = 0.5;
  const Gear undercut = made(deep);
  EXPECT_TRUE(undercut.undercut);
  EXPECT_TRUE(warns(undercut, WarningCode::undercut));
  EXPECT_LT(undercut.arcs()->flank_begin, *undercut.arcs()->undercut_limit);
  CylindricalSpec high = spec_of(Cutter::F, 20);
  high.tip_diameter = made(high).reference_diameter + 4.5;
  const Gear pointed = made(high);
  EXPECT_TRUE(pointed.pointed() || pointed.tooth->tip_cut_by_rack);
  CylindricalSpec small = spec_of(Cutter::P, 1);
  EXPECT_TRUE(warns(made(small), WarningCode::through_axis));
  EXPECT_FALSE(made(small).exists());
}

// A pointed tooth ends at the diameter at which both flanks meet, for any larger blank.
TEST(ArcGear, pointed_diameter) {
  CylindricalSpec s = spec_of(Cutter::F, 20);
  const Gear gear = made(s);
  ASSERT_TRUE(gear.pointed_diameter);
  s.tip_diameter = *gear.pointed_diameter * (1 - 1e-9);
  if (!made(s).tooth->tip_cut_by_rack) {
    EXPECT_LT(*made(s).tip_tooth_thickness_normal, 1e-3);
  }
}

// If the blank is too large, the bottom land of the rack ends the tooth. The bottom land follows
// the arcs.
TEST(ArcGear, the_arcs_end_tops_the_tooth) {
  CylindricalSpec s = spec_of(Cutter::P, 60);
  s.tip_diameter = made(s).reference_diameter + 4.0;
  const Gear gear = made(s);
  EXPECT_TRUE(gear.tooth->tip_cut_by_rack);
  EXPECT_TRUE(warns(gear, WarningCode::tip_cut_by_rack));
  const double top = gear.reference_diameter / 2 + reach(gear.arcs()->rack) * 2.0;
  EXPECT_NEAR(gear.actual_tip_radius(), top, 1e-12);
}

TEST(ArcGear, errors_name_their_key) {
  const auto key = [](auto change) {
    CylindricalSpec s = spec_of(Cutter::F, 20);
    change(s);
    const auto gear = make_gear(s);
    if (gear) return std::string("made");
    EXPECT_NE(gear.error().message().find(gear.error().field), std::string::npos);
    return gear.error().field;
  };
  EXPECT_EQ(key([](CylindricalSpec&) {}), "made");
  EXPECT_EQ(key([](CylindricalSpec& s) { s.teeth = -40; }), "teeth");
  EXPECT_EQ(key([](CylindricalSpec& s) { s.normal_module = 0.0; }), "normal_module");
  EXPECT_EQ(key([](CylindricalSpec& s) { s.profile_shift = 0.1; }), "profile_shift");
  EXPECT_EQ(key([](CylindricalSpec& s) { s.root_fillet = RootFilletSpec{}; }), "root_fillet");
  EXPECT_EQ(key([](CylindricalSpec& s) { s.tip_fillet = TipFilletSpec{}; }), "tip_fillet");
  EXPECT_EQ(key([](CylindricalSpec& s) { s.tip_diameter = 30.0; }), "tip_diameter");
  EXPECT_EQ(key([](CylindricalSpec& s) { std::get<ArcRack>(s.rack).addendum = 1.2; }),
            "rack.addendum");
}

TEST(ArcGear, left_and_right_hand_share_the_section) {
  CylindricalSpec s = spec_of(Cutter::F, 20);
  const Gear right = made(s);
  s.helix_angle = -s.helix_angle;
  const Gear left = made(s);
  EXPECT_EQ(left.lead, -right.lead);
  const Arc *a = right.tooth->outline.find(ArcName::flank),
            *b = left.tooth->outline.find(ArcName::flank);
  EXPECT_EQ(a->begin_point, b->begin_point);
  EXPECT_EQ(a->end_point, b->end_point);
}

}  // namespace
}  // namespace gearwright
