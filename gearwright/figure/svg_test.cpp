#include "gearwright/figure/svg.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {
namespace {

TEST(Spread, LeavesWhatHasRoom) {
  const std::vector<double> wanted{10.0, 50.0, 30.0};
  EXPECT_EQ(spread(wanted, 15.0, 0.0, 100.0), wanted);
}

TEST(Spread, PushesEvenlyApart) {
  const auto placed = spread({50.0, 50.0}, 10.0, 0.0, 100.0);
  EXPECT_DOUBLE_EQ(placed[0], 45.0);
  EXPECT_DOUBLE_EQ(placed[1], 55.0);
}

TEST(Spread, KeepsGapOrderAndBounds) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    std::vector<double> wanted(1 + random() % 8);
    for (double& w : wanted) w = static_cast<double>(random() % 1400) / 10.0 - 20.0;
    const auto placed = spread(wanted, 13.0, 0.0, 100.0);
    const double gap =
        std::min(13.0, wanted.size() > 1 ? 100.0 / static_cast<double>(wanted.size() - 1) : 13.0);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_GE(placed[i], -1e-9);
      EXPECT_LE(placed[i], 100.0 + 1e-9);
      for (std::size_t j = 0; j < wanted.size(); ++j) {
        if (wanted[i] < wanted[j]) {
          EXPECT_LE(placed[i] + gap, placed[j] + 1e-9);
        }
      }
    }
  }
}

TEST(FigureSvg, long_words_of_an_axis_stay_in_the_picture) {
  // The middle of the words, px. On a narrow screen a letter is up to 7.6 px wide.
  const auto middle = [](const std::string& words) {
    Figure f{"f", "", "", "", {words, ""}, {"y", ""}};
    const std::string svg = figure_svg(f, 330);
    const std::size_t begin = svg.rfind("translate(", svg.find(">" + words + "<")) + 10;
    return std::stod(svg.substr(begin));
  };
  const std::string words = "rotation of the tooth pair from the centre";
  const double half = 7.6 * static_cast<double>(words.size()) / 2;
  EXPECT_GT(middle("x"), 165.0);  // below the middle of the plot
  EXPECT_LE(middle(words) + half, 330.0);
  EXPECT_GE(middle(words) - half, 0.0);
  EXPECT_EQ(middle(words + words), 165.0);  // no room at any position
}

TEST(HtmlText, Numbers) {
  EXPECT_EQ(fixed(-0.00001, 4), "0.0000");
  EXPECT_EQ(fixed(-0.00006, 4), "-0.0001");
  EXPECT_EQ(fixed(43.99923, 4), "43.9992");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 4), "–");
  EXPECT_EQ(fixed(-std::numeric_limits<double>::infinity(), 4), "–");
  EXPECT_EQ(fixed(std::optional<double>(), 4), "–");
  EXPECT_EQ(pixel(12.0), "12");
  EXPECT_EQ(pixel(-0.001), "0");
  EXPECT_EQ(pixel(100.5), "100.5");
}

TEST(HtmlText, Symbols) {
  EXPECT_EQ(symbol_html("d_Ff"), "<var>d</var><sub>Ff</sub>");
  EXPECT_EQ(symbol_html("h_aP*"), "<var>h</var><sub>aP</sub><sup>*</sup>");
  EXPECT_EQ(symbol_html("ε_α"), "<var>ε</var><sub>α</sub>");
  EXPECT_EQ(symbol_html("ε_α,eff"), "<var>ε</var><sub>α,eff</sub>");
  EXPECT_EQ(symbol_html("k_1, k_2"), "<var>k</var><sub>1</sub><var>, k</var><sub>2</sub>");
  EXPECT_EQ(with_symbols("F_βy < 1, a"), "<var>F</var><sub>βy</sub> &lt; 1, a");
  EXPECT_EQ(with_symbols("no face_width_mm; cut_by, _x, d_"), "no face_width_mm; cut_by, _x, d_");
  EXPECT_EQ(symbol_html("k m_n"), "<var>k m</var><sub>n</sub>");
  EXPECT_NE(symbol_svg("d_b").find("dy=\"3\">b</tspan><tspan dy=\"-3\">"), std::string::npos);
}

TEST(HtmlText, Escapes) {
  EXPECT_EQ(escaped("<a href=\"x\">'&'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(escaped(std::string("a\0b\r\n", 5)),
            "a\xEF\xBF\xBD"
            "b\n");
  EXPECT_EQ(file_link("out dir/gear1.step"), "./out%20dir/gear1.step");
  EXPECT_EQ(file_link("javascript:x"), "./javascript%3Ax");
}

TEST(Svg, ADotMayTellWhatItIs) {
  Svg svg("x", 10, 10, "t", "d");
  svg.dot({1, 2}, 3, "mark", "a < b");
  svg.dot({4, 5}, 3, "mark");
  EXPECT_NE(svg.str().find("<title>a &lt; b</title><circle class=\"mark\" r=\"3\"/>"),
            std::string::npos);
  EXPECT_EQ(svg.str().find("<title>", svg.str().find("</title><circle") + 1), std::string::npos);
}

}  // namespace
}  // namespace gearwright
