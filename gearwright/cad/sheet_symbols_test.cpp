#include "gearwright/cad/sheet_symbols.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/cad/sheet_files.hpp"
#include "gearwright/cad/sheet_parts.hpp"

namespace gearwright {
namespace {

constexpr double kH = 2.5;  // height of capitals, mm

Sheet empty_sheet() { return {{210, 297}, {}, {}, {}}; }

double distance_to(const SheetPath& line, const Vec2& point) {
  const Vec2 along = (line.points[1] - line.points[0]).normalized(), to = point - line.points[0];
  return std::abs(along.x() * to.y() - along.y() * to.x());
}

// ISO 1302:2002, annex A: H1 = 1.4 h (3.5 mm), H2 = 3 h (7.5 mm), and legs at 60°.
TEST(SheetSymbols, texture_has_the_proportions_of_the_standard) {
  Sheet sheet = empty_sheet();
  draw_texture(sheet, {50, 60}, "Ra 0.8");
  ASSERT_EQ(sheet.paths.size(), 3u);  // two legs and the line over the text
  for (const int leg : {0, 1}) {
    const auto& path = sheet.paths[static_cast<std::size_t>(leg)];
    const Vec2 rise = path.points[1] - path.points[0];
    EXPECT_NEAR(rise.y(), leg == 0 ? 1.4 * kH : 3 * kH, 1e-12);
    EXPECT_NEAR(std::atan2(rise.y(), std::abs(rise.x())), std::numbers::pi / 3, 1e-12);
  }
  ASSERT_EQ(sheet.texts.size(), 1u);
  EXPECT_EQ(sheet.texts[0].text, "Ra 0.8");
  const SheetBox text = box_of(sheet.texts[0]);
  EXPECT_LT(text.hi.y(), 60 + 3 * kH);
  EXPECT_GT(text.lo.x(), sheet.paths[1].points[1].x());
  EXPECT_LT(text.hi.x(), 50 + texture_right("Ra 0.8"));
}

TEST(SheetSymbols, the_first_word_of_a_texture_selects_the_symbol) {
  const auto drawn = [](const char* words) {
    Sheet sheet = empty_sheet();
    draw_texture(sheet, {50, 60}, words);
    return sheet;
  };
  const Sheet bar = drawn("MRR Ra 0.8"), circle = drawn("NMR Ra 0.8"), any = drawn("APA Ra 0.8");
  for (const Sheet* sheet : {&bar, &circle, &any}) EXPECT_EQ(sheet->texts.at(0).text, "Ra 0.8");
  EXPECT_EQ(bar.paths.size(), 4u);
  EXPECT_TRUE(bar.circles.empty());
  EXPECT_EQ(any.paths.size(), 3u);
  EXPECT_TRUE(any.circles.empty());
  ASSERT_EQ(circle.circles.size(), 1u);
  const SheetCircle& c = circle.circles[0];
  for (const int leg : {0, 1})
    EXPECT_NEAR(distance_to(circle.paths[static_cast<std::size_t>(leg)], c.center), c.radius,
                1e-12);
  EXPECT_NEAR(c.center.y() + c.radius, 60 + 1.4 * kH, 1e-12);
  EXPECT_EQ(drawn("MRRa 0.8").texts.at(0).text, "MRRa 0.8");
  for (const char* blank : {"", "MRR", "NMR "}) {
    EXPECT_TRUE(drawn(blank).texts.empty()) << blank;
    EXPECT_GT(texture_right(blank), 3 * kH / std::sqrt(3.0) + 8) << blank;
  }
}

// ISO 7083: a frame of the height 2 h with the symbol, the value and the datum.
TEST(SheetSymbols, runout_has_three_cells) {
  for (const char* value : {"", "0.012", "0.00125"}) {
    Sheet sheet = empty_sheet();
    const double width = runout_width(value);
    draw_runout(sheet, {50, 60}, width, value);
    const auto& frame = sheet.paths[0].points;
    EXPECT_NEAR(frame[2].y() - frame[0].y(), 2 * kH, 1e-12);
    EXPECT_NEAR(frame[2].x() - frame[0].x(), width, 1e-12);
    EXPECT_EQ(sheet.texts.size(), *value ? 2u : 1u);
    EXPECT_EQ(sheet.texts.back().text, "A");
    if (!*value) continue;
    const SheetBox box = box_of(sheet.texts[0]);
    EXPECT_GT(box.lo.x(), sheet.paths[1].points[0].x());
    EXPECT_LT(box.hi.x(), sheet.paths[2].points[0].x());
  }
}

TEST(SheetSymbols, a_datum_has_its_base_on_the_line) {
  for (const DatumSide side : {DatumSide::above, DatumSide::below}) {
    Sheet sheet = empty_sheet();
    draw_datum(sheet, {50, 60}, side);
    const SheetPath& triangle = sheet.paths[0];
    EXPECT_TRUE(triangle.filled);
    EXPECT_EQ(triangle.points[0].y(), 60.0);
    EXPECT_EQ(triangle.points[1].y(), 60.0);
    const double up = side == DatumSide::above ? 1.0 : -1.0;
    EXPECT_GT(up * (triangle.points[2].y() - 60), 2.0);
    const auto& box = sheet.paths[2].points;
    const double far = up > 0 ? box[2].y() : box[0].y();
    EXPECT_NEAR(far, 60 + up * kDatumHeight, 1e-12);
    EXPECT_EQ(sheet.texts.at(0).text, "A");
  }
}

TEST(SheetSymbols, are_in_all_files) {
  Sheet plain = empty_sheet(), with = empty_sheet();
  plain.line(SheetLayer::outline, {20, 20}, {30, 20});
  with = plain;
  draw_texture(with, {50, 60}, "NMR Ra 0.8");
  draw_runout(with, {50, 80}, runout_width("0.02"), "0.02");
  draw_datum(with, {50, 120}, DatumSide::above);
  const std::vector<Sheet> sheets{with};
  for (const std::string& file :
       {sheets_pdf(sheets, {}), sheets_svg(sheets, {}), sheets_dxf(sheets)}) {
    EXPECT_NE(file.find("Ra 0.8"), std::string::npos);
    EXPECT_NE(file.find("0.02"), std::string::npos);
  }
  EXPECT_NE(sheets_dxf(sheets).find("SOLID"), std::string::npos);
  EXPECT_NE(sheets_svg(sheets, {}).find("<circle"), std::string::npos);
  EXPECT_NE(sheets_pdf(sheets, {}).find("f\n"), std::string::npos);
}

TEST(SheetParts, reach_contains_the_dimension_and_its_datum) {
  for (const double length : {1.0, 9.0, 12.0, 40.0}) {
    for (const bool datum : {false, true}) {
      Sheet sheet = empty_sheet();
      Dimension d{Direction::up, 100, 100 + length, 80, 80, 70, "Ø20 H7"};
      d.datum = datum;
      draw_dimension(sheet, d);
      double lo = 1e9, hi = -1e9;
      const auto add = [&](double y) {
        lo = std::min(lo, y);
        hi = std::max(hi, y);
      };
      for (const SheetPath& path : sheet.paths)
        for (const Vec2& p : path.points) add(p.y());
      for (const SheetText& text : sheet.texts) {
        add(box_of(text).lo.y());
        add(box_of(text).hi.y());
      }
      const Reach reach = reach_of(d);
      EXPECT_LE(reach.lo, lo + 1e-9) << length << datum;
      EXPECT_GE(reach.hi, hi - 1e-9) << length << datum;
      EXPECT_LE(reach.hi - reach.lo, hi - lo + 3.1) << length << datum;
      const auto letter = [](const SheetText& t) { return t.text == "A"; };
      EXPECT_EQ(std::count_if(sheet.texts.begin(), sheet.texts.end(), letter), datum ? 1 : 0);
    }
  }
}

}  // namespace
}  // namespace gearwright
