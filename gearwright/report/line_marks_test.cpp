#include "gearwright/report/line_marks.hpp"

#include <gtest/gtest.h>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/crossed_figures.hpp"

#include <string>

#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

std::string drawn(const CrossedPair& pair, Lines lines) {
  Figure f = plane_figure("x", "t", "d", {{-20, -20}, {20, 20}});
  add_lines_of_action(f, pair, in_plan, lines);
  return figure_svg(f, 400);
}

TEST(LineMarksPicture, BaseTangentsFarFromTheLineAreLeftOut) {
  EXPECT_EQ(line_ends(testing::crossed_pair()).size(), 5u);
  // A worm and a gear with 300 teeth. T_1 and T_2 are three and eight path lengths away from the
  // path.
  const CrossedPair worm = testing::crossed_sample_pair(testing::sample_gear(1, 2, 86, 0),
                                                        testing::sample_gear(300, 2, 4, 0), 90);
  EXPECT_EQ(line_ends(worm).size(), 4u);
}

TEST(LineMarksPicture, ThickWhereFlanksAndFacesAreUsed) {
  const auto thick = [](const std::string& text) {
    return text.find("class=\"action\"") != text.npos;
  };
  EXPECT_TRUE(thick(drawn(testing::crossed_pair(), Lines::both)));
  // On nearly parallel axes, the lines of action lie outside the faces.
  EXPECT_FALSE(thick(drawn(testing::nearly_parallel_pair(), Lines::both)));
  EXPECT_FALSE(thick(drawn(testing::crossed_apart(), Lines::both)));  // no contact
}

TEST(LineMarksPicture, LeadingLineAlone) {
  const CrossedPair pair = testing::crossed_pair();
  EXPECT_NE(drawn(pair, Lines::both).find("E′"), std::string::npos);
  EXPECT_EQ(drawn(pair, Lines::leading).find("E′"), std::string::npos);
}

}  // namespace
}  // namespace gearwright
