#include "gearwright/report/contact_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gearwright/base/units.hpp"
#include "gearwright/report/testing/sample_contact.hpp"

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

TEST(ErrorMapPicture, LevelsAreRoundAndWithinTheValues) {
  const auto levels = map_levels(bowl().map);  // 0 … 5.83
  EXPECT_EQ(levels, (std::vector<double>{1, 2, 3, 4, 5}));
  ContactMap flat = bowl();
  for (auto& row : flat.map.value)
    for (double& v : row) v = 1e-12;
  EXPECT_TRUE(map_levels(flat.map).empty());
}

TEST(ErrorMapPicture, ADotWhereTheSpecStandsIfItIsInside) {
  auto s = testing::helical_contact();
  s.report.map = bowl();
  EXPECT_EQ(map_figure(s.report).find("here-ring"), std::string::npos);  // y = 5 is outside
  EXPECT_NE(map_figure(s.report).find("axial &lt;place&gt;, mm"), std::string::npos);
  EXPECT_EQ(map_figure(s.report).find("no contact"), std::string::npos);
  s.report.map->axes[1].value = 1.0;
  s.report.map->map.value[0][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(map_figure(s.report).find("here-ring"), std::string::npos);
  EXPECT_NE(map_figure(s.report).find("no contact"), std::string::npos);
}

TEST(ErrorMapPicture, AMapWithoutAnyContactIsStillAPicture) {
  auto s = testing::helical_contact();
  s.report.map = bowl();
  for (auto& row : s.report.map->map.value)
    for (double& v : row) v = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(map_levels(s.report.map->map).empty());
  EXPECT_NE(map_figure(s.report).find("no contact"), std::string::npos);
}

}  // namespace
}  // namespace gearwright
