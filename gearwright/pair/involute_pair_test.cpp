#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/testing/mounted.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace gearwright {
namespace {

using testing::mounted;

using namespace literals;

Gear gear(int teeth, double x = 0.0, Angle beta = 0_deg, double tip = 0.0) {
  CylindricalSpec s =
      testing::plain_spec({.teeth = teeth, .module = 2.0, .x = x, .face_width = 20.0});
  s.helix_angle = beta;
  s.rack = *iso53_rack("ISO53-A");
  if (tip > 0.0) s.tip_diameter = tip;
  return testing::taken(make_gear(s));
}

TEST(MountParallel, standard_pair) {
  const ParallelPair p = mounted(gear(20), gear(40), 60.0);
  EXPECT_EQ(p.side(), 1.0);
  EXPECT_FALSE(p.margins);
  EXPECT_EQ(p.gear_ratio(), 2.0);
  EXPECT_EQ(p.reference_center_distance, 60.0);
  EXPECT_EQ(p.extended_center_distance, 60.0);
  EXPECT_EQ(p.tip_shortening, 0.0);
  EXPECT_NEAR(*p.backlash_free_center_distance, 60.0, 1e-12);
  EXPECT_NEAR(p.tip_clearance[0], 0.5, 1e-13);
  EXPECT_NEAR(p.tip_clearance[1], 0.5, 1e-13);
  EXPECT_GT(*p.form_clearance[0], 0.0);
  EXPECT_GT(*p.fillet_clearance[0], 0.0);
  EXPECT_TRUE(p.interference.empty());
  EXPECT_TRUE(p.warnings.empty());
  EXPECT_EQ(p.contact_ratio(), p.mesh.path_ratio);
}

TEST(MountParallel, internal_pair) {
  const ParallelPair p = mounted(gear(20), gear(-60), 40.0);
  EXPECT_EQ(p.side(), -1.0);
  EXPECT_EQ(p.gear_ratio(), -3.0);
  EXPECT_NEAR(p.tip_clearance[0], 0.5, 1e-13);
  EXPECT_NEAR(p.tip_clearance[1], 0.5, 1e-13);
  ASSERT_TRUE(p.margins && p.margins->trochoid);
  EXPECT_GT(p.margins->trochoid->rad(), 0.0);
  EXPECT_FALSE(p.fillet_clearance[1]);
}

TEST(MountParallel, partners_that_cannot_mesh) {
  const auto key = [](const Gear& g1, const Gear& g2, double a) {
    const auto p = mount_as<ParallelPair>(g1, g2, {a});
    return p ? std::string("mounted") : p.error().field;
  };
  EXPECT_EQ(key(gear(20, 0, 15_deg), gear(40, 0, 15_deg), 62.0), "pair.shaft_angle");
  EXPECT_EQ(key(gear(20, 0, 15_deg), gear(40, 0, -15_deg), 63.0), "mounted");
  EXPECT_EQ(key(gear(20, 0, 15_deg), gear(-60, 0, 15_deg), 41.5), "mounted");
  EXPECT_EQ(key(gear(20, 0, 15_deg), gear(-60, 0, -15_deg), 41.5), "gear2.helix_angle");
  EXPECT_EQ(key(gear(-60), gear(20), 40.0), "gear1.teeth");
  EXPECT_EQ(key(gear(60), gear(-60), 1.0), "gear2.teeth");
  EXPECT_EQ(key(gear(20), gear(40), 55.0), "pair.center_distance");
  EXPECT_EQ(key(gear(2), gear(40), 42.0), "gear1.profile_shift");
  CylindricalSpec other = gear(40).spec;
  other.normal_module = 2.1;
  EXPECT_EQ(key(gear(20), *make_gear(other), 61.0), "gear2.normal_module");
}

// Gears with different modules and pressure angles but equal base pitches mesh.
TEST(MountParallel, equal_base_pitches_are_enough) {
  CylindricalSpec other = gear(40).spec;
  other.normal_pressure_angle = 25_deg;
  other.normal_module = 2.0 * std::cos((20_deg).rad()) / std::cos((25_deg).rad());
  other.tip_diameter = 84.0;
  const auto p = mount_as<ParallelPair>(gear(20), *make_gear(other), {60.5});
  ASSERT_TRUE(p) << p.error().message();
  EXPECT_GT(p->contact_ratio(), 1.0);
}

TEST(Pair, poses_put_tooth_and_space_on_the_centre_line) {
  const ParallelPair out = mounted(gear(20), gear(41), 61.0);
  const Point<Housing> tooth_1 = out.pose_1() * Point<Gear1>{Vec3(22.0, 0.0, 3.0)};
  EXPECT_EQ(tooth_1.r, Vec3(22.0, 0.0, 3.0));
  // The middle of space 0 of gear 2, which is half a pitch from tooth 0 and points towards gear 1.
  const double half = std::numbers::pi / 41;
  for (const double side : {-1.0, 1.0}) {
    const Vec3 space(41.0 * std::cos(half), side * 41.0 * std::sin(half), 0.0);
    const Vec3 r = (out.pose_2() * Point<Gear2>{space}).r;
    const bool on_line = (r - Vec3(61.0 - 41.0, 0.0, 0.0)).norm() < 1e-12;
    EXPECT_EQ(on_line, side > 0.0);
  }
  const ParallelPair in = mounted(gear(20), gear(-60), 40.0);
  EXPECT_EQ((in.pose_1() * Point<Gear1>{Vec3(22.0, 0.0, 0.0)}).r, Vec3(-22.0, 0.0, 0.0));
  const double half_ring = std::numbers::pi / 60;
  const Vec3 space(60.0 * std::cos(half_ring), 60.0 * std::sin(half_ring), 0.0);
  EXPECT_LE(((in.pose_2() * Point<Gear2>{space}).r - Vec3(-20.0, 0.0, 0.0)).norm(), 1e-12);
}

TEST(Pair, line_of_action_touches_both_base_circles) {
  for (const auto& p : {mounted(gear(20), gear(40), 60.4), mounted(gear(20), gear(-60), 40.2)}) {
    const Vec3 a = p.on_line_of_action(p.mesh.rho1_A).r;
    const Vec3 e = p.on_line_of_action(p.mesh.rho1_E).r;
    const Vec3 d = (e - a).normalized();
    const auto distance = [&](double x0) { return std::abs((a.x() - x0) * d.y() - a.y() * d.x()); };
    EXPECT_NEAR(distance(0.0), p.input.gears[0].radius, 1e-12);
    EXPECT_NEAR(distance(p.center_distance), p.input.gears[1].radius, 1e-12);
    EXPECT_NEAR((e - a).norm(), p.mesh.path_length, 1e-12);
    EXPECT_NEAR(e.norm(), p.input.tip_form_radius[0], 1e-12);
    EXPECT_NEAR((a - Vec3(p.center_distance, 0, 0)).norm(), p.input.tip_form_radius[1], 1e-12);
    EXPECT_EQ(p.on_line_of_action(p.mesh.rho1_C).r.y(), 0.0);
    const Vec3 mirrored = p.on_trailing_line(p.mesh.rho1_E).r;
    EXPECT_EQ(mirrored, Vec3(e.x(), -e.y(), 0.0));
  }
}

// Gear 1 turns clockwise seen from +z and drives. The normal force of its leading flank on gear 2
// has a component in the direction of motion at the mesh, which is −y for an external pair (mesh at
// +x).
TEST(Pair, leading_line_is_the_driving_one) {
  const ParallelPair p = mounted(gear(20), gear(40), 60.0);
  EXPECT_LT(p.on_line_of_action(p.mesh.rho1_E).r.y(), p.on_line_of_action(p.mesh.rho1_A).r.y());
}

TEST(Pair, what_is_wrong_with_a_mesh_is_data) {
  const ParallelPair tight = mounted(gear(20), gear(40), 59.9);
  EXPECT_LT(tight.mesh.backlash.normal, 0.0);
  EXPECT_TRUE(warns(tight, WarningCode::negative_backlash));
  EXPECT_FALSE(warns(mounted(gear(20), gear(40), 60.0), WarningCode::negative_backlash));
  const ParallelPair apart = mounted(gear(20), gear(40), 62.0);
  EXPECT_LT(apart.contact_ratio(), 1.0);
  EXPECT_GT(apart.contact_ratio_true(), 0.0);
  EXPECT_TRUE(warns(apart, WarningCode::contact_ratio));
  const ParallelPair apart_for_good = mounted(gear(20), gear(40), 66.0);
  EXPECT_EQ(apart_for_good.contact_ratio_true(), 0.0);
  EXPECT_TRUE(warns(apart_for_good, WarningCode::no_contact));
  const ParallelPair long_tip = mounted(gear(20), gear(40, 0, 0_deg, 85.0), 60.0);
  EXPECT_TRUE(warns(long_tip, WarningCode::form_circle));
  EXPECT_LT(*long_tip.form_clearance[0], 0.0);
  const ParallelPair longer = mounted(gear(20), gear(40, 0, 0_deg, 86.0), 60.0);
  EXPECT_TRUE(warns(longer, WarningCode::base_tangent));
  EXPECT_FALSE(longer.form_clearance[0]);
  EXPECT_TRUE(warns(longer, WarningCode::root));
  EXPECT_NEAR(longer.tip_clearance[1], -0.5, 1e-12);
  const ParallelPair undercut = mounted(gear(9), gear(120), 129.0);
  EXPECT_TRUE(warns(undercut, WarningCode::contact_lost_to_undercut));
  EXPECT_FALSE(warns(undercut, WarningCode::base_tangent));
  const ParallelPair close_ring = mounted(gear(50), gear(-56), 6.0);
  EXPECT_TRUE(warns(close_ring, WarningCode::trochoid));
}

// Gears 7:80, β = 22°. According to an independent program, the undercut flank of the pinion begins
// at ρ_1 = 0.3424 mm, where ζ_1 = −8.14. At the point A of the tips, which contact does not reach,
// ζ_1 is −30.84.
TEST(MountParallel, sliding_is_that_of_the_usable_flanks) {
  const auto helical = [](int teeth, double x, Angle beta, double allowance) {
    CylindricalSpec s =
        testing::plain_spec({.teeth = teeth, .module = 2.0, .x = x, .face_width = 28.0});
    s.helix_angle = beta;
    s.thickness_allowance = allowance;
    s.rack = *iso53_rack("ISO53-C");
    return testing::taken(make_gear(s));
  };
  const ParallelPair p = testing::taken(mount_as<ParallelPair>(
      helical(7, 0.48, 22_deg, -0.05), helical(80, -0.13, -22_deg, -0.08), {}));
  EXPECT_NEAR(p.mesh.rho1_true_begin, 0.3424, 5e-5);
  EXPECT_NEAR(*p.sliding_A.zeta_1, -8.14, 5e-3);
  EXPECT_NEAR(*p.sliding_E.zeta_1, 0.68309, 5e-6);
}

}  // namespace
}  // namespace gearwright
