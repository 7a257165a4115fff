// Tests the workshop drawing of a rack.
//
// (1) Texts overlap neither lines nor other texts, on both sheets and in both units, for short,
//     long and wide racks of both hands, with long and with blank textures.
// (2) The area of the outline, divided by the square of the scale, is the area of the section.
// (3) In the plan, whose upper side is the face at z < 0, the lines of the teeth have the slope of
//     the teeth: their x increases by tan β per length in y.
#include "gearwright/job/workshop_drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/cad/rack_sheet.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/job/testing/clear_sheet.hpp"

namespace gearwright {
namespace {

using testing::expect_clear;
using testing::taken;

struct Bar {
  std::string module = "2", helix = "0", lines = "teeth = 9\n", before = "";
};

SolvedJob solved_rack(const Bar& bar) {
  const std::string toml = bar.before + "[gear1]\nteeth = 20\nnormal_module_mm = " + bar.module +
                           "\nhelix_angle_deg = " + bar.helix +
                           "\nface_width_mm = 20\n[gear2]\nform = \"rack\"\n" + bar.lines;
  return taken(solve_any(taken(read_spec(toml, SpecFormat::toml)), Scope::everything));
}

struct Drawn {
  Sheet sheet;
  double scale;  // mm on paper per mm on the rack
};
Drawn drawn_rack(const Bar& bar, SheetSize size = SheetSize::a4) {
  auto made = taken(workshop_sheets(solved_rack(bar), {2}, size, 1e-4));
  const std::size_t colon = made.scales.find(':');
  return {std::move(made.sheets.front()),
          std::stod(made.scales.substr(0, colon)) / std::stod(made.scales.substr(colon + 1))};
}

bool has_text(const Sheet& sheet, const std::string& words) {
  return std::any_of(sheet.texts.begin(), sheet.texts.end(),
                     [&](const SheetText& t) { return t.text == words; });
}

// Returns the area of a closed path of chords and arcs. The segment between an arc and its chord
// has the area r² (φ − sin φ)/2 with the sweep φ = 4 atan b and the chord 2 r sin(φ/2).
double enclosed_area(const SheetPath& path) {
  double sum = 0.0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const Vec2 &a = path.points[i], &b = path.points[(i + 1) % path.points.size()];
    sum += (a.x() * b.y() - a.y() * b.x()) / 2;
    const double sweep = i < path.bulges.size() ? 4 * std::atan(path.bulges[i]) : 0.0;
    if (sweep == 0.0) continue;
    const double radius = (b - a).norm() / (2 * std::sin(sweep / 2));
    sum += radius * radius * (sweep - std::sin(sweep)) / 2;
  }
  return sum;
}

// Returns the paths of the section, which have more points than all others of the outline.
std::vector<SheetPath> profiles(const Sheet& sheet) {
  std::vector<SheetPath> found;
  for (const SheetPath& p : sheet.paths)
    if (p.layer == SheetLayer::outline && p.points.size() > 5) found.push_back(p);
  return found;
}

TEST(RackDrawing, words_keep_off_lines_and_each_other) {
  const std::string textures =
      "[drawing]\nflank_roughness = \"MRR 0.008-0.8/Ra 3.2\"\n"
      "face_roughness = \"MRR 0.008-0.8/Ra 3.2\"\n";
  for (const std::string& before :
       {std::string(), textures, std::string("[drawing]\nsurface_texture = \"Ra 3.2\"\n")})
    for (const char* helix : {"0", "30", "-45"})
      for (const char* teeth : {"1", "2", "9", "12", "13", "26", "1000"})
        for (const char* more : {"", "face_width_mm = 0.5\n", "face_width_mm = 400\n",
                                 "height_mm = 200\n", "height_mm = 200\nface_width_mm = 1\n"}) {
          const std::string lines = std::string("teeth = ") + teeth + "\n" + more;
          for (const SheetSize size : {SheetSize::a4, SheetSize::a3})
            expect_clear(drawn_rack({"2", helix, lines, before}, size).sheet,
                         std::string("helix ") + helix + ", " + lines + before);
        }
  for (const char* module : {"0.2", "25"})
    expect_clear(drawn_rack({module, "20", "teeth = 26\n", ""}).sheet, module);
}

TEST(RackDrawing, in_inch_has_four_decimals) {
  const std::string toml =
      "units = \"inch\"\n[gear1]\nteeth = 20\nnormal_diametral_pitch_per_in = 10\n"
      "face_width_in = 1\n[gear2]\nform = \"rack\"\nteeth = 12\nheight_in = 0.5\n";
  const SolvedJob job =
      taken(solve_any(taken(read_spec(toml, SpecFormat::toml)), Scope::everything));
  const auto made = taken(workshop_sheets(job, {1, 2}, SheetSize::a4, 0.001));
  for (const Sheet& sheet : made.sheets) expect_clear(sheet, "inch");
  for (const char* words : {"0.5000", "0.6000", "1.0000", "3.7699"})
    EXPECT_TRUE(has_text(made.sheets[1], words)) << words;
}

TEST(RackDrawing, has_the_area_of_the_section) {
  for (const auto& [helix, teeth] : {std::pair{"0", 1}, {"0", 9}, {"25", 12}, {"-40", 5}}) {
    const Bar bar{"2", helix, "teeth = " + std::to_string(teeth) + "\n", ""};
    const Drawn made = drawn_rack(bar);
    const auto found = profiles(made.sheet);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].closed);
    const double exact = metal_area(taken(make_body(solved_rack(bar), 2)));
    EXPECT_NEAR(enclosed_area(found[0]) / (made.scale * made.scale), exact, 1e-5 * exact);  // (2)
  }
}

// Each part ends in a straight line between the teeth, so that both have whole teeth.
TEST(RackDrawing, of_many_teeth_has_the_teeth_at_both_ends) {
  const Bar few{"2", "25", "teeth = " + std::to_string(kTeethAtEnd) + "\n", ""};
  const double exact = metal_area(taken(make_body(solved_rack(few), 2)));
  const Drawn made = drawn_rack({"2", "25", "teeth = 500\n", ""});
  const auto found = profiles(made.sheet);
  ASSERT_EQ(found.size(), 2u);
  for (const SheetPath& part : found) {
    EXPECT_FALSE(part.closed);
    EXPECT_NEAR(enclosed_area(part) / (made.scale * made.scale), exact, 1e-5 * exact);  // (2)
    EXPECT_NEAR(part.points.front().x(), part.points.back().x(), 1e-9);  // at the break
  }
  const double length = 500 * 2 * std::numbers::pi / std::cos(25 * std::numbers::pi / 180);
  const std::string words = std::to_string(std::round(length * 1e3) / 1e3);
  EXPECT_TRUE(has_text(made.sheet, words.substr(0, words.find_last_not_of('0') + 1))) << words;
}

TEST(RackDrawing, shows_the_direction_of_its_teeth) {
  // The hand of the rack is opposite to the hand of the pinion.
  for (const double helix : {20.0, -35.0, 0.0}) {
    const double slope = std::tan(-helix * std::numbers::pi / 180);
    for (const char* teeth : {"9", "40"}) {
      const Drawn made =
          drawn_rack({"2", std::to_string(helix),
                      std::string("teeth = ") + teeth + "\nface_width_mm = 4\n", ""});
      // The plan is below the section, so its inclined lines are the lowest outside the table.
      int lines = 0;
      const auto parts = profiles(made.sheet);
      double back = 1e9;
      for (const SheetPath& p : parts)
        for (const Vec2& q : p.points) back = std::min(back, q.y());
      for (const SheetPath& p : made.sheet.paths) {
        if (p.layer != SheetLayer::dimension || p.points.size() != 2) continue;
        const Vec2 d = p.points[1] - p.points[0];
        const bool inclined = std::abs(d.x()) > 0.1 * d.norm() && std::abs(d.y()) > 0.1 * d.norm();
        // The symbols of textures have the inclination of 60°.
        if (!inclined || std::abs(std::abs(d.y() / d.x()) - std::sqrt(3.0)) < 1e-6) continue;
        EXPECT_LT(std::max(p.points[0].y(), p.points[1].y()), back);
        EXPECT_NEAR(d.x() / d.y(), slope, 1e-12);  // (3)
        ++lines;
      }
      EXPECT_EQ(lines, helix == 0.0 ? 0 : 3);
    }
  }
}

// A default height is 3 modules more than the dedendum of 1.25 modules.
TEST(RackDrawing, shows_which_lengths_are_not_given) {
  const Sheet bare = drawn_rack({"2", "0", "", ""}).sheet;
  for (const char* words : {"21, default length", "8.5, default height", "8.5", "10.5"})
    EXPECT_TRUE(has_text(bare, words)) << words;
  const Sheet given = drawn_rack({"2", "0", "teeth = 9\nheight_mm = 12.0625\n", ""}).sheet;
  for (const SheetText& text : given.texts)
    EXPECT_EQ(text.text.find("default"), std::string::npos) << text.text;
  for (const char* words : {"12.0625", "14.0625"}) EXPECT_TRUE(has_text(given, words)) << words;
}

TEST(RackDrawing, contains_what_the_workshop_needs) {
  const Drawn made =
      drawn_rack({"2", "0", "teeth = 26\nheight_mm = 12\nthickness_allowance_mm = -0.05\n", ""});
  // The pin of 3.5 mm is the nearest to (π + 0.05)/cos 20° = 3.396 mm.
  for (const char* words : {"ISO 53-A", "Diameter of the pin", "3.5", "−0.05", "12", "14",
                            "163.363", "Dimension over one pin", "back of the rack", "Gear, rack"})
    EXPECT_TRUE(has_text(made.sheet, words)) << words;
  const double over = 12 +
                      (3.5 / std::cos(std::numbers::pi / 9) - std::numbers::pi - 0.05) /
                          (2 * std::tan(std::numbers::pi / 9)) +
                      1.75;
  const std::string value = std::to_string(over);
  EXPECT_TRUE(std::any_of(made.sheet.texts.begin(), made.sheet.texts.end(), [&](const auto& t) {
    return t.text.size() > 3 && value.starts_with(t.text.substr(0, t.text.size() - 1)) &&
           std::abs(std::stod(t.text) - over) < 1e-4;
  })) << value;
}

}  // namespace
}  // namespace gearwright
