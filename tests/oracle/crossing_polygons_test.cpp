// Polygons have a common area exactly if their edges cross. The reference is TurnedPolygons, which
// uses neither chords nor sags.
#include "tests/oracle/crossing_polygons.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "tests/oracle/numbers.hpp"

namespace gearwright::oracle {
namespace {

// Teeth of module 1 with flanks bent by `bulge`, mm, reduced to `width` of half a pitch.
ToothedPolygon made_up(int teeth, double width, double bulge) {
  const int z = std::abs(teeth);
  const double side = teeth < 0 ? -1.0 : 1.0;
  const double gamma = kPi / z;
  ToothedPolygon polygon{teeth, {}};
  const auto at = [&](double r, double angle) {
    polygon.half_tooth.emplace_back(r * std::cos(angle), r * std::sin(angle));
  };
  const double r = z / 2.0;
  for (int i = 0; i < 8; ++i) at(r - 1.25 * side, gamma * (1.0 - i / 20.0));
  for (int i = 0; i <= 60; ++i) {
    const double h = -1.25 + 2.25 * i / 60.0;
    const double bent = bulge * (1.0 - std::pow((h + 0.1) / 1.2, 2));
    at(r + side * h, (kPi / 4 * width - 0.36 * h + bent) / r);
  }
  for (int i = 1; i <= 6; ++i)
    at(r + side,
       (kPi / 4 * width - 0.36 + bulge * (1.0 - std::pow(1.1 / 1.2, 2))) / r * (1 - i / 6.0));
  return polygon;
}

TEST(CrossingPolygonsOracle, begin_to_cross_where_they_begin_to_share_an_area) {
  int found = 0;
  for (const auto& [z_1, z_2] : {std::pair{12, 31}, {20, 20}, {17, -40}, {23, -29}}) {
    for (const double bulge : {0.0, 0.05}) {
      const auto one = made_up(z_1, 0.6, bulge);
      const auto two = made_up(z_2, 0.6, z_2 < 0 ? -bulge : bulge);
      const double a = std::abs(z_1 + z_2) / 2.0;
      const CrossingPolygons edges(one, two, a);
      const TurnedPolygons areas(one, two, a, 4000);
      ASSERT_EQ(edges.in_reach(), areas.in_reach());
      for (int i = 0; i < 12; ++i) {
        const double phi = 2 * kPi / z_1 * i / 12.0;
        if (edges.cross(phi, 0.0)) continue;
        EXPECT_EQ(areas.shared_area(phi, 0.0), 0.0);
        // Half a pitch further, teeth overlap teeth.
        double free = 0.0, crossed = kPi / std::abs(z_2);
        ASSERT_TRUE(edges.cross(phi, crossed));
        while (crossed - free > 1e-12) {
          const double middle = (free + crossed) / 2.0;
          (edges.cross(phi, middle) ? crossed : free) = middle;
        }
        ++found;
        EXPECT_EQ(areas.shared_area(phi, free), 0.0) << z_1 << ":" << z_2 << " " << phi;
        EXPECT_GT(areas.shared_area(phi, crossed + 2e-3), 0.0) << z_1 << ":" << z_2 << " " << phi;
      }
    }
  }
  EXPECT_GT(found, 60);
}

}  // namespace
}  // namespace gearwright::oracle
