#include "gearwright/report/verdict.hpp"

#include <gtest/gtest.h>

#include <string>

#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

using testing::crossed_pair;
using testing::helical_pair;
using testing::report_input;
using testing::sample_gear;
using testing::sample_pair;
using testing::undercut_pair;

TEST(Verdict, FollowsTheFacts) {
  const InvolutePair good = helical_pair();
  EXPECT_NE(verdict(report_input(good)).find("The pair runs"), std::string::npos);
  const InvolutePair tight = sample_pair(sample_gear(20, 2, 0, 0), sample_gear(40, 2, 0, 0), 59.9);
  ASSERT_LT(tight.mesh.backlash.normal, 0.0);
  EXPECT_NE(verdict(report_input(tight)).find("too thick"), std::string::npos);
  const InvolutePair loose = sample_pair(sample_gear(20, 2, 0, 0), sample_gear(40, 2, 0, 0), 62.5);
  ASSERT_LT(loose.contact_ratio_true(), 1.0);
  EXPECT_NE(verdict(report_input(loose)).find("not continuous"), std::string::npos);
}

TEST(Verdict, OfPairsThatRunOnlyAsHelicalGears) {
  // ε_α = 0.6858, so that (1 − ε_α) p_bt/tan β_b = 3.4548 mm: rounded up.
  const InvolutePair wide = testing::two_and_sixty();
  EXPECT_EQ(face_width_needed(wide), 3.46);
  const std::string words = verdict(report_input(wide));
  EXPECT_NE(words.find("runs only as a helical gear pair: transverse contact ratio 0.686"),
            std::string::npos)
      << words;
  EXPECT_NE(words.find("it needs b ≥ 3.46 mm. There is no backlash and no interference."),
            std::string::npos)
      << words;
  EXPECT_EQ(severity_of({"transverse_contact_ratio", "", 0}), Severity::note);

  // At the width itself contact never stops, a hundredth below it does.
  EXPECT_GE(testing::two_and_sixty(3.46).contact_ratio_true(), 1.0);
  const InvolutePair narrow = testing::two_and_sixty(3.45);
  ASSERT_LT(narrow.contact_ratio_true(), 1.0);
  const std::string too_narrow = verdict(report_input(narrow));
  EXPECT_NE(too_narrow.find("does not run as specified: contact is not continuous."),
            std::string::npos)
      << too_narrow;
  EXPECT_NE(too_narrow.find("from b ≥ 3.46 mm on"), std::string::npos) << too_narrow;

  EXPECT_FALSE(face_width_needed(helical_pair()));
  EXPECT_FALSE(face_width_needed(undercut_pair()));  // spur: no width helps
  EXPECT_FALSE(face_width_needed(crossed_pair()));
}

TEST(Verdict, SeverityLooksAtTheGearThatIsMeant) {
  const auto severity = [](const InvolutePair& pair, const std::string& code) {
    const ReportInput input = report_input(pair);
    for (const Warning& w : input.warnings) {
      if (w.code == code) return severity_of(w);
    }
    ADD_FAILURE() << "no warning " << code;
    return Severity::note;
  };
  // Gear 1 is undercut and loses contact there; an internal gear's tip below the pinion's base is
  // in the way.
  EXPECT_EQ(severity(undercut_pair(), "contact_lost"), Severity::caution);
  const InvolutePair internal =
      sample_pair(sample_gear(18, 2, 0, 0.2), sample_gear(-60, 2, 0, 0.1), 41.8);
  EXPECT_EQ(severity(internal, "base_tangent"), Severity::problem);
  EXPECT_EQ(severity_of({"unheard_of", "", 0}), Severity::caution);
  const InvolutePair askew = testing::nearly_parallel_pair();
  EXPECT_EQ(severity(askew, "nearly_parallel"), Severity::caution);
  EXPECT_EQ(severity(askew, "face_width"), Severity::caution);
  EXPECT_EQ(severity(askew, "no_contact"), Severity::problem);
  EXPECT_EQ(severity(testing::worm_pair(), "self_locking"), Severity::note);
}

}  // namespace
}  // namespace gearwright
