#include "gearwright/report/gear_figures.hpp"

#include <gtest/gtest.h>

#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

using testing::sample_gear;

std::vector<double> shifts_of(const Gear& gear) {
  std::vector<double> shifts;
  for (const ShiftedTooth& t : shifted_teeth(gear)) shifts.push_back(t.shift);
  return shifts;
}

TEST(ShiftPicture, OnlyWhereItSaysSomething) {
  EXPECT_TRUE(shift_is_worth_a_picture(testing::two_teeth()));
  EXPECT_TRUE(shift_is_worth_a_picture(sample_gear(8, 2, 0, 0)));
  EXPECT_FALSE(shift_is_worth_a_picture(sample_gear(9, 2, 0, 0)));
  // This gear has no undercut and no circular fillet.
  EXPECT_FALSE(shift_is_worth_a_picture(sample_gear(8, 2, 0, 0.7)));
  EXPECT_FALSE(shift_is_worth_a_picture(sample_gear(3, 2, 0, -0.6)));
  EXPECT_FALSE(shift_is_worth_a_picture(testing::two_and_sixty().gears[1]));
  EXPECT_EQ(shift_figures(sample_gear(20, 2, 0, 0), "gear1", "Gear 1"), "");
}

TEST(ShiftPicture, TheOwnShiftIsOneOfThem) {
  EXPECT_EQ(shifts_of(testing::two_teeth()), (std::vector<double>{0.3, 0.5, 0.7, 0.9, 1.0}));
  EXPECT_EQ(shifts_of(sample_gear(7, 2, 0, 0.1)),
            (std::vector<double>{0.1, 0.3, 0.5, 0.7, 0.9, 1.0}));
  for (const ShiftedTooth& t : shifted_teeth(testing::two_teeth()))
    EXPECT_EQ(t.own, t.shift == 0.7);
}

TEST(ShiftPicture, UndercutEndsAtTheLimit) {
  for (const Gear& gear : {testing::two_teeth(), sample_gear(7, 2, 0, 0.1)}) {
    for (const ShiftedTooth& t : shifted_teeth(gear)) {
      EXPECT_EQ(t.rack_cut.undercut, t.rack_cut.reference().generating_profile_shift <
                                         *gear.involute()->undercut_free_profile_shift);
      ASSERT_TRUE(t.rounded);
      EXPECT_FALSE(t.rounded->undercut);
      EXPECT_TRUE(t.rounded->tooth->root_fillet);
      // The flank begins at the end of the given root fillet, beyond F.
      const double l_F = std::max(0.0, *t.rounded->involute()->undercut_l);
      const double offset = gear.spec.root_fillet ? gear.spec.root_fillet->offset : 0.0;
      EXPECT_NEAR(*t.rounded->involute()->point_c_l, l_F + offset, 1e-12);
    }
  }
}

TEST(ShiftPicture, WhereNoCircleFitsItSaysSo) {
  CylindricalSpec spec = testing::two_teeth().spec;
  spec.teeth = 1;
  spec.profile_shift = 0.5;
  spec.straight_rack().dedendum = 1.0;
  auto one = make_gear(spec);
  ASSERT_TRUE(one);
  const auto teeth = shifted_teeth(*one);
  EXPECT_TRUE(teeth.front().rounded);
  EXPECT_FALSE(teeth.back().rounded);
  const std::string page = shift_figures(*one, "gear1", "Gear 1");
  EXPECT_NE(page.find("no circular root fillet fits"), page.npos);
  EXPECT_NE(page.find("undercut if cut by the rack"), page.npos);
  EXPECT_EQ(page.find("nan"), page.npos);
}

}  // namespace
}  // namespace gearwright
