#include "gearwright/report/pair_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

TEST(PathFigures, LabelsTheStartOfContactOfAnUndercutFlank) {
  EXPECT_NE(figure_html(path_figure(testing::undercut_pair()), 640.0).find("(start) = "),
            std::string::npos);
  EXPECT_EQ(figure_html(path_figure(testing::helical_pair()), 640.0).find("(start) = "),
            std::string::npos);
}

// The specific sliding at the ends is −5.1 and −5.4, so the axis extends to −6.
TEST(PathFigures, ShowsTheWholeOfSteepCurves) {
  const std::string figure = figure_html(path_figure(testing::two_and_sixty()), 640.0);
  EXPECT_NE(figure.find(">−6<"), std::string::npos);
  EXPECT_NE(figure.find("mark g1"), std::string::npos);
  EXPECT_NE(figure.find("mark g2"), std::string::npos);
}

TEST(PathFigures, RulerHasTheLengthOfThePath) {
  const auto pair = testing::helical_pair();
  const Figure figure = path_figure(pair);
  const auto ruler = std::find_if(figure.lanes.begin(), figure.lanes.end(),
                                  [](const FigureLane& l) { return l.words == "base pitches"; });
  ASSERT_NE(ruler, figure.lanes.end());
  EXPECT_NEAR(ruler->blocks.front().from, pair.mesh.rho1_A - pair.mesh.rho1_C, 1e-12);
  EXPECT_NEAR(ruler->blocks.back().to, pair.mesh.rho1_E - pair.mesh.rho1_C, 1e-9);
  ASSERT_EQ(ruler->blocks.size(), 2u);
  EXPECT_EQ(ruler->blocks[0].words, "1");
  EXPECT_NEAR(1 + std::atof(ruler->blocks[1].words.c_str()), pair.mesh.path_ratio, 5e-4);
}

// Returns the x coordinate of the label with the text `words`, px, or −1 if there is no such label.
double label_x(const std::string& figure, const std::string& words) {
  const std::size_t text = figure.find(">" + words + "<");
  if (text == std::string::npos) return -1.0;
  return std::atof(figure.c_str() + figure.rfind("translate(", text) + 10);
}

// The line at 1 would cross the value of the bar ε_β = 0.824, so the value is moved to the right of
// the line.
TEST(RatioFigure, NoValueLiesAcrossTheLineAtOne) {
  const std::string figure = figure_html(ratio_figure(testing::helical_pair()), 420.0);
  EXPECT_EQ(label_x(figure, "0.824"), label_x(figure, "1"));
  EXPECT_GT(label_x(figure, "1.453"), label_x(figure, "1"));
}

// If the total contact ratio is great, the axis has ticks only at multiples of five and at 1, where
// there is also a line.
TEST(RatioFigure, ManyPairsInContact) {
  const std::string figure =
      figure_html(ratio_figure(testing::two_and_sixty(150.0)), 420.0);  // ε_γ 14.3
  EXPECT_NE(figure.find("class=\"one\""), std::string::npos);
  EXPECT_GT(label_x(figure, "1"), label_x(figure, "0") + 8.0);
  EXPECT_GT(label_x(figure, "10"), label_x(figure, "5") + 25.0);
}

}  // namespace
}  // namespace gearwright
