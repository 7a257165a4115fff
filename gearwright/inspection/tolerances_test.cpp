// Compares the tolerances of flanks, thicknesses and distances with the tables of their standards.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/inspection/flank_tolerances.hpp"
#include "gearwright/inspection/thickness_series.hpp"

namespace gearwright {
namespace {

TEST(FlankTolerances, are_rounded_as_the_standard_says) {
  EXPECT_EQ(rounded_tolerance(10.4), 10.0);
  EXPECT_EQ(rounded_tolerance(10.6), 11.0);
  EXPECT_EQ(rounded_tolerance(10.0), 10.0);
  EXPECT_EQ(rounded_tolerance(7.3), 7.5);
  EXPECT_EQ(rounded_tolerance(5.2), 5.0);
  EXPECT_EQ(rounded_tolerance(4.96), 5.0);
  EXPECT_DOUBLE_EQ(rounded_tolerance(3.14), 3.1);
}

// d 100, m 6, b 36: the square roots of d and b are whole numbers, so the sums can be computed by
// hand.
TEST(FlankTolerances, of_the_formulas_by_hand) {
  const ToleranceSubject gear{100, 6, 36, 17, 0.0};
  const auto t = flank_tolerances(FlankTolerances::iso_2013, 5, gear);
  EXPECT_EQ(t.single_pitch, 7.5);       // 0.1 + 2.4 + 5 = 7.5
  EXPECT_EQ(t.cumulative_pitch, 22.0);  // 0.2 + 5.5 + 4.2 + 12 = 21.9
  EXPECT_EQ(t.profile_slope, 6.5);      // 2.4 + 0.1 + 4 = 6.5
  EXPECT_EQ(t.profile_form, 8.5);       // 3.3 + 5 = 8.3
  EXPECT_EQ(t.profile_total, 11.0);     // √(6.5² + 8.3²) = 10.54
  EXPECT_EQ(t.helix_slope, 6.5);        // 0.5 + 2.1 + 4 = 6.6
  EXPECT_EQ(t.helix_form, 7.5);         // 0.7 + 2.7 + 4 = 7.4
  EXPECT_EQ(t.helix_total, 10.0);       // √(6.6² + 7.4²) = 9.92
  EXPECT_EQ(t.runout, 20.0);            // 0.9 · 21.9 = 19.71
  // Tolerances of neighbouring classes differ by a factor of √2, so the tolerances of classes 5 and
  // 7 differ by a factor of 2.
  const auto coarse = flank_tolerances(FlankTolerances::iso_2013, 7, gear);
  EXPECT_EQ(coarse.single_pitch, 15.0);
  EXPECT_EQ(coarse.cumulative_pitch, 44.0);
  EXPECT_EQ(flank_tolerances(FlankTolerances::iso_2013, 6, gear).single_pitch, 11.0);  // 10.6
}

// Rows of the tables of ISO 1328-1:1995 and ISO 1328-2:1997.
TEST(FlankTolerances, of_1995_are_those_of_its_tables) {
  const ToleranceSubject gear{100, 3, 30, 33, 0.0};  // 50 to 125, 2 to 3.5, 20 to 40
  const auto t = flank_tolerances(FlankTolerances::iso_1995, 5, gear);
  EXPECT_EQ(t.single_pitch, 6.0);
  EXPECT_EQ(t.cumulative_pitch, 19.0);
  EXPECT_EQ(t.profile_total, 8.0);
  EXPECT_EQ(t.helix_total, 8.5);
  EXPECT_EQ(t.runout, 15.0);
  EXPECT_EQ(*t.radial_composite, 25.0);
  EXPECT_EQ(*t.tooth_radial_composite, 10.0);
  const ToleranceSubject small{20, 2, 10, 10, 0.0};  // limits belong to the lower range
  EXPECT_DOUBLE_EQ(flank_tolerances(FlankTolerances::iso_1995, 5, small).single_pitch, 4.7);
  EXPECT_FALSE(
      flank_tolerances(FlankTolerances::iso_1995, 5, {1200, 3, 30, 400, 0.0}).radial_composite);
}

// Printed by KISSsoft 03/2017 for stages of the 5 MW wind turbine of NREL, grade 6: the third stage
// (14:24/95, β 10°, ε_γ 2.884) and a planet (21:36, ε_γ 1.618 with its ring).
TEST(FlankTolerances, of_sectors_base_pitch_and_single_flank_are_those_of_printed_reports) {
  const double alpha_t = 20.284 / 180 * std::numbers::pi;
  const auto of = [&](double d, double b, int z) {
    return flank_tolerances(FlankTolerances::iso_1995, 6,
                            {d, 14, b, z, 10.0 / 180 * std::numbers::pi, alpha_t, 2.884});
  };
  const auto pinion = of(341.183, 360, 24), wheel = of(1350.514, 360, 95);
  EXPECT_EQ(pinion.single_pitch, 14.0);
  EXPECT_EQ(wheel.single_pitch, 17.0);
  EXPECT_EQ(pinion.profile_form, 18.0);
  EXPECT_EQ(wheel.profile_form, 22.0);
  EXPECT_EQ(pinion.helix_slope, 18.0);
  EXPECT_EQ(wheel.helix_slope, 19.0);
  EXPECT_NEAR(*pinion.base_pitch, 13.10, 0.05);
  EXPECT_NEAR(*wheel.base_pitch, 15.90, 0.05);
  EXPECT_EQ(*pinion.sector_pitch, 26.0);
  EXPECT_EQ(*wheel.sector_pitch, 43.0);
  EXPECT_EQ(*pinion.single_flank, 71.0);
  EXPECT_EQ(*wheel.single_flank, 103.0);
  EXPECT_EQ(*pinion.tooth_single_flank, 21.0);
  EXPECT_EQ(*wheel.tooth_single_flank, 24.0);
  const auto planet =
      flank_tolerances(FlankTolerances::iso_1995, 6, {756, 21, 550, 36, 0.0, std::nullopt, 1.618});
  EXPECT_EQ(*planet.single_flank, 105.0);
  EXPECT_EQ(*planet.tooth_single_flank, 38.0);
  EXPECT_FALSE(planet.base_pitch);
  // K is continuous at ε_γ = 4 and exists only for a pair. The tolerance of a sector of one pitch
  // equals the tolerance of the pitch.
  const auto at = [](std::optional<double> overlap, int z) {
    return flank_tolerances(FlankTolerances::iso_1995, 9,
                            {300, 5, 50, z, 0.0, std::nullopt, overlap});
  };
  EXPECT_EQ(*at(3.9999999, 60).tooth_single_flank, *at(4.0, 60).tooth_single_flank);
  EXPECT_FALSE(at(std::nullopt, 60).single_flank);
  EXPECT_FALSE(at(2.0, 15).sector_pitch);
  EXPECT_TRUE(at(2.0, 16).sector_pitch);
  const auto later =
      flank_tolerances(FlankTolerances::iso_2013, 6, {756, 21, 550, 36, 0.0, alpha_t, 1.618});
  EXPECT_FALSE(later.single_flank || later.tooth_single_flank);
  EXPECT_TRUE(later.base_pitch);
}

// According to [T10.37], the tolerance of k pitches lies on the straight line through f_ptT for k =
// 0 and F_pT for k = z/4. With z = 8 k, it is their mean before rounding.
TEST(FlankTolerances, of_a_sector_lie_between_pitch_and_total) {
  for (const int z : {16, 24, 80}) {
    const double m = 4.0, d = m * z;
    const auto t = flank_tolerances(FlankTolerances::iso_2013, 5, {d, m, 40, z, 0.0});
    const double f_pt = 0.001 * d + 0.4 * m + 5;
    const double F_p = 0.002 * d + 0.55 * std::sqrt(d) + 0.7 * m + 12;
    EXPECT_EQ(*t.sector_pitch, rounded_tolerance((f_pt + F_p) / 2)) << z;
  }
  EXPECT_FALSE(flank_tolerances(FlankTolerances::iso_2013, 5, {60, 4, 40, 15, 0.0}).sector_pitch);
}

// The printed reports contain f_Σβ and f_Σδ but not the bearing span L. For F_β = 27 µm, they print
// 27 and 54 µm, which corresponds to L = 2 b. For F_β = 30 µm, they print 19.5 and 39 µm, which
// corresponds to L = 1.3 b.
TEST(FlankTolerances, of_the_axes_grow_with_the_span_of_the_bearings) {
  FlankToleranceValues t{};
  set_axis_tolerances(t, 27.0, 360.0, 720.0);
  EXPECT_DOUBLE_EQ(*t.axis_deviation, 27.0);
  EXPECT_DOUBLE_EQ(*t.axis_inclination, 54.0);
  set_axis_tolerances(t, 30.0, 550.0, 715.0);
  EXPECT_NEAR(*t.axis_deviation, 19.5, 1e-12);
  EXPECT_NEAR(*t.axis_inclination, 39.0, 1e-12);
}

TEST(FlankTolerances, know_their_classes_and_sizes) {
  EXPECT_TRUE(has_class(FlankTolerances::iso_2013, 1));
  EXPECT_FALSE(has_class(FlankTolerances::iso_2013, 0));
  EXPECT_FALSE(has_class(FlankTolerances::iso_2013, 12));
  EXPECT_TRUE(has_class(FlankTolerances::iso_1995, 0));
  EXPECT_EQ(beyond_range(FlankTolerances::iso_2013, {100, 3, 30, 4, 0.0}),
            "number of teeth of 4 is outside its range of 5 to 1000");
  EXPECT_EQ(beyond_range(FlankTolerances::iso_1995, {12, 0.4, 3, 30, 0.0}),
            "normal module of 0.4 mm is outside its range of 0.5 mm to 70 mm");
  EXPECT_EQ(beyond_range(FlankTolerances::iso_2013, {100, 3, 3, 33, 0.0}),
            "face width of 3 mm is outside its range of 4 mm to 1200 mm");
  EXPECT_EQ(beyond_range(FlankTolerances::iso_2013, {100, 3, 30, 33, 0.8}),
            "helix angle of 45.8366° is outside its range of 0° to 45°");
  EXPECT_EQ(beyond_range(FlankTolerances::iso_1995, {100, 3, 30, 4, 0.8}), "");
  EXPECT_EQ(beyond_range(FlankTolerances::iso_2013, {100, 3, 30, 33, 0.3}), "");
}

TEST(ThicknessSeries, are_those_of_the_tables) {
  const auto cd25 = testing::taken(thickness_allowances("cd25", 100));
  EXPECT_DOUBLE_EQ(cd25[1], -0.070);
  EXPECT_DOUBLE_EQ(cd25[0], -0.110);
  const auto h21 = testing::taken(thickness_allowances("h21", 10));
  EXPECT_EQ(h21[1], 0.0);
  EXPECT_DOUBLE_EQ(h21[0], -0.003);
  for (const char* name : {"", "cd", "25", "cd20", "cd31", "x25", "cd25x", "cd2.5"})
    EXPECT_FALSE(thickness_allowances(name, 100)) << name;
  EXPECT_FALSE(thickness_allowances("cd25", 10001));
  EXPECT_DOUBLE_EQ(testing::taken(js_deviation("JS7", 100)), 0.0175);
  EXPECT_DOUBLE_EQ(testing::taken(js_deviation("js6", 120.0)), 0.011);
  EXPECT_DOUBLE_EQ(testing::taken(js_deviation("JS8", 120.1)), 0.0315);
  for (const char* name : {"JS", "JS0", "JS13", "H7", "JS7 ", ""})
    EXPECT_FALSE(js_deviation(name, 100)) << name;
  EXPECT_FALSE(js_deviation("JS7", 4000));
}

// Printed limits of common bores and keyways, in µm.
TEST(Tolerances, HolesAndKeyways) {
  const auto um = [](std::string_view fit, double size) {
    const auto mm = testing::taken(hole_deviations(fit, size));
    return std::array{std::round(1e4 * mm[0]) / 10, std::round(1e4 * mm[1]) / 10};
  };
  EXPECT_EQ(um("H7", 20), (std::array{0.0, 21.0}));
  EXPECT_EQ(um("H7", 50), (std::array{0.0, 25.0}));
  EXPECT_EQ(um("H8", 100), (std::array{0.0, 54.0}));
  EXPECT_EQ(um("JS9", 6), (std::array{-15.0, 15.0}));
  EXPECT_EQ(um("N9", 10), (std::array{-36.0, 0.0}));
  EXPECT_EQ(um("N9", 3), (std::array{-29.0, -4.0}));
  EXPECT_EQ(um("P9", 6), (std::array{-42.0, -12.0}));
  EXPECT_EQ(um("P9", 14), (std::array{-61.0, -18.0}));
  for (const char* fit : {"", "H", "H13", "h7", "P8", "G7", "9"})
    EXPECT_FALSE(hole_deviations(fit, 20)) << fit;
  EXPECT_FALSE(hole_deviations("P9", 130));
  EXPECT_FALSE(hole_deviations("H7", 4000));
  constexpr double kExternal = 1.0, kInternal = -1.0;
  const auto tip = [](const char* fit, double size, double side) {
    const auto mm = testing::taken(tip_deviations(fit, size, side));
    return std::array{std::round(1e4 * mm[0]) / 10, std::round(1e4 * mm[1]) / 10};
  };
  EXPECT_EQ(tip("h9", 50.5, kExternal), (std::array{-74.0, 0.0}));
  EXPECT_EQ(tip("js9", 6, kExternal), (std::array{-15.0, 15.0}));
  EXPECT_EQ(tip("H9", 50.5, kInternal), (std::array{0.0, 74.0}));
  EXPECT_EQ(tip("JS9", 6, kInternal), (std::array{-15.0, 15.0}));
  EXPECT_FALSE(std::signbit(tip("h9", 50.5, kExternal)[1]));
  for (const char* fit : {"", "h", "h13", "H9", "JS9", "k6", "9"})
    EXPECT_FALSE(tip_deviations(fit, 50, kExternal)) << fit;
  for (const char* fit : {"", "H", "H13", "h9", "js9", "K6", "9"})
    EXPECT_FALSE(tip_deviations(fit, 50, kInternal)) << fit;
  for (const auto& [fit, side] : {std::pair{"h9", kExternal}, {"H9", kInternal}})
    EXPECT_EQ(tip_deviations(fit, 4000, side).error().field, "tip_diameter");
  EXPECT_EQ(keyway_depth_deviation(6), 0.1);
  EXPECT_EQ(keyway_depth_deviation(8), 0.2);
  EXPECT_EQ(keyway_depth_deviation(36), 0.3);
}

// Keyways of hubs as printed in two tables of DIN 6885-1 that are not the source of the code. One
// is a list of single bores. The other is the catalogue Siemens MD 31.1 of 2016, from which the
// bores at the ends of the rows are taken. These two tables do not contain the bores from 260 mm to
// 380 mm, whose values here are those of the table in the code.
TEST(Tolerances, keyways_of_DIN_6885) {
  struct Printed {
    double bore, width, depth;
  };
  for (const Printed& p : std::vector<Printed>{
           {6, 2, 1},       {8, 2, 1},       {9, 3, 1.4},       {10, 3, 1.4},    {11, 4, 1.8},
           {12, 4, 1.8},    {13, 5, 2.3},    {17, 5, 2.3},      {18, 6, 2.8},    {38.5, 12, 3.3},
           {44, 12, 3.3},   {50, 14, 3.8},   {58, 16, 4.3},     {65, 18, 4.4},   {75, 20, 4.9},
           {85, 22, 5.4},   {95, 25, 5.4},   {110, 28, 6.4},    {130, 32, 7.4},  {150, 36, 8.4},
           {170, 40, 9.4},  {200, 45, 10.4}, {200.1, 50, 11.4}, {230, 50, 11.4}, {8.1, 3, 1.4},
           {22.1, 8, 3.3},  {30.1, 10, 3.3}, {110.1, 32, 7.4},  {260, 56, 12.4}, {290, 63, 12.4},
           {330, 70, 14.4}, {380, 80, 15.4}}) {
    const auto keyway = hub_keyway(p.bore);
    ASSERT_TRUE(keyway) << p.bore;
    EXPECT_EQ(keyway->width, p.width) << p.bore;
    EXPECT_EQ(keyway->depth, p.depth) << p.bore;
  }
  for (const double bore : {-1.0, 0.0, 5.999, 380.001, 500.0})
    EXPECT_FALSE(hub_keyway(bore)) << bore;
  HubKeyway before{0, 0};
  for (double bore = 6; bore <= 380; bore += 0.5) {
    const HubKeyway keyway = *hub_keyway(bore);
    EXPECT_TRUE(keyway.width >= before.width && keyway.depth >= before.depth) << bore;
    before = keyway;
  }
}

}  // namespace
}  // namespace gearwright
