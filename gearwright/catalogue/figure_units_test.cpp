#include "gearwright/catalogue/figure_units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>

#include "gearwright/figure/figure_data.hpp"
#include "gearwright/figure/figure_svg.hpp"

namespace gearwright {
namespace {

Figure in_inch(Figure f) { return in_units(UnitSystem::inch, std::move(f)); }

TEST(FigureUnits, AxesPointsAndLengthsOfTexts) {
  Figure f{"f", "A gap of 0.254 mm", "", "", {"height", "mm", 0.0, 50.8}, {"gap", "µm", 0.0, 25.4}};
  f.line({{25.4, 2.54}, kNewPiece, {std::numeric_limits<double>::infinity(), 0.0}}, "", "gap");
  f.text({25.4, 2.54}, "d ", Anchor::start);
  f.marks.back().length = {25.4, 2};
  f.leaders.push_back({{25.4, 0.0}, "a = "});
  f.leaders.back().length = {127.0, 4, "mm", false};
  f.grid = FigureGrid{"stress", "N/mm²", {25.4}, {2.54}, {100.0}};
  const Figure g = in_inch(f);
  EXPECT_EQ(g.title, "A gap of 0.01 in");
  EXPECT_EQ(g.x.unit, "in");
  EXPECT_EQ(g.x.hi, 2.0);
  EXPECT_EQ(g.y.unit, "µin");
  EXPECT_EQ(g.y.hi, 1000.0);
  EXPECT_EQ(g.marks[0].points[0], Vec2(1.0, 100.0));
  EXPECT_TRUE(std::isnan(g.marks[0].points[1].x()));
  EXPECT_TRUE(std::isinf(g.marks[0].points[2].x()));
  EXPECT_EQ(g.marks[1].text(), "d 1.000");
  EXPECT_EQ(g.leaders[0].text(), "a = 5");
  EXPECT_EQ(g.grid->x[0], 1.0);
  EXPECT_EQ(g.grid->unit, "N/mm²");
  EXPECT_EQ(g.grid->values[0], 100.0);
  EXPECT_EQ(figure_data(in_inch(g)), figure_data(g));  // (3)
  EXPECT_EQ(figure_data(in_units(UnitSystem::mm, f)), figure_data(f));
}

TEST(FigureUnits, ValuesOfAMapAndPlacesBesideIt) {
  Figure f{"f", "", "", "", {"height", "mm", 0.0, 50.8}, {"height", "mm", 0.0, 25.4}};
  f.grid = FigureGrid{"gap", "µm", {25.4}, {12.7}, {2.54}};
  f.shades = FigureShades{{1.27, 2.54}, "", ""};
  f.leaders.push_back({{25.4, 12.7}, "a"});
  f.lanes.push_back({"edge", {{2.54, 5.08, "edge", ""}}});
  const Figure g = in_inch(f);
  EXPECT_EQ(g.grid->unit, "µin");
  EXPECT_NEAR(g.grid->values[0], 100.0, 1e-9);
  EXPECT_EQ(g.grid->y[0], 0.5);
  EXPECT_NEAR(g.shades->levels[0], 50.0, 1e-9);
  EXPECT_EQ(g.leaders[0].at, Vec2(1.0, 0.5));
  EXPECT_NEAR(g.lanes[0].blocks[0].from, 0.1, 1e-12);
  EXPECT_NEAR(g.lanes[0].blocks[0].to, 0.2, 1e-12);
}

TEST(FigureUnits, UnitsThatAreSquaresOrHaveWords) {
  const auto unit = [](const char* text) { return TextUnit(UnitSystem::inch, text); };
  EXPECT_EQ(unit("mm²").text(), "in²");
  EXPECT_DOUBLE_EQ(unit("mm²")(25.4 * 25.4), 1.0);
  EXPECT_EQ(unit("mm, smaller values are better").text(), "in, smaller values are better");
  EXPECT_EQ(unit("mm/rad").text(), "in/rad");
  EXPECT_EQ(unit("kg").text(), "lb");
  EXPECT_DOUBLE_EQ(unit("kg, smaller values are better")(0.45359237), 1.0);
  for (const char* same : {"°", "N/mm²", "N/µm", "N/(mm µm)", "kg/mm", "", "mmol"}) {
    EXPECT_EQ(unit(same).text(), same);
    EXPECT_EQ(unit(same)(3.0), 3.0);
    EXPECT_EQ(unit(same).digits(2), 2);
  }
}

// Law 1: shapes, circles and groups have the same pixels; only the ends of the axes differ.
TEST(FigureUnits, ThePictureOfAPlaneFigureIsTheSame) {
  Figure f = plane_figure("p", "section", "", {{-40.0, -30.0}, {40.0, 30.0}});
  f.circle({3.7, 1.1}, 17.3, "thin", 0, "d_a");
  f.cross({3.7, 1.1}, "");
  f.dot({-11.3, 7.9}, 3.0, "mark");
  f.area({{0.0, 0.0}, {10.1, 0.0}, {3.3, 9.7}}, "body");
  f.marks.push_back({FigureMark::Kind::shape, "body g1", {{3.7, 1.1}}, "gear1"});
  f.marks.back().radius = 0.001;
  f.marks.back().gear = 0;
  f.groups.push_back({{5.0, 2.0}, 15.0});
  f.dot({6.0, 2.0}, 2.0, "mark");
  f.marks.back().group = 0;
  f.slide = FigureSlide{{1.0, 2.0}, {3.0, -1.0}, -1.0, 1.0, "mark"};
  const std::regex ends(" data-[xy]=\"[^\"]*\"");
  const auto picture = [&](const Figure& of) {
    return std::regex_replace(figure_svg(of, 640.0), ends, "");
  };
  EXPECT_EQ(picture(in_inch(f)), picture(f));
  EXPECT_NE(figure_svg(in_inch(f), 640.0), figure_svg(f, 640.0));
}

}  // namespace
}  // namespace gearwright
