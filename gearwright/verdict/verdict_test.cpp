#include "gearwright/verdict/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/drive.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

using testing::helical_pair;
using testing::report_input;
using testing::sample_gear;
using testing::sample_pair;
using testing::undercut_pair;

TEST(Verdict, FollowsTheFacts) {
  const ParallelPair good = helical_pair();
  EXPECT_NE(report_input(good).verdict.headline.find("The pair runs"), std::string::npos);
  const ParallelPair tight = sample_pair(sample_gear(20, 2, 0, 0), sample_gear(40, 2, 0, 0), 59.9);
  ASSERT_LT(tight.mesh.backlash.normal, 0.0);
  EXPECT_NE(report_input(tight).verdict.headline.find("too thick"), std::string::npos);
  const ParallelPair loose = sample_pair(sample_gear(20, 2, 0, 0), sample_gear(40, 2, 0, 0), 62.5);
  ASSERT_LT(loose.contact_ratio_true(), 1.0);
  EXPECT_NE(report_input(loose).verdict.headline.find("not continuous"), std::string::npos);
}

TEST(Verdict, OfPairsThatRunOnlyAsHelicalGears) {
  // ε_α = 0.6858, so (1 − ε_α) p_bt/tan β_b = 3.4548 mm, which is rounded up.
  const ParallelPair wide = testing::two_and_sixty();
  EXPECT_EQ(face_width_needed(wide), 3.46);
  const std::string words = report_input(wide).verdict.headline;
  EXPECT_NE(words.find("only because its teeth are helical. The transverse contact ratio is 0.686"),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("needs a face width b ≥ 3.46 mm. There is no backlash (ISO/TR 10064-2 "
                       "recommends at least"),
            std::string::npos)
      << words;
  EXPECT_EQ(severity_of({WarningCode::transverse_contact_ratio, "", 0}), Severity::note);

  // Contact is continuous at this width, but not at a width that is 0.01 mm smaller.
  EXPECT_GE(testing::two_and_sixty(3.46).contact_ratio_true(), 1.0);
  const ParallelPair narrow = testing::two_and_sixty(3.45);
  ASSERT_LT(narrow.contact_ratio_true(), 1.0);
  const std::string too_narrow = report_input(narrow).verdict.headline;
  EXPECT_NE(too_narrow.find("does not run as specified: contact is not continuous."),
            std::string::npos)
      << too_narrow;
  EXPECT_NE(too_narrow.find("only for helical gears with b ≥ 3.46 mm"), std::string::npos)
      << too_narrow;

  EXPECT_FALSE(face_width_needed(helical_pair()));
  EXPECT_FALSE(face_width_needed(undercut_pair()));  // no face width makes the contact of a spur
                                                     // pair continuous
}

TEST(Verdict, SeverityLooksAtTheGearThatIsMeant) {
  const auto severity = [](const MountedGears& pair, WarningCode code) {
    for (const Warning& w : testing::warnings_of(pair)) {
      if (w.code == code) return severity_of(w);
    }
    ADD_FAILURE() << "no warning " << to_string(code);
    return Severity::note;
  };
  // Gear 1 is undercut, which removes part of its path of contact. The tip of the internal gear
  // extends below the base circle of the pinion and causes interference.
  EXPECT_EQ(severity(undercut_pair(), WarningCode::contact_lost_to_undercut), Severity::caution);
  const ParallelPair internal =
      sample_pair(sample_gear(18, 2, 0, 0.2), sample_gear(-60, 2, 0, 0.1), 41.8);
  EXPECT_EQ(severity(internal, WarningCode::base_tangent), Severity::problem);
  const CrossedPair askew = testing::nearly_parallel_pair();
  EXPECT_EQ(severity(askew, WarningCode::nearly_parallel), Severity::caution);
  EXPECT_EQ(severity(askew, WarningCode::face_width), Severity::caution);
  EXPECT_EQ(severity(askew, WarningCode::no_contact), Severity::problem);
  EXPECT_EQ(severity(testing::worm_pair(), WarningCode::self_locking), Severity::note);
}

Verdict judged(const ParallelPair& pair) { return report_input(pair).verdict; }

bool finds(const Verdict& verdict, WarningCode code, Level level) {
  return std::any_of(verdict.findings.begin(), verdict.findings.end(),
                     [&](const Finding& f) { return f.code == code && f.level == level; });
}

TEST(Verdict, level_is_that_of_the_worst_finding) {
  EXPECT_EQ(judged(helical_pair()).level, Level::green);
  const Verdict amber =
      judged(sample_pair(sample_gear(16, 2, 0, 0), sample_gear(40, 2, 0, 0), 56.1));
  EXPECT_EQ(amber.level, Level::amber);
  EXPECT_EQ(amber.findings.front().level, Level::amber);
  const ParallelPair tight = sample_pair(sample_gear(20, 2, 0, 0), sample_gear(40, 2, 0, 0), 59.9);
  const Verdict red = judged(tight);
  EXPECT_EQ(red.level, Level::red);
  EXPECT_EQ(red.findings.front().code, WarningCode::negative_backlash);
  EXPECT_TRUE(red.findings.front().remedy.empty());  // no function was given to try changes
  for (std::size_t i = 1; i < red.findings.size(); ++i)
    EXPECT_LE(red.findings[i].level, red.findings[i - 1].level);
}

TEST(Verdict, small_clearances_are_said_with_their_thresholds) {
  const double m = 2.0;
  for (double x = -0.1; x < 0.2; x += 0.001) {
    const ParallelPair pair = testing::taken(
        mount_as<ParallelPair>(sample_gear(19, m, 0, x), sample_gear(40, m, 0, 0.0), {}));
    const Verdict verdict = judged(pair);
    const double form = pair.form_clearance[0].value_or(-1.0);
    EXPECT_EQ(finds(verdict, WarningCode::form_margin, Level::amber),
              !pair.gears[0].undercut && form >= 0.0 && form < kMarginForm * m)
        << x;
    const double fillet = pair.fillet_clearance[0].value_or(-1.0);
    EXPECT_EQ(finds(verdict, WarningCode::fillet_margin, Level::amber),
              fillet >= 0.0 && fillet < kMarginFillet * m)
        << x;
  }
  CylindricalSpec longer = sample_gear(40, m, 0, 0).spec;
  longer.tip_diameter = 84.0 + 2 * 0.35;
  const ParallelPair close =
      sample_pair(sample_gear(30, m, 0, 0), testing::taken(make_gear(longer)), 70.0);
  const Verdict verdict = judged(close);
  ASSERT_TRUE(finds(verdict, WarningCode::tip_margin, Level::amber));
  for (const Finding& f : verdict.findings) {
    if (f.code != WarningCode::tip_margin) continue;
    EXPECT_EQ(f.gear, 2);
    EXPECT_NEAR(f.values[0].value, 0.15, 1e-12);
    EXPECT_NEAR(f.values[1].value, kMarginTip * m, 1e-12);
    EXPECT_NE(f.message.find("0.1500 mm, which is less than 0.1 modules (0.2000 mm)"),
              std::string::npos)
        << f.message;
  }
}

// Nominal teeth without allowances have no backlash. This is a note, because books compute gears in
// this way, and the level stays green. j_bn = 2/3 (0.06 + 0.0005·61 + 0.03·2) = 0.10033 mm, and
// j_n = j_bn/cos 20° = 0.10677 mm is rounded up.
TEST(Verdict, no_backlash_is_a_note) {
  const auto mounted_with = [](double allowance) {
    return judged(testing::taken(mount_as<ParallelPair>(sample_gear(20, 2, 0, 0.2, 0.0, allowance),
                                                        sample_gear(41, 2, 0, -0.2), {})));
  };
  const Verdict none = mounted_with(0.0);
  EXPECT_EQ(none.level, Level::green);
  ASSERT_TRUE(finds(none, WarningCode::no_backlash, Level::green));
  const auto found = std::find_if(none.findings.begin(), none.findings.end(), [](const Finding& f) {
    return f.code == WarningCode::no_backlash;
  });
  EXPECT_EQ(found->message, "There is no backlash; ISO/TR 10064-2 recommends at least 0.107 mm.");
  EXPECT_NEAR(found->values[1].value, 0.30100 / 3 / std::cos(std::numbers::pi / 9), 1e-12);
  EXPECT_FALSE(found->remedy.empty());
  // Profile shifts with four decimals determine the backlash to 1e-4 m_n.
  EXPECT_TRUE(finds(mounted_with(-1.9e-4), WarningCode::no_backlash, Level::green));
  EXPECT_FALSE(finds(mounted_with(-2.2e-4), WarningCode::no_backlash, Level::green));
  EXPECT_TRUE(judged(helical_pair()).findings.empty());
}

// The recommended backlash is 0.10677 mm, as in the previous test. A quarter of it is 0.02669 mm.
// An allowance E_sn of gear 1 gives the backlash j_n = -E_sn at the pitch point of zero sum of shifts.
TEST(Verdict, little_backlash_is_a_note) {
  const auto mounted_with = [](double allowance) {
    return judged(testing::taken(mount_as<ParallelPair>(sample_gear(20, 2, 0, 0.2, 0.0, allowance),
                                                        sample_gear(41, 2, 0, -0.2), {})));
  };
  const Verdict little = mounted_with(-0.0266);
  EXPECT_EQ(little.level, Level::green);
  EXPECT_TRUE(finds(little, WarningCode::little_backlash, Level::green));
  EXPECT_FALSE(finds(little, WarningCode::no_backlash, Level::green));
  EXPECT_NE(little.headline.find("0.0266 mm in the normal section (ISO/TR 10064-2 recommends at "
                                 "least 0.107 mm)"),
            std::string::npos)
      << little.headline;
  EXPECT_TRUE(mounted_with(-0.0268).findings.empty());
}

// Published pairs: gears FZG C, and the second planetary stage of a wind turbine of 5 MW. With
// shifts of four decimals, their nominal backlash is −0.06 µm and −0.44 µm.
TEST(Verdict, published_pairs_with_rounded_shifts_run) {
  const auto level = [](const Gear& pinion, const Gear& wheel, double a) {
    return judged(testing::taken(mount_as<ParallelPair>(pinion, wheel, {.center_distance = a})))
        .level;
  };
  EXPECT_EQ(level(sample_gear(16, 4.5, 0, 0.1817), sample_gear(24, 4.5, 0, 0.1715), 91.5),
            Level::green);
  EXPECT_NE(level(sample_gear(18, 21, 0, 0.3890), sample_gear(36, 21, 0, 0.5039), 584), Level::red);
}

TEST(Verdict, of_a_rack_gives_its_backlash) {
  const auto judged_at = [](double more) {
    const Gear pinion = sample_gear(20, 2, 0, 0.2);
    const RackPair rack = testing::taken(mount_rack(pinion, {}, 20.4 + more));
    return verdict_of({.gears = {&rack.pinion}, .rack = &rack, .warnings = &rack.warnings});
  };
  // j_bn = 2/3 (0.06 + 0.0005 · 20.4 + 0.03 · 2) = 0.0868 mm, j_n = j_bn/cos 20° = 0.0924 mm
  EXPECT_EQ(judged_at(0.0).headline,
            "The rack and pinion run as specified, with no backlash (ISO/TR 10064-2 recommends at "
            "least 0.093 mm).");
  EXPECT_TRUE(finds(judged_at(0.0), WarningCode::no_backlash, Level::green));
  // j_n = 2 δ tan α_n = 0.0728 mm
  EXPECT_EQ(judged_at(0.1).headline,
            "The rack and pinion run as specified, with a backlash of 0.0728 mm in the "
            "normal section.");
  EXPECT_FALSE(finds(judged_at(0.1), WarningCode::no_backlash, Level::green));
  EXPECT_NE(judged_at(-0.1).headline.find(
                "The rack and pinion do not run as specified: the teeth are too thick"),
            std::string::npos);
}

TEST(Verdict, OfARackThatNeedsTheOverlapOfHelicalTeeth) {
  const Gear pinion = sample_gear(8, 2, 25, 0);
  const RackPair rack = testing::taken(mount_rack(pinion, {}));
  ASSERT_LT(rack.true_contact_ratio(), 1.0);
  const Verdict v =
      verdict_of({.gears = {&rack.pinion}, .rack = &rack, .warnings = &rack.warnings});
  EXPECT_EQ(v.headline.find("The rack and pinion run only with helical teeth, because the "
                            "transverse contact ratio is 0.9"),
            0u)
      << v.headline;
}

// A centre distance that is rounded to four decimals changes j_n by at most 2 · 0.5e-4 tan α_n =
// 3.6e-5 mm, so pairs and racks at this distance are green. A distance that is smaller by 5e-4 mm
// is red. The headline never contains "0.0000 mm".
TEST(Verdict, a_rounded_centre_distance_is_no_negative_backlash) {
  const Gear pinion = sample_gear(20, 2, 0, 0.2, 0.0, -0.05), wheel = sample_gear(41, 2, 0, 0.1);
  const double a =
      *testing::taken(mount_as<ParallelPair>(pinion, wheel, {})).backlash_free_center_distance;
  const double h = testing::taken(mount_rack(pinion, {})).backlash_free_center_distance;
  for (const double change : {-5e-4, -1e-4, -0.5e-4, -4e-7, 0.0, 0.5e-4, 1e-4, 5e-4}) {
    const ParallelPair pair =
        testing::taken(mount_as<ParallelPair>(pinion, wheel, {.center_distance = a + change}));
    const RackPair rack = testing::taken(mount_rack(pinion, {}, h + change));
    const auto expect = [&](const Verdict& verdict, double j) {
      const double limit = no_backlash(2);
      EXPECT_EQ(finds(verdict, WarningCode::negative_backlash, Level::red), j <= -limit) << j;
      EXPECT_EQ(finds(verdict, WarningCode::no_backlash, Level::green), std::abs(j) < limit);
      EXPECT_EQ(verdict.headline.find("0.0000 mm"), std::string::npos) << verdict.headline;
      EXPECT_EQ(std::abs(j) < limit, std::abs(change) < 5e-4) << change;
    };
    expect(judged(pair), pair.normal_backlash());
    expect(verdict_of({.gears = {&rack.pinion}, .rack = &rack, .warnings = &rack.warnings}),
           rack.normal_backlash());
  }
}

// A clearance of nanometres is not printed as 0.0000 mm, and a rounding error not as 1e-05 µm.
TEST(Verdict, says_small_clearances_in_micrometres) {
  const auto finds_text = [](double clearance, const std::string& text) {
    ParallelPair pair = helical_pair();
    pair.fillet_clearance[0] = clearance;
    const Verdict verdict = judged(pair);
    return std::any_of(verdict.findings.begin(), verdict.findings.end(), [&](const Finding& f) {
      return f.message.find(text + ", which is less than 0.0001 modules (0.25 µm)") !=
             std::string::npos;
    });
  };
  EXPECT_TRUE(finds_text(21e-6, "is 0.021 µm"));
  EXPECT_TRUE(finds_text(1e-6, "is 0.001 µm"));
  EXPECT_TRUE(finds_text(1e-8, "is less than 0.001 µm"));
  EXPECT_TRUE(finds_text(0.0, "is less than 0.001 µm"));
}

// For teeth with circular arcs, the finding states by how much the outlines meet before the flanks
// meet.
TEST(Verdict, early_contact_has_its_amount) {
  int early = 0;
  for (double longer = 0.0; longer < 4.0; longer += 0.1) {
    const auto gear = [&](int teeth, ArcRack::Cutter cutter) {
      CylindricalSpec s = testing::plain_spec({.teeth = teeth,
                                               .module = 4.0,
                                               .beta_deg = teeth > 20 ? -15.0 : 15.0,
                                               .face_width = 60.0});
      const double l = cutter == ArcRack::Cutter::F ? 0.487786 : 0.637786;  // θ = 30°
      ArcRack rack = default_arc_rack(cutter);
      rack.arc_radius = cutter == ArcRack::Cutter::F ? 1.4 : 1.55;
      rack.center_a = l * std::cos(std::numbers::pi / 6);
      rack.center_b = l * std::sin(std::numbers::pi / 6);
      s.rack = rack;
      s.thickness_allowance = -0.3;
      if (teeth < 20) s.tip_diameter = testing::made(s).tip_diameter + longer;
      return testing::made(s);
    };
    const Pair pair =
        testing::taken(mount(gear(12, ArcRack::Cutter::F), gear(40, ArcRack::Cutter::P)));
    Judged input;
    input.gears = {&pair.gear(1), &pair.gear(2)};
    input.pair = &pair;
    input.warnings = &pair.warnings();
    for (const Finding& f : findings_of(input)) {
      if (f.code != WarningCode::beyond_flank) continue;
      ++early;
      ASSERT_EQ(f.values.size(), 1u);
      EXPECT_EQ(f.values[0].name, "early");
      EXPECT_LT(f.values[0].value, 0.0);
      const auto& all = pair.mounted().beyond_flank;
      const auto own = std::find_if(all.begin(), all.end(),
                                    [&](const auto& contact) { return contact.gear == f.gear; });
      ASSERT_NE(own, all.end());
      EXPECT_EQ(f.values[0].value, -own->depth);
    }
  }
  EXPECT_GT(early, 0);
}

TEST(Verdict, edges_and_places_under_errors) {
  const ParallelPair involutes = helical_pair();
  const Pair pair(involutes);
  const std::vector<Warning> none, jams{{WarningCode::jam, "They jam.", 0}};
  ContactResult contact;
  contact.positions.resize(4);
  for (ContactPoint& p : contact.positions) p.kind = TouchKind::interior;
  const auto judged_with = [&](const std::vector<Warning>& warnings) {
    return verdict_of({.gears = {&involutes.gears[0], &involutes.gears[1]},
                       .pair = &pair,
                       .warnings = &warnings,
                       .contact = &contact});
  };
  EXPECT_FALSE(finds(judged_with(none), WarningCode::edge_contact, Level::amber));
  contact.positions[1].kind = TouchKind::tip2;
  const Verdict edge = judged_with(none);
  ASSERT_TRUE(finds(edge, WarningCode::edge_contact, Level::amber));
  EXPECT_EQ(edge.level, Level::amber);
  EXPECT_EQ(edge.findings.front().code, WarningCode::edge_contact);
  EXPECT_EQ(edge.findings.front().values[0].value, 0.25);
  EXPECT_EQ(judged_with(jams).level, Level::red);
  EXPECT_NE(judged_with(jams).headline.find("the gears jam"), std::string::npos);
  for (ContactPoint& p : contact.positions) {
    p.kind = TouchKind::interior;
    p.height[0] = -0.8 * involutes.gears[0].spec.face_width / 2;
  }
  EXPECT_TRUE(finds(judged_with(none), WarningCode::contact_place, Level::amber));
  // The contact is near the end of the face of gear 2 only.
  for (ContactPoint& p : contact.positions) {
    p.height[0] = -0.6 * involutes.gears[0].spec.face_width / 2;
    p.height[1] = 0.8 * involutes.gears[1].spec.face_width / 2;
  }
  EXPECT_TRUE(finds(judged_with(none), WarningCode::contact_place, Level::amber));
  for (ContactPoint& p : contact.positions) p.height = {};
  EXPECT_FALSE(finds(judged_with(none), WarningCode::contact_place, Level::amber));
  EXPECT_EQ(meaning_of(WarningCode::contact_lost).severity, Severity::problem);
}

}  // namespace
}  // namespace gearwright
