#include "gearwright/figure/contact_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gearwright/base/units.hpp"
#include "gearwright/figure/figure_svg.hpp"

namespace gearwright {
namespace {

ContactMap bowl() {
  ContactMap m{{}, {{{"out-of-plane shaft deviation", 0.0, "°"}, {"axial <place>", 5.0, "mm"}}}};
  for (int i = 0; i < 11; ++i) m.map.x.push_back(-0.1 + 0.02 * i);
  for (int k = 0; k < 7; ++k) m.map.y.push_back(-3.0 + k);
  for (int k = 0; k < 7; ++k) {
    m.map.value.emplace_back();
    for (int i = 0; i < 11; ++i)
      m.map.value.back().push_back((std::hypot(i - 5.0, k - 3.0)) / kArcsecPerRad);
  }
  return m;
}

TEST(ErrorMapFigure, LevelsAreRoundAndWithinTheValues) {
  const auto levels = map_levels(bowl().map);  // 0 … 5.83
  EXPECT_EQ(levels, (std::vector<double>{1, 2, 3, 4, 5}));
  ContactMap flat = bowl();
  for (auto& row : flat.map.value)
    for (double& v : row) v = 1e-12;
  EXPECT_TRUE(map_levels(flat.map).empty());
}

TEST(ErrorMapFigure, ADotWhereTheSpecStandsIfItIsInside) {
  ContactMap map = bowl();
  EXPECT_EQ(figure_html(error_map_figure(map)).find("here-ring"),
            std::string::npos);  // y = 5 is outside
  EXPECT_NE(figure_html(error_map_figure(map)).find("axial &lt;place&gt;, mm"), std::string::npos);
  EXPECT_EQ(figure_html(error_map_figure(map)).find("no contact"), std::string::npos);
  map.axes[1].value = 1.0;
  map.map.value[0][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(figure_html(error_map_figure(map)).find("here-ring"), std::string::npos);
  EXPECT_NE(figure_html(error_map_figure(map)).find("no contact"), std::string::npos);
}

TEST(ErrorMapFigure, AMapWithoutAnyContactIsStillAPicture) {
  ContactMap map = bowl();
  for (auto& row : map.map.value)
    for (double& v : row) v = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(map_levels(map.map).empty());
  EXPECT_NE(figure_html(error_map_figure(map)).find("no contact"), std::string::npos);
}

}  // namespace
}  // namespace gearwright
