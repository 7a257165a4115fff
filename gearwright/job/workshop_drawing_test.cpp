// In workshop drawings, texts overlap neither lines nor other texts, on both sheets and for all
// gears.
#include "gearwright/job/workshop_drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/cad/sheet_files.hpp"
#include "gearwright/job/testing/clear_sheet.hpp"

namespace gearwright {
namespace {

using testing::expect_clear;
using testing::taken;

SolvedJob solved(const std::string& toml) {
  return taken(solve(taken(read_spec(toml, SpecFormat::toml)), Scope::everything));
}

std::vector<int> all_gears(const SolvedJob& job) {
  return job.parts() == 1 ? std::vector<int>{1} : std::vector<int>{1, 2};
}

void expect_clear(const std::string& toml, const std::string& what) {
  const SolvedJob job = solved(toml);
  for (const SheetSize size : {SheetSize::a4, SheetSize::a3}) {
    const WorkshopSheets made = taken(workshop_sheets(job, all_gears(job), size, 0.001));
    EXPECT_LE(made.deviation_mm, 0.001);
    for (const Sheet& sheet : made.sheets)
      expect_clear(sheet, what + (size == SheetSize::a4 ? ", A4" : ", A3"));
  }
}

std::string gear(const std::string& lines) { return "[gear1]\n" + lines + "\n"; }

constexpr const char* kFull = R"(
title = "helical pinion"
[drawing]
number = "GW-0017-01"
author = "A. Example"
material = "18CrNiMo7-6, case hardened 60 HRC, case depth 0.6 to 0.8 mm after grinding, core 1000 MPa"
date = "2026-11-22"
note = "Break sharp edges 0.3. Teeth ground after hardening, no grinding steps in the root fillet."
[gear1]
teeth = 17
normal_module_mm = 2.5
helix_angle_deg = 15
profile_shift = 0.3
thickness_allowance_mm = [-0.10, -0.06]
face_width_mm = 25
quality = 6
[gear1.modifications]
tip_relief_um = 20
tip_relief_start_mm = 48.0
left_lead_crowning_um = 8
right_lead_crowning_um = 10
end_relief_um = 10
end_relief_length_mm = 2
[gear1.bore]
diameter_mm = 20
keyway_width_mm = 6
keyway_depth_mm = 2.8
[gear2]
teeth = 43
profile_shift = 0.1
face_width_mm = 25
[pair]
center_distance_tolerance = "JS7"
)";

TEST(WorkshopDrawing, words_keep_off_lines_and_each_other) {
  expect_clear(kFull, "full");
  expect_clear(gear("teeth = 17\nnormal_module_mm = 2.5\nface_width_mm = 20"), "solid");
  expect_clear(gear("teeth = 60\nnormal_module_mm = 0.2\nface_width_mm = 1"), "small");
  expect_clear(gear("teeth = 200\nnormal_module_mm = 20\nface_width_mm = 400\n[gear1.bore]\n"
                    "diameter_mm = 60\nkeyway_width_mm = 18\nkeyway_depth_mm = 4.4"),
               "great, with a small bore");
  expect_clear(gear("teeth = 12\nnormal_module_mm = 1\nface_width_mm = 180\n[gear1.bore]\n"
                    "diameter_mm = 4\nkeyway_width_mm = 1\nkeyway_depth_mm = 0.5"),
               "long");
  expect_clear(gear("teeth = 100\nnormal_module_mm = 1\nface_width_mm = 1\nhelix_angle_deg = 30\n"
                    "[gear1.bore]\ndiameter_mm = 80"),
               "thin");
  expect_clear(gear("teeth = -60\nnormal_module_mm = 2\nface_width_mm = 20\n[gear1.bore]\n"
                    "diameter_mm = 150"),
               "ring");
  expect_clear(gear("teeth = 22\nnormal_module_mm = 2\nhelix_angle_deg = 30\nface_width_mm = 30\n"
                    "double_helical = { gap_mm = 6 }\n[gear1.bore]\ndiameter_mm = 20"),
               "double helical");
  expect_clear(gear("teeth = 30\nnormal_module_mm = 4\nhelix_angle_deg = 20\nface_width_mm = 60\n"
                    "rack = \"GBT12759\""),
               "arcs");
  expect_clear(gear("teeth = -200\nnormal_module_mm = 0.5\nface_width_mm = 300"), "long ring");
}

bool contains(const std::string& toml, const std::string& words) {
  const auto made = taken(workshop_sheets(solved(toml), {1}, SheetSize::a4, 0.001));
  const auto& texts = made.sheets.front().texts;
  return std::any_of(texts.begin(), texts.end(),
                     [&](const auto& t) { return t.text.find(words) != std::string::npos; });
}

TEST(WorkshopDrawing, has_the_limits_of_bore_and_keyway) {
  const std::string fits = "[drawing]\nbore_fit = \"H7\"\nkeyway_fit = \"P9\"\n";
  const std::string toml = fits + (kFull + std::string(kFull).find("[gear1]"));
  for (const char* words : {"Ø20 H7", "20.000 … 20.021", "6 P9", "5.958 … 5.988", "22.800 … 22.900",
                            "axis of the bore"})
    EXPECT_TRUE(contains(toml, words)) << words;
  EXPECT_FALSE(contains(kFull, "H7"));
}

// IT9 is 62 µm up to 50 mm and 74 µm up to 80 mm.
TEST(WorkshopDrawing, has_the_limits_of_the_tip_diameter) {
  const std::string tip = "\n[gear1.tolerance]\ntip_diameter_fit = ";
  const std::string pinion = gear("teeth = 18\nnormal_module_mm = 2.5\nface_width_mm = 20");
  for (const char* words : {"Ø50 h9", "49.938 … 50"})
    EXPECT_TRUE(contains(pinion + tip + "\"h9\"", words)) << words;
  const std::string ring = gear("teeth = -60\nnormal_module_mm = 1\nface_width_mm = 20");
  for (const char* words : {"Ø58 H9", "58.000 … 58.074"})
    EXPECT_TRUE(contains(ring + tip + "\"H9\"", words)) << words;
  expect_clear(pinion + tip + "\"js10\"", "tip with a fit");
  // Two equal deviations: the only permitted size is not the nominal one, 50 mm.
  const std::string equal = "\n[gear1.tolerance]\ntip_diameter_deviations_mm = [-0.05, -0.05]";
  EXPECT_TRUE(contains(pinion + equal, "49.95 … 49.95"));
  // Two deviations of 0 are no tolerance: the drawing has the nominal size and blank limits.
  const std::string zero = "\n[gear1.tolerance]\ntip_diameter_deviations_mm = [0, 0]";
  EXPECT_TRUE(contains(pinion + zero, "Tip diameter, limits"));
  EXPECT_FALSE(contains(pinion + zero, " … "));
}

// Without [gear1.bore], the rim is 2.5 modules thick. With d_f = 62.5 mm, its outside diameter is
// 62.5 mm + 5 mm.
TEST(WorkshopDrawing, has_the_outside_of_every_rim) {
  const std::string ring = "teeth = -60\nnormal_module_mm = 1\nface_width_mm = 20\n";
  EXPECT_TRUE(contains(gear(ring), "Ø67.5"));
  EXPECT_TRUE(contains(gear(ring + "[gear1.bore]\ndiameter_mm = 80"), "Ø80"));
}

// Oracle: a tooth of the half at z > 0 is turned by b_h/2 + gap/2 times 2π/lead at the middle of
// the half, where the lead is π d/tan β.
TEST(WorkshopDrawing, of_a_double_helical_gear_has_its_section_in_a_half) {
  const std::string gears =
      "teeth = 15\nnormal_module_mm = 2\nhelix_angle_deg = 30\nface_width_mm = 30\n"
      "[gear1.double_helical]\ngap_mm = 6\n";
  EXPECT_TRUE(contains(gear(gears), "Section in the middle of the right-hand half"));
  EXPECT_FALSE(contains(gear(gears), "Section in the middle of the face width"));
  const auto made = taken(workshop_sheets(solved(gear(gears)), {1}, SheetSize::a4, 0.001));
  const auto& paths = made.sheets.front().paths;
  const auto outline = std::max_element(
      paths.begin(), paths.end(),
      [](const auto& a, const auto& b) { return a.points.size() < b.points.size(); });
  Vec2 center = Vec2::Zero();
  for (const Vec2& p : outline->points) center += p / static_cast<double>(outline->points.size());
  // The sum of exp(15 i angle) over the points of the tips has the angle of a tooth.
  double tip = 0.0, turn_x = 0.0, turn_y = 0.0;
  for (const Vec2& p : outline->points) tip = std::max(tip, (p - center).norm());
  for (const Vec2& p : outline->points) {
    if ((p - center).norm() < 0.999 * tip) continue;
    const double a = 15 * std::atan2((p - center).y(), (p - center).x());
    turn_x += std::cos(a);
    turn_y += std::sin(a);
  }
  const double pi = 3.141592653589793;
  const double lead = pi * (15 * 2 / std::cos(pi / 6)) / std::tan(pi / 6);
  const double expected = 15 * 2 * pi * 9.0 / lead;
  EXPECT_NEAR(std::remainder(std::atan2(turn_y, turn_x) - expected, 2 * pi), 0.0, 1e-3);
}

constexpr const char* kSurfaces = R"(
[drawing]
flank_roughness = "MRR Ra 0.4"
face_roughness = "MRR 0.008-0.8/Ra 3.2"
bore_roughness = "MRR Ra 0.8"
edges = "−0.3"
)";

std::ptrdiff_t count(const std::string& toml, const std::string& words, int which = 1) {
  const auto made = taken(workshop_sheets(solved(toml), {which}, SheetSize::a3, 0.001));
  const auto& texts = made.sheets.front().texts;
  return std::count_if(texts.begin(), texts.end(), [&](const auto& t) { return t.text == words; });
}

TEST(WorkshopDrawing, has_the_runout_and_the_texture_of_its_surfaces) {
  const std::string bored = gear(
      "teeth = 40\nnormal_module_mm = 2\nface_width_mm = 20\n[gear1.bore]\n"
      "diameter_mm = 30\n[gear1.tolerance]\ntip_runout_um = 30\nface_runout_um = 12.5");
  const std::string all = kSurfaces + bored;
  for (const char* words : {"0.03", "0.0125", "Ra 0.4", "0.008-0.8/Ra 3.2", "Ra 0.8", "−0.3"})
    EXPECT_EQ(count(all, words), 1) << words;
  EXPECT_EQ(count(all, "A"), 3);  // the datum and the two runouts
  // If a key is absent, its symbol is drawn without a value.
  EXPECT_EQ(count(bored, "Ra 0.4"), 0);
  EXPECT_EQ(count(bored, "A"), 3);
  const std::string inch =
      "units = \"inch\"\n[gear1]\nteeth = 40\nnormal_diametral_pitch_per_in = 10\n"
      "face_width_in = 1\n[gear1.tolerance]\ntip_runout_uin = 1250";
  EXPECT_EQ(count(inch, "0.00125"), 1);
}

// If the drawing has no roughness of its own, the roughness of the rating is used.
TEST(WorkshopDrawing, takes_the_roughness_of_the_flanks_from_the_rating) {
  const std::string pair =
      "[gear1]\nteeth = 20\nnormal_module_mm = 2\nface_width_mm = 20\n[gear2]\nteeth = 41\n"
      "[rating]\nflank_roughness_um = [3, 4.5]\n";
  EXPECT_EQ(count(pair, "Rz 3", 1), 1);
  EXPECT_EQ(count(pair, "Rz 4.5", 2), 1);
  EXPECT_EQ(count(kSurfaces + pair, "Rz 3"), 0);
  EXPECT_EQ(count(kSurfaces + pair, "Ra 0.4"), 1);
}

// A general texture applies to the surfaces without a symbol of their own.
TEST(WorkshopDrawing, has_no_blank_symbols_beside_a_general_texture) {
  const auto lines = [](const std::string& toml) {
    return taken(workshop_sheets(solved(toml), {1}, SheetSize::a3, 0.001)).sheets[0].paths.size();
  };
  const std::string solid = gear("teeth = 40\nnormal_module_mm = 2\nface_width_mm = 20");
  const std::string general = "[drawing]\nsurface_texture = \"Ra 3.2\"\n";
  // The symbols of flanks and faces have three lines each, and the leader of the flanks has two
  // lines and an arrow.
  EXPECT_EQ(lines(solid), lines(general + solid) + 9);
  EXPECT_EQ(lines(solid), lines(general + "flank_roughness = \"Ra 1\"\n" + solid) + 3);
}

TEST(WorkshopDrawing, symbols_keep_off_the_views) {
  const char* const gears[] = {
      "teeth = 17\nnormal_module_mm = 2.5\nface_width_mm = 20",
      "teeth = 60\nnormal_module_mm = 0.2\nface_width_mm = 1\n[gear1.bore]\ndiameter_mm = 3",
      "teeth = 12\nnormal_module_mm = 1\nface_width_mm = 180\n[gear1.bore]\n"
      "diameter_mm = 4\nkeyway_width_mm = 1\nkeyway_depth_mm = 0.5",
      "teeth = 200\nnormal_module_mm = 20\nface_width_mm = 400\n[gear1.bore]\n"
      "diameter_mm = 60\nkeyway_width_mm = 18\nkeyway_depth_mm = 4.4",
      "teeth = 40\nnormal_module_mm = 2\nface_width_mm = 20\n[gear1.bore]\ndiameter_mm = 60",
      "teeth = -60\nnormal_module_mm = 2\nface_width_mm = 20",
      "teeth = -200\nnormal_module_mm = 0.5\nface_width_mm = 300",
      "teeth = 22\nnormal_module_mm = 2\nhelix_angle_deg = 30\nface_width_mm = 30\n"
      "double_helical = { gap_mm = 6 }\n[gear1.bore]\ndiameter_mm = 20"};
  for (const char* lines : gears) {
    const std::string bare = gear(lines);
    expect_clear(bare, bare);
    expect_clear(kSurfaces + bare + "[gear1.tolerance]\ntip_runout_um = 25\nface_runout_um = 25\n",
                 "with symbols, " + bare);
  }
}

// A disc with the diameter of the pitch circle has nearly the mass of the gear.
TEST(WorkshopDrawing, has_the_mass_of_a_gear_with_a_material) {
  const std::string disc = "teeth = 60\nnormal_module_mm = 2\nface_width_mm = 20\n";
  EXPECT_FALSE(contains(gear(disc), " kg"));
  EXPECT_TRUE(
      contains(gear(disc + "material = \"16MnCr5\""), "1.7"));  // π/4 120² 20 7.83e-6 = 1.77
}

// The drawing shows the material with which the gear is rated, unless the title block names another
// material.
TEST(WorkshopDrawing, has_the_material_of_the_gear) {
  const auto named = [](const std::string& toml) { return contains(toml, "16MnCr5"); };
  const std::string pinion = gear(
      "teeth = 17\nnormal_module_mm = 2.5\nface_width_mm = 20\nmaterial = { name = \"16MnCr5\" }");
  EXPECT_TRUE(named(pinion));
  EXPECT_FALSE(named("[drawing]\nmaterial = \"C45\"\n" + pinion));
}

// A drawing in inch has the mass in pounds, and the rack has the name that was ordered.
TEST(WorkshopDrawing, has_the_rack_and_the_mass_of_an_inch_spec) {
  const std::string inch =
      "units = \"inch\"\n" +
      gear(
          "teeth = 60\nnormal_diametral_pitch_per_in = 12.7\nface_width_in = 0.7874\n"
          "rack = \"AGMA-20\"\nmaterial = \"16MnCr5\"");
  for (const char* words : {"AGMA-20", " lb"}) EXPECT_TRUE(contains(inch, words)) << words;
  for (const char* words : {"ISO 53", " kg"}) EXPECT_FALSE(contains(inch, words)) << words;
  const std::string plain = "teeth = 60\nnormal_module_mm = 2\nface_width_mm = 20\n";
  EXPECT_TRUE(contains(gear(plain), "ISO 53-A"));
  EXPECT_FALSE(contains(gear(plain + "rack = { dedendum = 1.3 }"), "ISO 53"));
}

// A value of one flank or of one end needs the definition of the flank and of the end. The
// evaluation ranges belong to the tolerances.
TEST(WorkshopDrawing, defines_flanks_ends_and_evaluation_ranges) {
  const std::string plain = gear(
      "teeth = 28\nnormal_module_mm = 2\nhelix_angle_deg = 20\nface_width_mm = 20\n"
      "quality = 6");
  const std::string one_side = plain + "[gear1.modifications]\nright_lead_slope_um = -1\n";
  const std::string both = plain + "[gear1.modifications]\nlead_crowning_um = 6\n";
  for (const char* words : {"Right flank, seen from +z", "Face +z of the axial section",
                            "A positive helix slope removes more at"}) {
    EXPECT_TRUE(contains(one_side, words)) << words;
    EXPECT_FALSE(contains(both, words)) << words;
  }
  for (const char* words :
       {"Profile evaluation, roll lengths", "Helix evaluation, heights", "−9 … 9 mm"})
    EXPECT_TRUE(contains(plain, words)) << words;
  expect_clear(one_side, "helix slope of one flank");
}

// The default cutter of a ring has half of its teeth (gear/pinion_cut.hpp).
TEST(WorkshopDrawing, has_the_cutter_by_its_name) {
  const std::string ring = gear("teeth = -60\nnormal_module_mm = 2\nface_width_mm = 20");
  for (const char* words : {"Pinion cutter, teeth", "30, default cutter", "ρ"})
    EXPECT_TRUE(contains(ring, words)) << words;
  const std::string pair =
      "[gear1]\nteeth = 60\ncut_by = \"gear2\"\nprofile_shift_pair = 0\nface_width_mm = 20\n"
      "[gear2]\nteeth = 24\nnormal_module_mm = 2\nface_width_mm = 20\n";
  EXPECT_TRUE(contains(pair, "24, gear 2"));
  EXPECT_FALSE(contains(pair, "ISO 53"));
}

TEST(WorkshopDrawing, names_the_standard_of_arcs_and_of_its_data) {
  const std::string arcs =
      "teeth = 30\nnormal_module_mm = 4\nhelix_angle_deg = 20\n"
      "face_width_mm = 60\nrack = ";
  EXPECT_TRUE(contains(gear(arcs + "\"GBT12759\""), "GB/T 12759-1991"));
  EXPECT_FALSE(contains(gear(arcs + "\"GBT12759\""), "DIN 3966"));
  EXPECT_TRUE(contains(gear(arcs + "{ kind = \"double_circular_arc\", concave_radius = 1.42, "
                                   "concave_height = 0.0325, space_width = 1.1773 }"),
                       "with circular arcs"));
  EXPECT_TRUE(contains(kFull, "Gear data by DIN 3966-1"));
}

TEST(WorkshopDrawing, has_a_blank_row_without_a_class) {
  const std::string pinion = gear("teeth = 17\nnormal_module_mm = 2.5\nface_width_mm = 20\n");
  EXPECT_TRUE(contains(pinion, "Flank tolerance class"));
  EXPECT_FALSE(contains(kFull, "Flank tolerance class"));
  EXPECT_TRUE(contains(kFull, "class 6"));
}

// Tip diameter and tooth thickness have either limits or a blank row.
TEST(WorkshopDrawing, has_blank_rows_without_limits) {
  const std::string pinion = gear("teeth = 17\nnormal_module_mm = 2.5\nface_width_mm = 20\n");
  const char* const tip = "Tip diameter, limits";
  const char* const thickness = "Allowance and tolerance";
  const std::string tolerance = pinion + "[gear1.tolerance]\n";
  EXPECT_TRUE(contains(pinion, tip) && contains(pinion, thickness));
  EXPECT_FALSE(contains(tolerance + "tip_diameter_fit = \"h9\"", tip));
  EXPECT_FALSE(contains(tolerance + "tip_diameter_deviations_mm = [-0.05, 0]", tip));
  EXPECT_TRUE(contains(tolerance + "thickness_series = \"cd25\"", "cd25, DIN 3967"));
  // Limits of the span or of the allowance take the place of a series.
  EXPECT_FALSE(contains(pinion + "thickness_allowance_mm = [-0.1, -0.06]", thickness));
  EXPECT_FALSE(contains(tolerance + "span_mm = [11.58, 11.62]", thickness));
  EXPECT_TRUE(contains(pinion + "thickness_allowance_mm = -0.08", thickness));
}

// The mating gear of a pair is on the other sheet, if it is drawn.
TEST(WorkshopDrawing, has_the_drawing_number_of_the_mating_gear) {
  const std::string pair =
      "[gear1]\nteeth = 20\nnormal_module_mm = 2\nface_width_mm = 20\n[gear2]\nteeth = 41\n";
  const auto has = [](const std::string& toml, std::size_t sheet, const char* words) {
    const auto made = taken(workshop_sheets(solved(toml), {1, 2}, SheetSize::a4, 0.001));
    const auto& texts = made.sheets[sheet].texts;
    return std::any_of(texts.begin(), texts.end(), [&](const auto& t) { return t.text == words; });
  };
  const std::string numbered = "[drawing]\nnumber = \"GW-0017\"\n" + pair;
  EXPECT_TRUE(has(numbered, 0, "GW-0017, sheet 2/2") && has(numbered, 1, "GW-0017, sheet 1/2"));
  EXPECT_TRUE(has(pair, 0, "sheet 2/2") && has(pair, 1, "sheet 1/2"));
  EXPECT_FALSE(contains(pair, "sheet "));       // only gear 1 is drawn
  EXPECT_EQ(count(pair, "Drawing number"), 2);  // the row of the mating gear, and the title block
  EXPECT_EQ(count(gear("teeth = 20\nnormal_module_mm = 2\nface_width_mm = 20"), "Drawing number"),
            1);
}

// Only given data are shown. The usual hardness of a named material is not shown.
TEST(WorkshopDrawing, has_the_heat_treatment_of_the_material) {
  const auto with = [](const std::string& material) {
    return gear("teeth = 17\nnormal_module_mm = 2.5\nface_width_mm = 20\nmaterial = " + material);
  };
  EXPECT_EQ(count(with("\"16MnCr5\""), "case-hardened"), 1);
  EXPECT_EQ(
      count(with("{ name = \"42CrMo4\", surface_hardness_HV = 300 }"), "through-hardened, 300 HV"),
      1);
  EXPECT_EQ(count(with("{ kind = \"nitrided\", sigma_Hlim_MPa = 1200, sigma_Flim_MPa = 400 }"),
                  "nitrided"),
            1);
  EXPECT_FALSE(contains(with("\"EN-GJS-600-3\""), "nodular"));
  const std::string own = "[drawing]\nheat_treatment = \"carburized 60 HRC\"\n";
  EXPECT_TRUE(contains(own + with("\"16MnCr5\""), "carburized 60 HRC"));
  EXPECT_FALSE(contains(own + with("\"16MnCr5\""), "case-hardened"));
  EXPECT_FALSE(contains("[drawing]\nmaterial = \"C45\"\n" + with("\"16MnCr5\""), "hardened"));
}

TEST(WorkshopDrawing, of_every_example) {
  int drawn = 0;
  for (const auto& entry : std::filesystem::directory_iterator(testing::source_file("examples"))) {
    if (entry.path().extension() != ".toml") continue;
    const auto spec = read_spec_file(entry.path());
    if (!spec || !spec->gears[0] || spec->search) continue;
    const auto job = solve_any(*spec, Scope::everything);
    if (!job) continue;
    const auto made = workshop_sheets(*job, all_gears(*job), SheetSize::a4, 0.001);
    if (!made) continue;
    for (const Sheet& sheet : made->sheets) expect_clear(sheet, entry.path().filename().string());
    ++drawn;
  }
  EXPECT_GE(drawn, 10);
}

TEST(WorkshopDrawing, names_the_tolerances_of_thickness_and_distance) {
  const std::string pair =
      "[gear1]\nteeth = 27\nnormal_module_mm = 3.5\nhelix_angle_deg = 18\nface_width_mm = 45\n"
      "profile_shift = 0.24\n"
      "[gear1.tolerance]\nthickness_series = \"cd25\"\nquality = 6\n"
      "edition = \"ISO 1328:1995\"\ntip_diameter_fit = \"h9\"\n[gear2]\nteeth = 64\n"
      "[pair]\ncenter_distance_mm = 168\ncenter_distance_tolerance = \"JS7\"\n";
  // d_a = 108.04321 mm is rounded in the view.
  for (const char* words : {"cd25, DIN 3967", "168 ± 0.02 (JS7)", "Ø108.043 h9", "Ø99.363"})
    EXPECT_TRUE(contains(pair, words)) << words;
  EXPECT_EQ(count(pair, "ptT"), 0);
  EXPECT_EQ(count(pair, "pt"), 1);
}

TEST(WorkshopDrawing, has_the_pins_of_the_spec) {
  const std::string pins = gear(
      "teeth = 20\nnormal_module_mm = 3\nface_width_mm = 25\n[gear1.measure]\n"
      "pin_diameter_mm = 5.5");
  EXPECT_TRUE(contains(pins, "Diameter of the pins"));
  EXPECT_TRUE(contains(pins, "Dimension over two pins"));
  EXPECT_FALSE(contains(pins, "balls"));
}

TEST(WorkshopDrawing, keeps_the_lines_of_a_note) {
  const std::string note = "[drawing]\nnote = \"Deburr.\\nMark the teeth.\"\nedges = \"-0.3\"\n" +
                           gear("teeth = 20\nnormal_module_mm = 3\nface_width_mm = 25");
  for (const char* words : {"Deburr.", "Mark the teeth.", "−0.3"})
    EXPECT_EQ(count(note, words), 1) << words;
}

}  // namespace
}  // namespace gearwright
