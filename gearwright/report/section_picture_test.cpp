#include "gearwright/report/crossed_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

// Returns (h/half width)² + (x/half height)² relative to the centre, which is 1 on the ellipse.
double level(const SectionEllipse& e, const Vec2& p) {
  return std::pow((p.x() - e.center.x()) / e.half_width, 2) +
         std::pow((p.y() - e.center.y()) / e.half_height, 2);
}

TEST(SectionPicture, LineOfActionAtItsTrueLengthAndAngle) {
  for (const CrossedPair& pair : testing::crossed_pairs()) {
    const Mesh<double>& m = pair.mesh;
    const Point<Housing> from = pair.on_line_of_action(m.rho1_A);
    const Point<Housing> to = pair.on_line_of_action(m.rho1_E);
    const Vec2 along = in_section(pair, to) - in_section(pair, from);
    EXPECT_NEAR(along.norm(), (to.r - from.r).norm(), 1e-9);
    EXPECT_NEAR(std::abs(along.y()) / along.norm(), m.rack.angles.sin_alpha, 1e-9);
  }
}

// The sections of the cylinders are exact: the tip cylinders pass through A and E, and the leading
// line is tangent to the base cylinders at T_1 and T_2.
TEST(SectionPicture, CylindersPassThroughTheEndsOfTheLine) {
  for (const CrossedPair& pair : testing::crossed_pairs()) {
    const Mesh<double>& m = pair.mesh;
    const auto at = [&](double rho1) { return in_section(pair, pair.on_line_of_action(rho1)); };
    const auto tip = [&](std::size_t i) {
      return section_of_cylinder(pair, i, pair.input.tip_form_radius[i]);
    };
    const auto base = [&](std::size_t i) {
      return section_of_cylinder(pair, i, pair.input.gears[i].radius);
    };
    EXPECT_NEAR(level(tip(0), at(m.rho1_E)), 1.0, 1e-9);
    EXPECT_NEAR(level(tip(1), at(m.rho1_A)), 1.0, 1e-9);
    const std::array<double, 2> tangent{0.0, m.base_tangent_distance};
    for (const std::size_t i : {0u, 1u}) {
      EXPECT_NEAR(level(base(i), at(tangent[i])), 1.0, 1e-9);
      for (const double aside : {-0.5, 0.5}) EXPECT_GT(level(base(i), at(tangent[i] + aside)), 1.0);
    }
    EXPECT_NEAR(level(section_of_cylinder(pair, 0, m.rack.sides[0].pitch_radius), at(m.rho1_C)),
                1.0, 1e-9);
  }
}

TEST(SectionPicture, TrailingLineIsLeftOutWhereItIsFarAway) {
  EXPECT_NE(figure_html(section_figure(testing::crossed_pair())).find("A′"), std::string::npos);
  EXPECT_EQ(figure_html(section_figure(testing::nearly_parallel_pair())).find("A′"),
            std::string::npos);
}

}  // namespace
}  // namespace gearwright
