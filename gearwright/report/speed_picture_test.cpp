#include "gearwright/report/crossed_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

// If the pitch planes of both gears coincide (X = 0), the path of contact passes through the common
// pitch point. There the flanks slide only along the teeth, at the speed r_w1 ω_1 sin β_1 + r_w2
// ω_2 sin β_2.
TEST(SpeedPicture, AtThePitchPointTheScrewsSlideAlongTheTeeth) {
  const CrossedPair pair = testing::crossed_sample_pair(testing::sample_gear(20, 2, 45, 0.2),
                                                        testing::sample_gear(30, 2, 40, -0.2), 85);
  ASSERT_NEAR(pair.mesh.pitch_plane_distance, 0.0, 1e-9);
  const auto& sides = pair.mesh.rack.sides;
  const double along = sides[0].pitch_radius * std::sin(sides[0].helix_angle) +
                       sides[1].pitch_radius * std::sin(sides[1].helix_angle) * 20 / 30;
  const std::string text = speed_table(pair);
  const std::size_t at = text.find("<strong>C</strong>");
  ASSERT_NE(at, text.npos);
  const std::string row = text.substr(at, text.find("</tr>", at) - at);
  EXPECT_NE(row.find(">" + fixed(along, kRatioDigits) + "<"), row.npos) << row;
}

TEST(SpeedPicture, ThreeCurves) {
  const std::string text = figure_html(speed_figure(testing::crossed_pair()));
  for (const char* style :
       {"\"curve ink\"", "\"curve action-curve\"", "\"curve trailing-curve dash\""})
    EXPECT_NE(text.find(style), text.npos) << style;
}

}  // namespace
}  // namespace gearwright
