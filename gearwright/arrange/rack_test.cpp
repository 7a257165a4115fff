// A pinion and a rack, arranged and judged as C++ programs do it.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "gearwright/arrange/judge.hpp"
#include "gearwright/base/testing/taken.hpp"

namespace gearwright {
namespace {

using testing::taken;

GivenPair given_rack(double x = 0.2) {
  GivenPair given;
  given.gears[0] =
      GearInput::of({.teeth = 20, .normal_module = 2, .profile_shift = x, .face_width = 20});
  given.rack = RackBar{.teeth = 25};
  return given;
}

// j_n = 2 (H − H_0) tan α_n − E_sn1 − E_sn2 [T2.37], and `backlash_split` divides the thinning.
TEST(ArrangedRack, has_the_requested_backlash) {
  GivenPair given = given_rack();
  given.pair.backlash = 0.1;
  given.pair.backlash_split = 0.25;
  const Arranged thinned = taken(arrange(given));
  EXPECT_NEAR(thinned.rack->normal_backlash(), 0.1, 1e-12);
  EXPECT_NEAR(thinned.gear(1).spec.thickness_allowance, -0.025, 1e-12);
  EXPECT_NEAR(thinned.rack->rack.bar.thickness_allowance, -0.075, 1e-12);
  EXPECT_FALSE(warns(thinned, WarningCode::thickened_for_backlash));
  EXPECT_EQ(judge(thinned).level, Level::green);
  EXPECT_EQ(thinned.parts(), 2);

  given.pair.center_distance = 20.4 + 0.5;  // j_n = 0.364 mm without allowances
  const Arranged thickened = taken(arrange(given));
  EXPECT_NEAR(thickened.rack->normal_backlash(), 0.1, 1e-12);
  EXPECT_TRUE(warns(thickened, WarningCode::thickened_for_backlash));
}

TEST(ArrangedRack, is_left_out_if_only_single_gears_are_wanted) {
  const Arranged pinion = taken(arrange(given_rack(), Scope::gears));
  EXPECT_FALSE(pinion.mounted());
  EXPECT_EQ(pinion.parts(), 1);
}

TEST(ArrangedRack, names_the_backlash_that_its_teeth_cannot_have) {
  GivenPair given = given_rack();
  given.pair.backlash = 4.0;
  given.pair.backlash_split = 0.0;
  const auto made = arrange(given);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "pair.backlash");
  EXPECT_NE(made.error().rule.find("`gear2.thickness_allowance`"), std::string::npos)
      << made.error().rule;
}

// The verdict proposes a change only after the changed pinion has been mounted and judged.
TEST(ArrangedRack, verdict_proposes_a_tried_change) {
  GivenPair given = given_rack();
  given.pair.center_distance = 20.4 - 0.1;
  const Verdict verdict = judge(taken(arrange(given)));
  ASSERT_EQ(verdict.level, Level::red);
  const Finding& worst = verdict.findings.front();
  EXPECT_EQ(worst.code, WarningCode::negative_backlash);
  ASSERT_TRUE(worst.change.has_value());
  ASSERT_TRUE(make_change(given, *worst.change));
  const Arranged changed = taken(arrange(given));
  EXPECT_GT(changed.rack->normal_backlash(), -no_backlash(2));
}

// The tip radius is 19.75 mm, and the root of the rack is 19.5 mm from the axis of the pinion.
TEST(ArrangedRack, verdict_names_the_root_of_the_rack) {
  GivenPair given = given_rack(0.0);
  given.gear(1).cylindrical.teeth = 17;
  given.gear(1).cylindrical.tip_diameter = 39.5;
  const Verdict verdict = judge(taken(arrange(given)));
  const auto root = std::find_if(verdict.findings.begin(), verdict.findings.end(),
                                 [](const Finding& f) { return f.code == WarningCode::root; });
  ASSERT_NE(root, verdict.findings.end());
  EXPECT_EQ(root->gear, 2);
  EXPECT_NE(verdict.headline.find("the tip of the pinion cuts into the root of the rack"),
            std::string::npos)
      << verdict.headline;
  EXPECT_NE(root->remedy.find("the tip stays clear of the root of the rack."), std::string::npos)
      << root->remedy;
  ASSERT_TRUE(root->change.has_value());
  ASSERT_TRUE(make_change(given, *root->change));
  EXPECT_FALSE(warns(taken(arrange(given)), WarningCode::root));
}

// The backlash-free centre distance is 20 mm + 0.2 · 2 mm.
TEST(ArrangedRack, verdict_proposes_a_centre_distance) {
  GivenPair given = given_rack(0.2);
  given.pair.center_distance = 20.4 - 0.7;
  const Verdict verdict = judge(taken(arrange(given)));
  const Finding& worst = verdict.findings.front();
  ASSERT_EQ(worst.code, WarningCode::negative_backlash);
  ASSERT_TRUE(worst.change.has_value());
  EXPECT_EQ(worst.change->what, Adjustable::center_distance);
  EXPECT_NEAR(worst.change->value, 20.4, 1e-9);
}

// The backlash-free centre distance is 22 mm, which is 3.5 modules from the given distances.
TEST(ArrangedRack, verdict_proposes_a_distant_centre_distance) {
  for (const double more : {-7.0, 4.5}) {
    GivenPair given = given_rack(0.0);
    given.gear(1).cylindrical.teeth = 22;
    given.gear(1).cylindrical.tip_diameter = 48;
    given.pair.center_distance = 22 + more;
    const Verdict verdict = judge(taken(arrange(given)));
    const Finding& worst = verdict.findings.front();
    ASSERT_EQ(worst.code, WarningCode::no_contact);
    ASSERT_TRUE(worst.change.has_value());
    EXPECT_NE(verdict.headline.find(worst.remedy), std::string::npos) << verdict.headline;
    ASSERT_TRUE(make_change(given, *worst.change));
    EXPECT_EQ(judge(taken(arrange(given))).level, Level::green);
  }
}

// A pinion of 9 teeth without profile shift is undercut. At each centre distance at which it has
// contact, the verdict is at least amber, because the undercut removes a part of the path.
TEST(ArrangedRack, verdict_proposes_a_change_that_leaves_amber_findings) {
  for (const double more : {-7.0, 4.5}) {
    GivenPair given = given_rack(0.0);
    given.gear(1).cylindrical.teeth = 9;
    given.gear(1).cylindrical.tip_diameter = 22;
    given.pair.center_distance = 9 + more;
    const Verdict verdict = judge(taken(arrange(given)));
    const Finding& worst = verdict.findings.front();
    ASSERT_EQ(worst.code, WarningCode::no_contact);
    ASSERT_TRUE(worst.change.has_value());
    EXPECT_NE(worst.remedy.find("After this change, check: "), std::string::npos) << worst.remedy;
    ASSERT_TRUE(make_change(given, *worst.change));
    EXPECT_EQ(judge(taken(arrange(given))).level, Level::amber);
  }
}

// Every warning of a rack and its pinion has a verdict, in which remedies are tried.
TEST(ArrangedRack, verdict_covers_all_warnings) {
  std::set<WarningCode> judged;
  for (const int teeth : {9, 17, 22}) {
    for (const double longer : {0.0, 1.5}) {
      for (const double more : {-15.0, -7.0, -0.6, -0.1, 0.0, 0.3, 2.0, 5.0}) {
        GivenPair given = given_rack(0.0);
        given.gear(1).cylindrical.teeth = teeth;
        given.gear(1).cylindrical.tip_diameter = 2 * teeth + 4 + longer;
        if (teeth + more > 0.0) given.pair.center_distance = teeth + more;
        const Verdict verdict = judge(taken(arrange(given)));
        EXPECT_FALSE(verdict.headline.empty());
        for (const Finding& finding : verdict.findings) judged.insert(finding.code);
      }
    }
  }
  for (const WarningCode code :
       {WarningCode::no_contact, WarningCode::negative_backlash, WarningCode::root,
        WarningCode::contact_lost_to_undercut, WarningCode::base_tangent,
        WarningCode::contact_ratio, WarningCode::default_rack_body})
    EXPECT_TRUE(judged.contains(code)) << static_cast<int>(code);
}

// The thickest teeth within the tolerance leave no backlash, although the mean teeth have one.
TEST(ArrangedRack, verdict_covers_the_ends_of_the_tolerances) {
  GivenPair given = given_rack();
  given.gear(1).allowance_ends = Ends{-0.1, 0.05};
  given.gear(1).cylindrical.thickness_allowance = -0.025;
  const Arranged nominal = taken(arrange(given));
  EXPECT_GT(nominal.rack->normal_backlash(), 0.0);
  const Verdict verdict = judge(nominal);
  EXPECT_EQ(verdict.level, Level::red);
  EXPECT_FALSE(verdict.findings.front().at.empty());
}

TEST(GearAsRack, describes_the_same_teeth) {
  const Gear gear = taken(make_gear({.teeth = 20, .normal_module = 2, .face_width = 20}));
  const auto rack = taken(as_rack(gear, {{}, Angle::degrees(14.5)}));
  const Gear same = taken(make_gear({.teeth = 20,
                                     .normal_module = rack.normal_module,
                                     .normal_pressure_angle = Angle::degrees(14.5),
                                     .profile_shift = rack.profile_shift,
                                     .face_width = 20}));
  EXPECT_NEAR(same.reference().base_tooth_thickness, gear.reference().base_tooth_thickness, 1e-12);
  EXPECT_EQ(as_rack(gear, {1.0, {}}).error().field, "normal_module");
  EXPECT_EQ(as_rack(gear, {2.0, Angle::degrees(25)}).error().field, "rack");
}

}  // namespace
}  // namespace gearwright
