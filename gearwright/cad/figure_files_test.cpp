#include "gearwright/cad/figure_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "gearwright/cad/sheet_files.hpp"
#include "gearwright/cad/style_sheet.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/report/pair_figures.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

Figure sloping_line() {
  Figure f{"f", "Größe", "", "", {"x", "mm", 0.0, 10.0}, {"y", "µm", -2.0, 3.0}};
  f.line({{0.0, -2.0}, {10.0, 3.0}}, "curve g1 dash", "slope");
  f.text({5.0, 0.0}, "<tspan class=\"v\">ε</tspan><tspan class=\"s\" dy=\"3\">α</tspan> &lt; 2",
         Anchor::middle, "halo");
  return f;
}

TEST(FigureFiles, a_curve_has_its_place_its_colour_and_its_clip) {
  const std::string pdf = figure_file(sloping_line(), ".pdf").value();
  // The plot of the SVG picture, px. The corners of the plot are the ends of the curve.
  const std::string svg = figure_file(sloping_line(), ".svg").value();
  double left = 0, right = 0, bottom = 0, top = 0, width = 0, height = 0;
  ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("data-x="), "data-x=\"0 10 %lf %lf", &left, &right),
            2);
  ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("data-y="), "data-y=\"-2 3 %lf %lf", &bottom, &top),
            2);
  ASSERT_EQ(
      std::sscanf(svg.c_str() + svg.find("viewBox="), "viewBox=\"0 0 %lf %lf", &width, &height), 2);
  double box[2] = {};
  ASSERT_EQ(
      std::sscanf(pdf.c_str() + pdf.find("/MediaBox"), "/MediaBox [0 0 %lf %lf]", box, box + 1), 2);
  EXPECT_NEAR(box[0], 0.75 * width, 1e-3);
  EXPECT_NEAR(box[1], 0.75 * height, 1e-3);

  // #0067a6, width 2.2 px, dashes of 7 and 4 px.
  const std::size_t look = pdf.find("0 0.404 0.651 RG 0.5821 w [1.852 1.058] 0 d\n");
  ASSERT_NE(look, std::string::npos);
  const double mm = 25.4 / 96;
  double x[2] = {}, y[2] = {};
  ASSERT_EQ(std::sscanf(pdf.c_str() + pdf.find('\n', look) + 1, "%lf %lf m\n%lf %lf l\nS\nQ", x, y,
                        x + 1, y + 1),
            4);
  EXPECT_NEAR(x[0], mm * left, 1e-3);
  EXPECT_NEAR(y[0], mm * (height - bottom), 1e-3);
  EXPECT_NEAR(x[1], mm * right, 1e-3);
  EXPECT_NEAR(y[1], mm * (height - top), 1e-3);
  const std::size_t clip = pdf.rfind("q\n", look) + 2;
  double c[4] = {};
  ASSERT_EQ(std::sscanf(pdf.c_str() + clip, "%lf %lf %lf %lf re W n", c, c + 1, c + 2, c + 3), 4);
  EXPECT_NEAR(c[0], mm * (left - 1), 1e-3);
  EXPECT_NEAR(c[3], mm * (bottom - top + 2), 1e-3);
}

TEST(FigureFiles, a_text_has_its_symbols_and_a_light_ground) {
  const Sheet sheet = picture_sheet(figure_file(sloping_line(), ".svg").value(), {1.0});
  std::vector<SheetText> texts;
  for (const SheetText& t : sheet.texts)
    if (t.text == "ε" || t.text == "α" || t.text == " < 2") texts.push_back(t);
  ASSERT_EQ(texts.size(), 6u);  // each text follows its light ground
  for (std::size_t i = 0; i < 6; i += 2) {
    EXPECT_FALSE(texts[i].ink->fill);
    EXPECT_EQ(texts[i].ink->stroke, 0xFFFFFFu);
    EXPECT_EQ(texts[i + 1].ink->fill, 0x000000u);
    EXPECT_EQ(texts[i].at, texts[i + 1].at);
  }
  EXPECT_TRUE(texts[1].slanted);
  EXPECT_NEAR(texts[1].at.y() - texts[3].at.y(), 3.0, 1e-9);
  EXPECT_NEAR(texts[3].height, 9.5 * kCapital, 1e-9);
  const std::string svg = figure_file(sloping_line(), ".svg").value();
  double left = 0, right = 0;
  std::sscanf(svg.c_str() + svg.find("data-x="), "data-x=\"0 10 %lf %lf", &left, &right);
  const double end = texts[5].at.x() + text_width(" < 2", texts[5].height);
  EXPECT_NEAR((texts[1].at.x() + end) / 2, (left + right) / 2, 0.02);
}

TEST(FigureFiles, the_mesh_in_dxf_has_the_scale_of_the_gears) {
  const InvolutePair pair = testing::helical_pair();
  const std::array<std::string, 2> shapes{"one", "two"};
  Figure mesh = mesh_figures(pair, shapes)[1];  // the whole pair
  for (const std::size_t i : {0u, 1u})
    mesh.definitions += gear_definition(pair.gears[i], shapes[i]);
  const std::string dxf = figure_file(mesh, ".dxf").value();
  // The tips of gear 2 are found by their distance from its axis, which is at the centre distance.
  double greatest = 0.0;
  int teeth = 0;
  std::size_t at = dxf.find("\nLWPOLYLINE\n");
  for (; at != dxf.npos; at = dxf.find("\nLWPOLYLINE\n", at + 1)) {
    std::istringstream entity(dxf.substr(at + 1, dxf.find("\n  0\n", at + 1) - at));
    std::string code, value, layer;
    Vec2 p(0, 0);
    bool own = false;
    std::getline(entity, value);
    while (std::getline(entity, code) && std::getline(entity, value) && code != "0") {
      if (code == "8") own = value == "outline_g2";
      if (code == "10") p.x() = std::stod(value);
      if (code != "20" || !own) continue;
      p.y() = std::stod(value);
      greatest = std::max(greatest, (p - Vec2(pair.center_distance, 0.0)).norm());
    }
    teeth += own ? 1 : 0;
  }
  EXPECT_EQ(teeth, pair.gears[1].spec.teeth);
  EXPECT_NEAR(greatest, pair.gears[1].actual_tip_radius(), 5e-3);
  EXPECT_NE(dxf.find("\nLAYER\n"), dxf.npos);
  EXPECT_EQ(letters_not_in_pdf({picture_sheet(figure_file(mesh, ".svg").value(), {1.0})}), 0);
}

TEST(FigureFiles, teeth_outside_the_window_are_not_in_the_pdf) {
  const InvolutePair pair = testing::helical_pair();
  const std::array<std::string, 2> shapes{"one", "two"};
  const auto outlines = [&](Figure mesh) {
    for (const std::size_t i : {0u, 1u})
      mesh.definitions += gear_definition(pair.gears[i], shapes[i]);
    const Sheet sheet = picture_sheet(figure_file(mesh, ".svg").value(), {1.0});
    return std::count_if(sheet.paths.begin(), sheet.paths.end(), [](const SheetPath& p) {
      return p.ink->name.starts_with("outline") && !p.closed && p.points.size() > 20;
    });
  };
  const auto [mesh, whole] = mesh_figures(pair, shapes);
  const int teeth = pair.gears[0].spec.teeth + pair.gears[1].spec.teeth;
  EXPECT_EQ(outlines(whole), teeth);
  EXPECT_GE(outlines(mesh), 4);
  EXPECT_LE(outlines(mesh), 12);
}

TEST(FigureFiles, other_endings_are_rejected) {
  EXPECT_EQ(figure_file(sloping_line(), ".png").error().message(),
            "path = .png: must end in .svg, .pdf or .dxf");
  EXPECT_NE(figure_file(sloping_line(), ".dxf").error().message().find("as .pdf"),
            std::string::npos);
}

TEST(StyleSheet, the_more_specific_rule_wins_and_paper_has_its_colours) {
  const StyleSheet sheet(
      "/* a */:root{--ink:#111}@media (prefers-color-scheme:dark){:root{--ink:#eee}}\n"
      "svg .a{fill:var(--ink);stroke:color-mix(in srgb,#fff,#000)}svg path{fill:none;stroke:#abc}\n"
      ".a.b,.c{stroke-width:2.5}.a{stroke-width:1}svg .x:hover{fill:#f00}"
      "@media print{:root{--ink:#222}}");
  Style style = sheet.root();
  sheet.apply("path", "a b", style);
  EXPECT_EQ(colour_in(style, "fill", {}), 0x222222u);
  EXPECT_EQ(colour_in(style, "stroke", {}), 0xAABBCCu);
  EXPECT_EQ(number_in(style, "stroke-width", 0), 2.5);
  Style other = sheet.root();
  sheet.apply("path", "x", other);
  EXPECT_FALSE(colour_in(other, "fill", 0));
}

}  // namespace
}  // namespace gearwright
