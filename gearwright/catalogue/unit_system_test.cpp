#include "gearwright/catalogue/unit_system.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gearwright {
namespace {

TEST(UnitSystem, UnitsOfKeysOfSpecs) {
  EXPECT_EQ(unit_text(unit_of("life_h")), "h");
  EXPECT_EQ(unit_text(unit_of("surface_hardness_HV")), "HV");
  EXPECT_EQ(unit_text(unit_of("density_kg_per_m3")), "kg/m³");
  EXPECT_EQ(unit_text(unit_of("lubricant_viscosity_40C_mm2_s")), "mm²/s");
  EXPECT_EQ(unit_text(unit_of("housing_resistance_m2K_per_W")), "m²K/W");
  EXPECT_EQ(unit_text(unit_of("housing_area_m2")), "m²");
}

TEST(UnitSystem, NamesOfKeys) {
  const auto in = [](std::string_view key) { return key_in(UnitSystem::inch, key); };
  EXPECT_EQ(in("gear1.face_width_mm"), "gear1.face_width_in");
  EXPECT_EQ(in("tip_relief_um"), "tip_relief_uin");
  EXPECT_EQ(in("gap_curvature_per_mm"), "gap_curvature_per_in");
  EXPECT_EQ(in("sliding_velocity_mm_per_rad"), "sliding_velocity_in_per_rad");
  EXPECT_EQ(in("center_distance_deviations_mm[2]"), "center_distance_deviations_in[2]");
  for (const char* same :
       {"gear1.normal_module_mm", "module_mm", "modules_mm", "normal_diametral_pitch_per_in",
        "bearing_stiffness_N_per_um", "mesh_stiffness_N_per_mm_um", "own_um_per_N_mm",
        "helix_angle_deg", "teeth"}) {
    EXPECT_EQ(in(same), same);
    EXPECT_EQ(metric_key(same), same);
  }
  EXPECT_EQ(metric_key("gear1.face_width_in"), "gear1.face_width_mm");
  EXPECT_EQ(in("planetary.face_width_mm.sun"), "planetary.face_width_in.sun");
  EXPECT_EQ(in("gear1.measured.over_balls_mm[2].dimension_mm"),
            "gear1.measured.over_balls_in[2].dimension_in");
  for (const char* none : {"normal_module_in", "modules_in", "normal_diametral_pitch_per_mm"}) {
    EXPECT_EQ(inch_unit(none), nullptr) << none;
    EXPECT_EQ(metric_unit(none), nullptr) << none;
  }
  EXPECT_EQ(metric_unit("gear1.measured.span_mm.3"), metric_unit("span_mm"));
  EXPECT_EQ(metric_unit("scatter.errors.axial_mm.range[1]"), metric_unit("axial_mm"));
  EXPECT_EQ(metric_unit("scatter.errors.axial_mm.cpk"), nullptr);
  EXPECT_EQ(key_in(UnitSystem::mm, "face_width_mm"), "face_width_mm");
}

TEST(UnitSystem, DecimalsSurviveBothConversions) {
  const KeyUnit& mm = *metric_unit("a_mm");
  EXPECT_EQ(mm.to_inch(25.4), 1.0);
  EXPECT_EQ(mm.to_metric(1.5), 38.1);
  EXPECT_EQ(metric_unit("a_um")->to_metric(400), 10.16);
  EXPECT_EQ(metric_unit("a_per_mm")->to_inch(2), 50.8);
  std::mt19937 random(3);
  std::uniform_int_distribution<long long> digits(1, 999'999'999'999LL);
  for (int i = 0; i < 20'000; ++i) {
    const double x = static_cast<double>(digits(random)) / 1e9;
    EXPECT_EQ(mm.to_inch(mm.to_metric(x)), x);  // a number of an inch spec is printed as given
    EXPECT_EQ(mm.to_metric(x / 25.4), x) << x;  // a quotient of a mm spec gives its number
  }
}

TEST(UnitSystem, Sentences) {
  const auto in = [](std::string_view text) { return sentence_in(UnitSystem::inch, text); };
  EXPECT_EQ(in("a backlash of 0.1000 mm and no interference"),
            "a backlash of 0.00394 in and no interference");
  EXPECT_EQ(in("0.012 µm, less than 0.0001 modules (0.17 µm)."),
            "0.4724 µin, less than 0.0001 modules (6.693 µin).");
  EXPECT_EQ(in("between -0.1 mm and -0.2 mm of gear 1"),
            "between -0.003937 in and -0.007874 in of gear 1");
  EXPECT_EQ(in("b ≥ 3.52 mm, below 100 N/mm, 1200 N/mm², 80 mm²"),
            "b ≥ 0.1386 in, below 100 N/mm, 1200 N/mm², 80 mm²");
  // A limit is rounded to the safe side: 0.119/25.4 = 0.00468504, 36.248/25.4 = 1.42708661.
  EXPECT_EQ(in("at least 0.119 mm, at most 36.248 mm, about 36.248 mm"),
            "at least 0.004686 in, at most 1.427 in, about 1.427 in");
  EXPECT_EQ(in("at least 36.248 mm"), "at least 1.428 in");
  EXPECT_EQ(in("give gear1.bore.diameter_mm = 20, and a module of 2\u00a0mm"),
            "give gear1.bore.diameter_in = 0.7874, and a module of 2\u00a0mm");
  EXPECT_EQ(in("the gear plate_2_mm, the file out_mm/gear.step"),
            "the gear plate_2_mm, the file out_mm/gear.step");
  EXPECT_EQ(in("lies ±0.05 mm away"), "lies ±0.001969 in away");
  const std::string once = in("face_width_mm is not given; 20 mm (10 modules) is used.");
  EXPECT_EQ(once, "face_width_in is not given; 0.7874 in (10 modules) is used.");
  EXPECT_EQ(in(once), once);
  EXPECT_EQ(sentence_in(UnitSystem::inch, "must lie between 1 and 60, usually 14.5 to 30",
                        metric_unit("a_mm")),
            "must lie between 0.03937 and 2.362, usually 0.5709 to 1.181");
  EXPECT_EQ(
      sentence_in(UnitSystem::inch, "must be at most 3 times the module", metric_unit("a_mm")),
      "must be at most 3 times the module");
}

TEST(UnitSystem, UnitsOfQuantities) {
  EXPECT_EQ(unit_text(unit_in(UnitSystem::inch, Unit::mm)), "in");
  EXPECT_EQ(unit_text(unit_in(UnitSystem::inch, Unit::um)), "µin");
  EXPECT_EQ(unit_in(UnitSystem::inch, Unit::newton_per_mm), Unit::newton_per_mm);
  EXPECT_EQ(unit_in(UnitSystem::mm, Unit::mm), Unit::mm);
  EXPECT_EQ(digits_in(UnitSystem::inch, Unit::mm, 4), 5);
  EXPECT_EQ(digits_in(UnitSystem::inch, Unit::um, 3), 2);
  EXPECT_EQ(digits_in(UnitSystem::inch, Unit::per_mm, 6), 5);
  EXPECT_EQ(value_in(UnitSystem::inch, Unit::um, 25.4), 1000.0);
  EXPECT_EQ(unit_text(UnitSystem::inch, Unit::kg), "lb");
  EXPECT_EQ(value_in(UnitSystem::inch, Unit::kg, 0.45359237), 1.0);
  EXPECT_EQ(unit_text(UnitSystem::mm, Unit::kg), "kg");
  EXPECT_EQ(metric_unit("mass_kg"), nullptr);  // numbers in JSON and their keys are the same
}

}  // namespace
}  // namespace gearwright
