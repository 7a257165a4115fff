#include "gearwright/pair/outline_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

Gear ring(int teeth, double m, double x = 0.0, double beta_deg = 0.0) {
  CylindricalSpec short_teeth = spec(teeth, m, x, beta_deg);  // with clearance to the fillet of the
                                                              // pinion
  short_teeth.straight_rack().addendum = 0.8;
  auto cut = cut_by_default(made(short_teeth));
  EXPECT_TRUE(cut);
  return std::move(cut).value();
}

double half_play(const InvolutePair& p) { return p.mesh.backlash.rotation[1] / 2; }

OutlineGap gap_of(const InvolutePair& p, double limit = std::numeric_limits<double>::infinity()) {
  return outline_gap(p.gears[0].tooth->outline, p.gears[1].tooth->outline, p.center_distance,
                     limit);
}

OutlineGap gap_at_backlash_free_distance(const Gear& one, const Gear& two) {
  const double away = one.spec.normal_module * (two.internal() ? 0.3 : 1.0);
  const double side = two.internal() ? -1.0 : 1.0;
  const InvolutePair p =
      mounted(one, two, (two.reference_diameter + side * one.reference_diameter) / 2 + away);
  return gap_of(mounted(one, two, *p.backlash_free_center_distance));
}

// Contact takes place along the path of the involutes, and no other part comes closer.
TEST(OutlineGap, is_half_the_backlash_of_involutes) {
  const double m = 2.0;
  struct Case {
    Gear one, two;
    double a;
  };
  const Case cases[] = {
      {made(spec(20, m)), made(spec(40, m)), 60.0},
      {made(spec(20, m)), made(spec(40, m)), 60.1},
      {made(spec(25, m, 0.4)), made(spec(41, m, 0.3)), 67.5},
      {made(spec(17, m, 0.3, 20.0)), made(spec(41, m, -0.2, -20.0)), 62.5},
      {made(spec(24, m, 0.2, 30.0)), made(spec(31, m, 0.1, -30.0)), 64.3},
      {made(spec(25, m, 0.5)), ring(-70, m, -0.5), 44.95},
      {made(spec(25, m, 0.5, 15.0)), ring(-70, m, -0.4, 15.0), 46.3},
  };
  for (const Case& c : cases) {
    const InvolutePair p = mounted(c.one, c.two, c.a);
    const OutlineGap gap = gap_of(p);
    const auto flanks = gap.of(ArcName::flank, ArcName::flank);
    ASSERT_TRUE(flanks);
    EXPECT_NEAR(flanks->gap, half_play(p), 1e-12) << c.a;
    EXPECT_NEAR(flanks->arm, p.gears[1].base_radius(), 1e-9 * p.gears[1].base_radius());
    EXPECT_NEAR(gap.least()->gap, half_play(p), 1e-12) << c.a;
  }
}

// The tip fillet of a wheel cut by a pinion of ten teeth projects beyond its involute, because the
// teeth of the pinion are undercut. Measured along the circumference at the flank of gear 1, it
// projects by 8.54 and 39.95 µm.
TEST(OutlineGap, a_tip_that_bulges_overlaps_the_flank) {
  for (const auto& [shift, depth] : {std::pair{0.0, 8.0247e-3}, {-0.3, 37.538e-3}}) {
    CylindricalSpec cutter = spec(10, 2.5, shift);
    cutter.straight_rack().addendum = 1.25;
    const InvolutePair p = mounted(made(spec(20, 2.5)), cut(made(cutter), 60, 0.0, 153.5), 100.0);
    const OutlineGap gap = gap_of(p);
    const auto least = gap.least();
    ASSERT_TRUE(least);
    EXPECT_EQ(least->places[0].arc, ArcName::flank);
    EXPECT_EQ(least->places[1].arc, ArcName::tip_fillet);
    EXPECT_NEAR(least->distance(), -depth, 1e-6);
    EXPECT_NEAR(gap.of(ArcName::flank, ArcName::flank)->gap, 0.0, 1e-12);
  }
}

TEST(OutlineGap, a_cutter_with_protuberance_leaves_a_bulge_too) {
  CylindricalSpec cutter = spec(20, 2.5);
  cutter.straight_rack().addendum = 1.25;
  cutter.straight_rack().protuberance = 0.03;
  cutter.straight_rack().root_fillet_radius = 0.1;
  const InvolutePair p = mounted(made(spec(20, 2.5)), cut(made(cutter), 28, 0.0, 74.0), 60.0);
  EXPECT_NEAR(gap_of(p).least()->distance(), -8.1306e-3, 1e-6);
}

TEST(OutlineGap, a_ring_whose_cutter_was_undercut_overlaps_its_pinion) {
  CylindricalSpec one = spec(19, 1.0, 0.043, -30.0);
  one.straight_rack().addendum = 0.82;
  one.straight_rack().dedendum = 1.586;
  one.straight_rack().root_fillet_radius = 0.01;
  const Gear wheel = cut(made(spec(5, 1.0, -0.13, -30.0)), -22, -0.242);
  EXPECT_NEAR(gap_at_backlash_free_distance(made(one), wheel).least()->distance(), -25.662e-3,
              1e-6);
}

// The gears are free in the middle of the play, but not at its ends. On each side, 2.2 of the 22.6
// µm are not usable.
TEST(OutlineGap, the_true_play_is_less_than_that_of_the_flanks) {
  CylindricalSpec one = spec(22, 0.5, -0.01, -12.0);
  one.normal_pressure_angle = Angle::degrees(22.5);
  one.thickness_allowance = -0.048;
  StraightRack& rack = one.straight_rack();
  rack.addendum = 0.912;
  rack.dedendum = 1.439;
  rack.root_fillet_radius = 0.184;
  rack.tool_addendum = 0.726;
  rack.semi_topping_angle = Angle::degrees(30.0);
  CylindricalSpec cutter = spec(9, 0.5, -0.139, -12.0);
  cutter.normal_pressure_angle = Angle::degrees(22.5);
  cutter.straight_rack().addendum = 1.25;
  cutter.straight_rack().tip_fillet_radius = 0.2;
  const Gear pinion = made(one);
  const Gear wheel = cut(made(cutter), -42, -0.356);
  const InvolutePair p = mounted(pinion, wheel, 5.2804527);
  const OutlineGap gap = gap_of(p);
  EXPECT_GT(gap.least()->gap, 0.0);
  EXPECT_NEAR(gap.least()->distance(half_play(p)), -2.199e-3, 1e-5);
  EXPECT_EQ(gap.least()->places[1].arc, ArcName::tip_fillet);
}

TEST(OutlineGap, a_wheel_cut_by_its_pinion_and_mounted_further_apart_has_less_play) {
  CylindricalSpec one = spec(20, 2.5, 0.6);
  one.straight_rack().protuberance = 0.02;
  one.straight_rack().root_fillet_radius = 0.1;
  const Gear pinion = made(one);
  const InvolutePair p = mounted(pinion, cut(pinion, 28, -0.6), 61.0);
  EXPECT_TRUE(p.interference.empty());
  const auto least = gap_of(p).least();
  EXPECT_NEAR(least->distance(half_play(p)), -38.466e-3, 1e-6);
  EXPECT_EQ(least->places[1].arc, ArcName::tip_fillet);
}

// A gear meshes without backlash with the gear that it has cut, so the least gap is 0.
TEST(OutlineGap, a_gear_touches_what_it_has_cut) {
  const Gear cutter = made(spec(20, 2.5, 0.2));
  const auto distance = generating_distance(cutter, 33, 0.1);
  ASSERT_TRUE(distance);
  const OutlineGap gap = gap_of(mounted(cutter, cut(cutter, 33, 0.1), *distance));
  EXPECT_NEAR(gap.least()->gap, 0.0, 1e-12);
}

// The limit reduces the number of evaluations. Gaps below the limit are unchanged.
TEST(OutlineGap, the_limit_leaves_what_lies_below_it) {
  CylindricalSpec cutter = spec(10, 2.5);
  cutter.straight_rack().addendum = 1.25;
  const InvolutePair p = mounted(made(spec(20, 2.5)), cut(made(cutter), 60, 0.0, 153.5), 100.0);
  const OutlineGap all = gap_of(p), some = gap_of(p, 0.0);
  EXPECT_EQ(all.least()->gap, some.least()->gap);
  EXPECT_LT(some.evaluations, all.evaluations);
}

// Few gaps are evaluated for a plain pair. Their number is equal on every machine.
TEST(OutlineGap, a_plain_pair_asks_for_few_gaps) {
  const InvolutePair p = mounted(made(spec(20, 2.0)), made(spec(40, 2.0)), 60.1);
  EXPECT_LE(gap_of(p, half_play(p)).evaluations, 250);
}

}  // namespace
}  // namespace gearwright
