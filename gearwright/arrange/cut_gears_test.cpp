#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "gearwright/arrange/arrange.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

namespace gearwright {
namespace {

GearInput shaped(int teeth, int cutter_teeth, double x = 0.0) {
  GearInput gear =
      GearInput::of(testing::plain_spec({.teeth = teeth, .module = 2, .face_width = 20.0}));
  gear.give_shift(x);
  gear.cut_by.emplace().cutter = std::make_shared<GearInput>(
      GearInput::of(testing::plain_spec({.teeth = cutter_teeth, .module = 2, .face_width = 20.0})));
  return gear;
}

Arranged alone(const GearInput& gear) {
  GivenPair given;
  given.gears[0] = gear;
  return testing::taken(arrange(given));
}

std::string note_of_tip(const Arranged& arranged) {
  std::string text;
  for (const Warning& w : arranged.warnings)
    if (w.code == WarningCode::tip_cut_by_rack) text += w.message;
  return text;
}

TEST(CutGears, note_the_tip_that_the_root_of_the_cutter_determines) {
  const Arranged ring = alone(shaped(-60, 25));
  EXPECT_EQ(note_of_tip(ring),
            "`tip_diameter` is not given, so the root of the cutter cuts the tip to a diameter of "
            "115.0000 mm. Usual cutters do not cut the tip; the usual tip diameter of this gear is "
            "116.0000 mm.");
  GearInput usual = shaped(-60, 25);
  usual.cylindrical.tip_diameter = 116.0;
  EXPECT_EQ(note_of_tip(alone(usual)), "");
}

TEST(CutGears, note_the_tip_diameter_that_their_cutter_does_not_reach) {
  const auto note_with = [](std::optional<double> tip_diameter) {
    GearInput cutter =
        GearInput::of(testing::plain_spec({.teeth = 25, .module = 2, .face_width = 20.0}));
    StraightRack& rack = cutter.cylindrical.rack.emplace<StraightRack>();
    rack.addendum = 1.25;
    rack.tip_fillet_radius = 0.2;
    cutter.cylindrical.tip_diameter = tip_diameter;
    GearInput ring = shaped(-60, 25);
    ring.cylindrical.tip_diameter = 116.0;
    ring.cut_by->cutter = std::make_shared<GearInput>(cutter);
    return note_of_tip(alone(ring));
  };
  EXPECT_NE(
      note_with(200.0).find("200.0000 mm. The bottom land of the rack that cuts them ends them "
                            "at a diameter of 55.0000 mm"),
      std::string::npos)
      << note_with(200.0);
  EXPECT_EQ(note_with(55.0), "");
  EXPECT_EQ(note_with(std::nullopt), "");
}

// The point of the cutter is found by bisection of its tooth thickness, s = d (s_0/d_0 + inv α_0 −
// inv α).
TEST(CutGears, warn_of_a_cutter_that_is_pointed_below_its_tip_diameter) {
  const auto warnings_with = [](double tip_diameter) {
    GearInput cutter =
        GearInput::of(testing::plain_spec({.teeth = 20, .module = 2, .face_width = 20.0}));
    cutter.cylindrical.tip_diameter = tip_diameter;
    GearInput ring = shaped(-60, 20);
    ring.cut_by->cutter = std::make_shared<GearInput>(cutter);
    std::string text;
    for (const Warning& w : alone(ring).warnings)
      if (w.code == WarningCode::pointed) text += w.message;
    return text;
  };
  const auto inv = [](double angle) { return std::tan(angle) - angle; };
  const double alpha = 20 * kPi / 180, d_b = 40 * std::cos(alpha);
  double lo = 40, hi = 60;
  for (int i = 0; i < 100; ++i) {
    const double d = (lo + hi) / 2;
    (kPi / 40 + inv(alpha) - inv(std::acos(d_b / d)) > 0 ? lo : hi) = d;
  }
  EXPECT_NE(warnings_with(100).find("end at a diameter of " + std::to_string(lo).substr(0, 5)),
            std::string::npos)
      << warnings_with(100);
  EXPECT_EQ(warnings_with(45), "");
}

// The half angle of the cut tooth at this radius, rad. It is found by bisection along the flank.
double half_angle(const Gear& gear, double radius) {
  const Arc& flank = *gear.tooth->outline.find(ArcName::flank);
  double lo = 0.0, hi = 1.0;
  for (int i = 0; i < 100; ++i) {
    const double u = (lo + hi) / 2;
    (gear.side() * (flank.point(u).norm() - radius) < 0.0 ? lo : hi) = u;
  }
  const Vec2 p = flank.point(lo);
  return std::atan2(p.y(), p.x());
}

// On the reference circle, the thickness of the teeth as cut is π m/2 + 2 x m tan α + E_sn. This is
// tested at both ends of the series and at their mean.
TEST(CutGears, have_the_thickness_of_a_series_by_the_infeed_of_their_cutter) {
  for (const int teeth : {18, -60}) {
    GearInput gear = shaped(teeth, 25, 0.1);
    gear.tolerance.series = "cd25";
    const Arranged arranged = alone(gear);
    ASSERT_TRUE(arranged.ends);
    const Ends allowances = *arranged.completed.gear(1).allowance_ends;
    EXPECT_LT(allowances[0], allowances[1]);
    EXPECT_LT(allowances[1], 0.0);
    const auto expect = [&](const Arranged& at, double allowance) {
      const Gear& made = at.gear(1);
      EXPECT_NEAR(made.spec.profile_shift, 0.1, 1e-12);
      EXPECT_NEAR(made.spec.thickness_allowance, allowance, 1e-15);
      const double d = made.reference_diameter;
      EXPECT_NEAR(half_angle(made, d / 2) * d, kPi + 4 * 0.1 * std::tan(20 * kPi / 180) + allowance,
                  1e-10)
          << teeth;
    };
    expect(arranged, (allowances[0] + allowances[1]) / 2);
    expect(arranged.ends->lower, allowances[0]);
    expect(arranged.ends->upper, allowances[1]);
    // A thinner tooth needs a greater depth of cut. The root of the cutter then cuts a shorter tip.
    const double deeper = arranged.ends->upper.gear(1).cut_by->distance -
                          arranged.ends->lower.gear(1).cut_by->distance;
    EXPECT_GT(deeper * side_of(teeth), 0.0);
    EXPECT_NEAR(
        arranged.ends->upper.gear(1).tip_diameter - arranged.ends->lower.gear(1).tip_diameter,
        2 * deeper, 1e-9);
  }
}

TEST(CutGears, have_no_series_if_the_mating_gear_cuts_them) {
  GivenPair given;
  given.gears[0] =
      GearInput::of(testing::plain_spec({.teeth = 18, .module = 2, .face_width = 20.0}));
  given.gears[1] = shaped(40, 18);
  given.gears[1]->cut_by->gear = 1;
  given.gears[1]->tolerance.series = "cd25";
  const auto arranged = arrange(given);
  ASSERT_FALSE(arranged);
  EXPECT_EQ(arranged.error().field, "gear2.tolerance.series");
}

}  // namespace
}  // namespace gearwright
