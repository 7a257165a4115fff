// Tests overlap, contact beyond the flanks and the free play of mounted pairs. The cases include
// collisions that the checks of circles and corners miss, and false alarms of these checks.
#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/testing/mounted.hpp"

namespace gearwright {
namespace {

using testing::cut;
using testing::made;
using testing::mounted;
using testing::spec;

Gear wheel_of_undercut_pinion() {
  CylindricalSpec cutter = spec(10, 2.5);
  cutter.straight_rack().addendum = 1.25;
  return cut(made(cutter), 60, 0.0, 153.5);
}

TEST(Overlap, a_plain_pair_has_none) {
  for (const double a : {60.0, 60.1}) {
    const InvolutePair p = mounted(made(spec(20, 2.0)), made(spec(40, 2.0)), a);
    ASSERT_TRUE(p.overlap);
    EXPECT_TRUE(p.overlap->empty());
    EXPECT_TRUE(p.beyond_flank.empty());
    EXPECT_TRUE(p.interference.empty());
    EXPECT_EQ(p.free_play->rad(), p.mesh.backlash.rotation[1]);
  }
}

TEST(Overlap, a_tip_that_bulges_is_said_by_the_gear_and_by_the_pair) {
  const Gear wheel = wheel_of_undercut_pinion();
  ASSERT_TRUE(wheel.tip_bulge);
  EXPECT_NEAR(wheel.tip_bulge->amount, 8.0247e-3, 1e-6);
  EXPECT_EQ(wheel.tip_bulge->from_diameter, 2 * wheel.tip_form_radius());
  EXPECT_TRUE(warns(wheel, WarningCode::tip_bulge));
  const InvolutePair p = mounted(made(spec(20, 2.5)), wheel, 100.0);
  ASSERT_EQ(p.overlap->size(), 1U);
  const Collision& collision = p.overlap->front();
  EXPECT_EQ(collision.cause, CollisionCause::tip_bulge);
  EXPECT_EQ(collision.gear, 2);
  EXPECT_NEAR(collision.depth, 8.0247e-3, 1e-6);
  ASSERT_EQ(p.interference.size(), 1U);
  EXPECT_EQ(p.interference[0].code, WarningCode::overlap);
  EXPECT_TRUE(warns(p, WarningCode::overlap));
  EXPECT_LT(p.free_play->rad(), 0.0);
  // The remedy in the message removes the collision.
  CylindricalSpec cutter = spec(10, 2.5);
  cutter.straight_rack().addendum = 1.25;
  const Gear shorter = cut(made(cutter), 60, 0.0, wheel.tip_bulge->from_diameter);
  EXPECT_FALSE(shorter.tip_bulge);
  EXPECT_TRUE(mounted(made(spec(20, 2.5)), shorter, 100.0).overlap->empty());
}

// A tip that projects beyond the involute does not collide with the cutter that generated it.
TEST(Overlap, a_wheel_runs_with_the_pinion_that_cut_it) {
  CylindricalSpec one = spec(20, 2.5, 0.6);
  one.straight_rack().protuberance = 0.02;
  one.straight_rack().root_fillet_radius = 0.1;
  const Gear pinion = made(one);
  const Gear wheel = cut(pinion, 28, -0.6);
  const double e = testing::taken(generating_distance(pinion, 28, -0.6));
  const InvolutePair p = mounted(pinion, wheel, e);
  EXPECT_TRUE(p.overlap->empty());
  EXPECT_TRUE(p.beyond_flank.empty());
  // At a greater distance there is backlash, but the tip touches before the flanks do.
  const InvolutePair apart = mounted(pinion, wheel, 61.0);
  EXPECT_TRUE(apart.overlap->empty());
  ASSERT_EQ(apart.beyond_flank.size(), 1U);
  EXPECT_EQ(apart.beyond_flank[0].cause, CollisionCause::tip_bulge);
  EXPECT_NEAR(apart.beyond_flank[0].depth, 38.466e-3, 1e-6);
  EXPECT_TRUE(apart.interference.empty());
  EXPECT_TRUE(warns(apart, WarningCode::beyond_flank));
  EXPECT_GT(apart.free_play->rad(), 0.0);
  EXPECT_LT(apart.free_play->rad(), apart.mesh.backlash.rotation[1]);
}

// In a pair 60:60 with x = −0.5, the tips pass the start of the flanks. Without backlash the teeth
// overlap, and with backlash they only touch beyond the flanks. The backlash of the flanks remains
// as in the textbook.
TEST(Overlap, below_the_form_circle_it_is_overlap_or_contact_beyond_the_flank) {
  const CylindricalSpec one = spec(60, 2.0, -0.5);
  const InvolutePair close = testing::taken(mount_as<ParallelPair>(made(one), made(one), {}));
  ASSERT_FALSE(close.overlap->empty());
  EXPECT_EQ(close.overlap->front().cause, CollisionCause::tip_to_fillet);
  EXPECT_TRUE(warns(close, WarningCode::form_circle));
  EXPECT_NEAR(close.mesh.backlash.normal_base, 0.0, 1e-12);
  EXPECT_LT(close.free_play->rad(), 0.0);
  const InvolutePair apart = mounted(made(one), made(one), close.center_distance + 0.08);
  EXPECT_TRUE(apart.overlap->empty());
  EXPECT_TRUE(apart.interference.empty());
  EXPECT_FALSE(apart.beyond_flank.empty());
  EXPECT_FALSE(warns(apart, WarningCode::form_circle));
}

TEST(Overlap, teeth_too_thick_and_tips_in_roots_overlap) {
  const InvolutePair thick = mounted(made(spec(20, 2.0)), made(spec(40, 2.0)), 59.9);
  ASSERT_EQ(thick.overlap->size(), 1U);
  EXPECT_EQ(thick.overlap->front().cause, CollisionCause::negative_backlash);
  EXPECT_NEAR(thick.overlap->front().depth, -thick.mesh.backlash.normal_base / 2, 1e-15);
  EXPECT_TRUE(thick.interference.empty());
  CylindricalSpec longer = spec(40, 2.0);
  longer.tip_diameter = 86.0;
  const InvolutePair deep = mounted(made(spec(20, 2.0)), made(longer), 60.0);
  ASSERT_FALSE(deep.overlap->empty());
  EXPECT_EQ(deep.overlap->front().cause, CollisionCause::root);
  EXPECT_NEAR(deep.overlap->front().depth, 0.5, 1e-12);
  EXPECT_FALSE(deep.free_play);
}

}  // namespace
}  // namespace gearwright
