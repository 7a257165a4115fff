#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/report/report_sections.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "gearwright/report/report.hpp"
#include "gearwright/report/testing/sample_reports.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

using testing::StrictHtml;

Gear double_gear(int teeth, double beta_deg, double face_width = 60.0) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = teeth, .module = 4.0, .beta_deg = beta_deg, .face_width = face_width});
  s.rack = *gbt12759_rack(4.0);
  auto gear = make_gear(s);
  GW_EXPECTS(static_cast<bool>(gear));
  return std::move(gear).take();
}

ArcPair double_pair(double face_width = 60.0) {
  auto pair =
      mount_arcs(double_gear(18, 22, face_width), double_gear(50, -22, face_width), std::nullopt);
  GW_EXPECTS(static_cast<bool>(pair));
  return std::move(pair).take();
}

std::string page_of(const ArcPair& pair) {
  ReportInput input;
  input.gears = {&pair.gears[0], &pair.gears[1]};
  input.pair = pair;
  testing::judge(input, pair.warnings);
  return report_html(input);
}

TEST(ArcPairSection, page_is_sound_and_speaks_of_no_involute) {
  const std::string page = page_of(double_pair());
  const auto facts = StrictHtml::read(page);
  for (const std::string& fault : facts.faults) ADD_FAILURE() << fault;
  for (const char* word : {"involute", "Base helix", "Profile shift", "base pitch", "Addendum of",
                           "nan", "d</var><sub>b"}) {
    EXPECT_EQ(page.find(word), page.npos) << word;
  }
  for (const char* word : {"Circular-arc gear pair", "Contact on the convex flank of gear 1",
                           "Contact on the convex flank of gear 2", "Overlap ratio",
                           "Basic rack of arcs", "The pair runs with continuous contact"}) {
    EXPECT_NE(page.find(word), page.npos) << word;
  }
}

TEST(ArcPairSection, verdict_names_what_is_amiss) {
  const std::string page = page_of(double_pair(20.0));
  EXPECT_NE(page.find("does not run as specified: contact is not continuous"), page.npos);
}

// In the picture, the mark of the contact point lies on both flanks.
TEST(ArcPairSection, drawn_flanks_meet_in_the_mark) {
  using Complex = std::complex<double>;
  const ArcPair pair = double_pair();
  for (const ArcPairContact& c : pair.contacts) {
    const auto angles = angles_at_contact(pair, c);
    for (const std::size_t i : {0, 1}) {
      const Gear& gear = pair.gears[i];
      const Complex axis(i == 0 ? 0.0 : pair.center_distance, 0.0);
      const Complex at =
          (Complex(c.at.point.x(), c.at.point.y()) - axis) * std::polar(1.0, -angles[i]);
      double least = 1e9;
      for (const Arc& arc : gear.tooth->outline.arcs) {
        const auto* cut = curve_if<RackTrochoid>(*arc.curve);
        if (arc.name != ArcName::flank || !cut) continue;
        const Vec2 w = cut->point(c.at.theta.rad());
        for (int k = 0; k < gear.spec.teeth; ++k) {
          const Complex turn = std::polar(1.0, 2 * std::numbers::pi * k / gear.spec.teeth);
          least = std::min(least, std::abs(Complex(w.x(), -w.y()) * turn - at));
        }
      }
      EXPECT_NEAR(least, 0.0, 1e-11) << "gear " << i + 1;
    }
  }
}

}  // namespace
}  // namespace gearwright
