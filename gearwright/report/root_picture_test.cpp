#include "gearwright/report/gear_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/report/report_tables.hpp"
#include "gearwright/report/testing/page_text.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

using testing::count_of;
using testing::sample_gear;

TEST(RootPicture, OnlyWhereItSaysSomething) {
  EXPECT_TRUE(root_is_worth_a_picture(testing::two_teeth()));
  EXPECT_TRUE(root_is_worth_a_picture(sample_gear(14, 2, 0, 0)));  // undercut
  EXPECT_TRUE(root_is_worth_a_picture(sample_gear(12, 2, 0, 0.5)));
  EXPECT_FALSE(root_is_worth_a_picture(sample_gear(13, 2, 0, 0.5)));
  EXPECT_FALSE(root_is_worth_a_picture(sample_gear(3, 2, 0, -0.6)));  // this gear does not exist
  EXPECT_FALSE(root_is_worth_a_picture(sample_gear(-60, 2, 0, 0)));
  EXPECT_FALSE(root_is_worth_a_picture(testing::pinion_in_cut_ring().gears[1]));
  EXPECT_FALSE(root_is_worth_a_picture(testing::two_and_sixty().gears[1]));
  EXPECT_EQ(root_figure(sample_gear(20, 2, 0, 0), "gear1", "Gear 1"), "");
  EXPECT_EQ(few_teeth_table({}), "");
}

TEST(RootPicture, TheRackAloneCutsTheSameGearWithoutFillets) {
  const Gear gear = testing::two_teeth();
  const auto rack = by_rack_alone(gear);
  ASSERT_TRUE(rack);
  EXPECT_FALSE(gear.undercut);
  EXPECT_TRUE(rack->undercut);
  EXPECT_EQ(rack->reference().base_tooth_thickness, gear.reference().base_tooth_thickness);
  EXPECT_FALSE(rack->tooth->root_fillet || rack->tooth->tip_fillet);
  EXPECT_FALSE(by_rack_alone(*rack));
  EXPECT_FALSE(by_rack_alone(testing::two_and_sixty().gears[1]));
}

TEST(RootPicture, UndercutBeginsWhereTheFlankMeetsTheBaseCircle) {
  for (const Gear& gear : {testing::two_teeth(), sample_gear(12, 2, 15, 0.4, 0.0, -0.05)}) {
    const Vec2 F = undercut_limit_point(gear);
    EXPECT_NEAR(F.norm(), gear.base_radius(), 1e-13 * gear.base_radius());
    // The involute of the flank, extended back to ξ = 0.
    const Arc* flank = gear.tooth->outline.find(ArcName::flank);
    EXPECT_LT((flank->curve->point(0.0) - F).norm(), 1e-12);
  }
}

TEST(RootPicture, ShowsBothRootsAndThePoints) {
  const std::string page = root_figure(testing::two_teeth(), "gear1", "Gear 1");
  EXPECT_GT(count_of(page, "class=\"before\""), 4u);  // the tooth cut by the rack, both flanks
  EXPECT_EQ(count_of(page, "class=\"arc c-root-fillet\""), 2u);  // one fillet on each side
  for (const char* letter : {">F<", ">C<", ">J<"})
    EXPECT_NE(page.find(letter), page.npos) << letter;
  // Table 1 of the paper gives l = 0.236 and 0.246, and the radii 1.045 and 0.332.
  for (const char* value : {" 0.2359<", " 0.2459<", " 1.9008<", "= 1.0454 mm", "= 0.3320 mm"})
    EXPECT_NE(page.find(value), page.npos) << value;
  EXPECT_NE(page.find("the undercut tooth as cut by the rack alone"), page.npos);

  const std::string undercut = root_figure(sample_gear(8, 2, 0, 0), "gear1", "Gear 1");
  EXPECT_EQ(count_of(undercut, "class=\"before\""), 2u);  // the removed flank, both sides
  EXPECT_NE(undercut.find("flank removed by undercut"), undercut.npos);
  EXPECT_EQ(undercut.find(">C<"), undercut.npos);
  const std::string sound = root_figure(sample_gear(10, 2, 0, 0.6), "gear1", "Gear 1");
  EXPECT_EQ(count_of(sound, "class=\"before\""), 0u);
  EXPECT_NE(sound.find("there is no undercut"), sound.npos);
}

TEST(RootPicture, EveryNumberOfTeeth) {
  for (int z = 1; z <= 12; ++z) {
    const Gear gear = sample_gear(z, 2, 20, z < 4 ? 0.6 : 0.2);
    const std::string page = root_figure(gear, "gear1", "Gear 1");
    EXPECT_EQ(page.empty(), !root_is_worth_a_picture(gear)) << z;
    EXPECT_EQ(page.find("nan"), page.npos) << z;
    EXPECT_EQ(page.find("inf"), page.npos) << z;
    EXPECT_LT(page.size(), 20'000u) << z;
  }
}

TEST(FewTeethTable, HasWhatThePaperHas) {
  const ParallelPair pair = testing::two_and_sixty();
  const std::string table = few_teeth_table({&pair.gears[0], &pair.gears[1]});
  for (const char* value :
       {">0.2359<", ">0.2459<", ">1.0454<", ">60.13603<", ">0.3320<", ">26.68714<", ">1.9008<"}) {
    EXPECT_NE(table.find(value), table.npos) << value;
  }
  const Gear ordinary = sample_gear(20, 2, 0, 0);
  EXPECT_EQ(few_teeth_table({&ordinary}), "");
  EXPECT_EQ(few_teeth_table({&pair.gears[1]}), "");
}

}  // namespace
}  // namespace gearwright
