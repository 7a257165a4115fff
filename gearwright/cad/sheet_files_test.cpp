#include "gearwright/cad/sheet_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "gearwright/cad/sheet.hpp"
#include "gearwright/cad/sheet_parts.hpp"

namespace gearwright {
namespace {

Sheet blank() { return {{210, 297}, {}, {}, {}}; }

TEST(SheetFont, widths_are_those_of_the_fonts) {
  // The widths are, in Helvetica, A 667, n 556, space 278, Ø 778, ß 611, € 556, and in Symbol α
  // 631, Ω 768, − 549, ″ 411.
  EXPECT_EQ(letter_of(U'A').width, 667);
  EXPECT_EQ(letter_of(U'Ø').width, 778);
  EXPECT_EQ(letter_of(U'ß').width, 611);
  EXPECT_EQ(letter_of(U'€').width, 556);
  EXPECT_EQ(letter_of(U'€').code, 0x80);
  EXPECT_EQ(letter_of(U'α').width, 631);
  EXPECT_EQ(letter_of(U'α').font, SheetFont::symbol);
  EXPECT_EQ(letter_of(U'Ω').code, 'W');
  EXPECT_EQ(letter_of(U'ω').code, 'w');
  EXPECT_EQ(letter_of(U'ς').code, 'V');
  EXPECT_EQ(letter_of(U'−').width, 549);
  EXPECT_EQ(letter_of(U'″').width, 411);
  for (const char32_t code :
       {U'歯', char32_t(0x7F), char32_t(9), char32_t(0x81), char32_t(0x3A2)}) {
    EXPECT_FALSE(letter_of(code).known);
    EXPECT_EQ(letter_of(code).code, '?');
  }
  EXPECT_NEAR(text_width("An α", 7.18), (667 + 556 + 278 + 631) * 0.01, 1e-12);
}

TEST(SheetFiles, arcs_are_within_a_tenth_of_a_micrometre_on_paper) {
  // Arcs with various sweep angles about (100, 150). Points along each Bézier curve are compared
  // with the arc.
  for (const double sweep : {0.01, 0.5, 1.5, 3.0, 3.3, 6.0, -2.0}) {
    const double r = 80;
    Sheet sheet = blank();
    const Vec2 center(100, 150), end = center + r * Vec2(std::cos(sweep), std::sin(sweep));
    sheet.paths.push_back({SheetLayer::outline, {center + Vec2(r, 0), end}, {std::tan(sweep / 4)}});
    std::istringstream lines(sheets_pdf({sheet}, {}));
    Vec2 pen(0, 0);
    int curves = 0;
    double turned = 0.0;
    for (std::string line; std::getline(lines, line);) {
      double n[6];
      const auto read = [&](const char* form, int count) {
        return std::sscanf(line.c_str(), form, n, n + 1, n + 2, n + 3, n + 4, n + 5) == count;
      };
      if (line.ends_with(" m") && read("%lf %lf", 2)) pen = {n[0], n[1]};
      if (!line.ends_with(" c") || !read("%lf %lf %lf %lf %lf %lf", 6)) continue;
      const Vec2 b(n[0], n[1]), c(n[2], n[3]), d(n[4], n[5]);
      for (int i = 0; i <= 16; ++i) {
        const double t = i / 16.0, s = 1 - t;
        const Vec2 at = s * s * s * pen + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
        EXPECT_NEAR((at - center).norm(), r, 1.5e-4) << sweep;
      }
      const Vec2 from = pen - center, to = d - center;
      turned += std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
      pen = d;
      ++curves;
    }
    EXPECT_GE(curves, 1);
    EXPECT_NEAR(turned, sweep, 1e-5);
    EXPECT_NEAR((pen - end).norm(), 0.0, 1e-4);
  }
}

TEST(SheetFiles, the_table_of_a_pdf_says_where_its_objects_begin) {
  Sheet sheet = blank();
  sheet.text(SheetLayer::data, {30, 30}, "a (b) \\ α …", kUsual);
  const std::string pdf = sheets_pdf({sheet, sheet}, {"Größe", "me"});
  const std::size_t table = pdf.rfind("\nxref\n") + 1;
  EXPECT_EQ(std::stoul(pdf.substr(pdf.find("startxref") + 10)), table);
  std::istringstream rows(pdf.substr(table + 5));
  int first = 0, count = 0;
  rows >> first >> count;
  EXPECT_EQ(count, 10);  // entry 0, catalogue, pages, two fonts, text, two pages of two objects
  for (int i = 0; i < count; ++i) {
    std::string place, generation, kind;
    rows >> place >> generation >> kind;
    if (i == 0) continue;
    EXPECT_TRUE(pdf.substr(std::stoul(place)).starts_with(std::to_string(i) + " 0 obj")) << i;
  }
  EXPECT_NE(pdf.find("(a \\(b\\) \\\\ ) Tj"), std::string::npos);
  EXPECT_NE(pdf.find("/S 3.4819 Tf (a) Tj"), std::string::npos);
  EXPECT_NE(pdf.find("( \\205) Tj"), std::string::npos);
  EXPECT_NE(pdf.find("/Title <FEFF"), std::string::npos);
  EXPECT_EQ(letters_not_in_pdf({sheet}), 0);
}

TEST(SheetFiles, sheets_stand_side_by_side_in_svg_and_dxf) {
  Sheet sheet = blank();
  sheet.text(SheetLayer::data, {30, 30}, "<&>", kUsual);
  const std::string svg = sheets_svg({sheet, sheet}, {"a & b", ""});
  EXPECT_NE(svg.find("viewBox=\"0 0 440 297\""), std::string::npos);
  EXPECT_NE(svg.find("translate(230 0)"), std::string::npos);
  EXPECT_NE(svg.find(">&lt;&amp;&gt;</text>"), std::string::npos);
  EXPECT_NE(svg.find("<title>a &amp; b</title>"), std::string::npos);
  const std::string dxf = sheets_dxf({sheet, sheet});
  EXPECT_NE(dxf.find("\n10\n260.0\n20\n30.0\n"), std::string::npos);
}

TEST(SheetParts, words_stay_in_their_box) {
  const SheetBox box{{20, 20}, {60, 30}};
  const auto drawn = [&](std::string_view words) {
    Sheet sheet = blank();
    draw_words(sheet, SheetLayer::data, box, words, kLarge);
    for (const SheetText& t : sheet.texts) {
      const SheetBox b = box_of(t);
      EXPECT_GE(b.lo.x(), box.lo.x()) << words;
      EXPECT_LE(b.hi.x(), box.hi.x() + 1e-9) << words;
      EXPECT_GE(b.lo.y(), box.lo.y() - 1e-9) << words;
      EXPECT_LE(b.hi.y(), box.hi.y() + 1e-9) << words;
    }
    return sheet.texts;
  };
  EXPECT_EQ(drawn("short").front().height, kLarge);
  EXPECT_TRUE(drawn("").empty());
  EXPECT_EQ(drawn("words that want two lines or three").size(), 2u);
  EXPECT_EQ(drawn("words that want two lines or three").back().text, "two lines or three");
  EXPECT_TRUE(drawn(std::string(200, 'W')).front().text.ends_with("W…"));
  std::string long_text;
  for (int i = 0; i < 100; ++i) long_text += "Größe ";
  EXPECT_TRUE(drawn(long_text).back().text.ends_with("…"));
  EXPECT_EQ(drawn(long_text).back().height, kSmall);
}

}  // namespace
}  // namespace gearwright
