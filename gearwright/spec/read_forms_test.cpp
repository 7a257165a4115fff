// Values that have several forms: one number or a list, numbers by name, names of bodies, a range or
// a table, and the name of a series.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gearwright/drive/drive.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_search.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {
namespace {

const std::string kSet = "[planetary]\nsun = 20\nplanet = 30\nring = 80\nplanets = 3\n";
const std::string kStage = "[[stage]]\nteeth = [19, 58]\nnormal_module_mm = 2\n";
const std::string kScatter =
    "[gear1]\nteeth = 20\nnormal_module_mm = 2\n[gear2]\nteeth = 40\n[scatter.errors]\n";

// Returns the message if the spec is rejected, and an empty text if it is read.
std::string refused_form(const std::string& text) {
  const auto spec = read_spec(text, SpecFormat::toml);
  return spec ? "" : spec.error().message();
}

JobSpec read_form(const std::string& text) {
  auto spec = read_spec(text, SpecFormat::toml);
  if (!spec) throw std::runtime_error(spec.error().message());
  return std::move(spec).take();
}

TEST(ReadForms, one_number_or_numbers_by_name) {
  const JobSpec spec =
      read_form(kSet + "normal_module_mm = 2\nprofile_shift = { sun = 0.2 }\nface_width_mm = 20\n");
  const auto& gears = spec.drive->graph.gears;
  EXPECT_EQ(gears[0].shift, 0.2);
  EXPECT_EQ(gears[0].spec->face_width, 20.0);
  EXPECT_EQ(refused_form(kSet + "profile_shift = { moon = 0.2 }\n"),
            "planetary.profile_shift.moon = 0.2: unknown name; the names are sun, sun2, idler, "
            "planet, planet2, ring, ring2");
  EXPECT_EQ(refused_form(kSet + "profile_shift = [0.1, 0.2]\n"),
            "planetary.profile_shift = [0.1, 0.2]: must be a number, or a table of numbers by "
            "member");
  EXPECT_EQ(refused_form(kSet + "bore_mm = { sun = -1 }\n"),
            "planetary.bore_mm.sun = -1: must be greater than 0");
}

TEST(ReadForms, a_keyway_by_its_standard) {
  const std::string gear =
      "[gear1]\nteeth = 60\nnormal_module_mm = 2\n[gear1.bore]\nkeyway = \"DIN 6885-1\"\n";
  const auto bore = [&](const char* diameter) {
    return *read_form(gear + "diameter_mm = " + diameter).gears[0]->bore;
  };
  EXPECT_EQ(bore("25").keyway_width, 8.0);
  EXPECT_EQ(bore("25").keyway_depth, 3.3);
  EXPECT_EQ(bore("22").keyway_width, 6.0);
  EXPECT_EQ(
      refused_form(gear + "diameter_mm = 5.5"),
      "gear1.bore.keyway = \"DIN 6885-1\": has no keyway for a bore of 5.5 mm, because values "
      "are built in for bores of 6 to 380 mm; give keyway_width_mm and keyway_depth_mm");
  for (const char* own : {"keyway_width_mm = 8\nkeyway_depth_mm = 3.3", "keyway_width_mm = 8"})
    EXPECT_EQ(refused_form(gear + "diameter_mm = 25\n" + own),
              "gear1.bore.keyway = \"DIN 6885-1\": determines both keyway_width_mm and "
              "keyway_depth_mm; leave out these keys, or leave out keyway");
}

TEST(ReadForms, one_number_or_two_limits) {
  const JobSpec spec = read_form(kStage + "backlash_mm = [0.1, 0.2]\n");
  EXPECT_EQ(spec.drive->graph.meshes[0].backlash, (0.1 + 0.2) / 2);
  EXPECT_TRUE(spec.drive->graph.meshes[0].backlash_is_mean);
  EXPECT_FALSE(read_form(kStage + "backlash_mm = 0.1\n").drive->graph.meshes[0].backlash_is_mean);
  EXPECT_NE(refused_form(kStage + "backlash_mm = [0.2, 0.1]\n").find("rising order"),
            std::string::npos);
  EXPECT_EQ(refused_form(kStage + "backlash_mm = { sun_planet = 0.1 }\n"),
            "stage[1].backlash_mm = (a table): must not be a table, because a pair of gears has "
            "one mesh");
}

TEST(ReadForms, a_number_for_each_input_and_one_torque) {
  EXPECT_EQ(read_form(kSet + "input = [\"sun\", \"ring\"]\nfixed = []\nspeed_rpm = [100, 20]\n")
                .drive->graph.speeds_rpm,
            (std::vector{100.0, 20.0}));
  EXPECT_EQ(refused_form(kSet + "torque_Nm = [1, 2]\n"),
            "planetary.torque_Nm = [1, 2]: has 2 values, but must be one torque, which determines "
            "the torques of the other bodies");
  EXPECT_EQ(refused_form(kSet + "fixed = 3\n"),
            "planetary.fixed = 3: must be the name of a body, or a list of names");
}

TEST(ReadForms, as_many_speeds_as_inputs) {
  const std::string two = "has 2 numbers for 1 input; give one speed for each input";
  const std::string differential = kSet + "fixed = []\ninput = [\"sun\", \"ring\"]\n";
  EXPECT_EQ(refused_form(kSet + "speed_rpm = [100]\n"), "");
  EXPECT_EQ(refused_form(kSet + "speed_rpm = [100, 200]\n"),
            "planetary.speed_rpm = [100, 200]: " + two);
  EXPECT_EQ(refused_form(differential), "");
  EXPECT_EQ(refused_form(differential + "speed_rpm = 100\n"),
            "planetary.speed_rpm = 100: has 1 number for 2 inputs; give one speed for each input");
  EXPECT_EQ(refused_form(kStage + "speed_rpm = [10000, 1]\n"),
            "stage[1].speed_rpm = [10000, 1]: " + two);
  EXPECT_EQ(refused_form("[drive]\ninput = \"a\"\noutput = \"b\"\nspeed_rpm = [100, 200]\n"
                         "[[drive.body]]\nname = \"a\"\n[[drive.body]]\nname = \"b\"\n"
                         "[[drive.gear]]\nname = \"A\"\nbody = \"a\"\nteeth = 20\n"
                         "[[drive.gear]]\nname = \"B\"\nbody = \"b\"\nteeth = 40\n"
                         "[[drive.mesh]]\ngears = [\"A\", \"B\"]\n"),
            "drive.speed_rpm = [100, 200]: " + two);
  EXPECT_EQ(refused_form("[search]\nkind = \"planetary\"\nratio = 4\nspeed_rpm = [100, 200]\n"),
            "search.speed_rpm = [100, 200]: " + two);
}

TEST(ReadForms, a_planet_has_positions_in_place_of_an_angle) {
  const auto graph = [](const std::string& sun, const std::string& housing) {
    return "[drive]\ninput = \"s\"\noutput = \"c\"\nfixed = \"r\"\n"
           "body = [{ name = \"s\" }, { name = \"r\" }, { name = \"c\" }, "
           "{ name = \"p\", rides_on = \"c\", count = 3 }, { name = \"x\" }]\n"
           "gear = [{ name = \"S\", body = \"s\", teeth = 20 }, "
           "{ name = \"P\", body = \"p\", teeth = 25 }, "
           "{ name = \"R\", body = \"r\", teeth = -70 }, "
           "{ name = \"X\", body = \"x\", teeth = 30 }]\n"
           "mesh = [{ gears = [\"S\", \"P\"]" +
           sun + " }, { gears = [\"P\", \"R\"] }, { gears = [\"X\", \"S\"]" + housing + " }]\n";
  };
  EXPECT_EQ(refused_form(graph("", ", angle_deg = 10")), "");
  EXPECT_EQ(refused_form(graph(", angle_deg = 10", "")),
            "drive.mesh[1].angle_deg = 10: is not allowed for planets, whose positions determine "
            "the direction; give positions_deg of the planet");
}

TEST(ReadForms, names_of_gears_and_meshes_that_the_set_has) {
  for (const char* key : {"profile_shift", "bore_mm"})
    EXPECT_EQ(refused_form(kSet + key + " = { sun = 0.2, sun2 = 0.2 }\n"),
              std::string("planetary.") + key +
                  ".sun2 = 0.2: is not a gear of this set; the names are sun, planet, ring");
  for (const char* key : {"center_distance_mm", "mesh_efficiency"})
    EXPECT_EQ(refused_form(kSet + key + " = { sun2_planet = 0.5 }\n"),
              std::string("planetary.") + key +
                  ".sun2_planet = 0.5: is not a mesh of this set; the names are sun_planet, "
                  "planet_ring");
  EXPECT_EQ(
      refused_form(kSet + "material = { sun2 = \"16MnCr5\" }\n").find("planetary.material.sun2"),
      0u);
  EXPECT_EQ(refused_form("[planetary]\nsun = 20\nring = 80\nprofile_shift = { planet = 0.1 }\n"),
            "");
}

TEST(ReadForms, names_of_gears_and_meshes_that_the_drives_of_a_search_have) {
  const std::string search = "[search]\nratio = [4, 5]\nnormal_module_mm = 2\nkind = ";
  EXPECT_EQ(
      refused_form(search + "\"planetary\"\nprofile_shift = { sun2 = 0.2 }\n"),
      "search.profile_shift.sun2 = 0.2: is not a gear of this set; the names are sun, planet, "
      "ring");
  EXPECT_EQ(refused_form(search + "\"stepped\"\nmesh_efficiency = { planet_ring = 0.99 }\n"),
            "search.mesh_efficiency.planet_ring = 0.99: is not a mesh of this set; the names are "
            "sun_planet, planet_ring2");
  EXPECT_EQ(refused_form(search + "\"planetary\"\nprofile_shift = { sun = 0.2 }\n"
                                  "mesh_efficiency = { planet_ring = 0.99 }\n"),
            "");
}

TEST(ReadForms, a_list_of_bodies_contains_no_body_twice) {
  EXPECT_EQ(refused_form(kSet + "fixed = [\"ring\", \"ring\"]\n"),
            "planetary.fixed = [\"ring\", \"ring\"]: contains ring twice");
  EXPECT_EQ(refused_form(kSet + "fixed = []\ninput = [\"sun\", \"sun\"]\n"),
            "planetary.input = [\"sun\", \"sun\"]: contains sun twice");
}

// The torque of a power is P/ω. The oracle is P n = T n² 2π/60 for 11 kW and 1450/min.
TEST(ReadForms, a_power_gives_the_torque) {
  constexpr double kTorque = 11e3 * 60 / (2 * 3.14159265358979323846 * 1450);
  const std::string power = "speed_rpm = 1450\npower_kW = 11\n";
  const std::string second = "[[stage]]\nteeth = [17, 61]\n";
  for (const std::string& spec :
       {kSet + power, kStage + power, "[[stage]]\nplanetary = { sun = 20, ring = 80 }\n" + power,
        "[drive]\ninput = \"a\"\noutput = \"b\"\n" + power +
            "[[drive.body]]\nname = \"a\"\n[[drive.body]]\nname = \"b\"\n"
            "[[drive.gear]]\nname = \"one\"\nbody = \"a\"\nteeth = 20\n"
            "[[drive.gear]]\nname = \"two\"\nbody = \"b\"\nteeth = 40\n"
            "[[drive.mesh]]\ngears = [\"one\", \"two\"]\n"})
    EXPECT_NEAR(read_form(spec).drive->graph.torque_Nm.value(), kTorque, 1e-12) << spec;
  EXPECT_EQ(read_form(kSet + "speed_rpm = -1450\npower_kW = 11\n").drive->graph.torque_Nm,
            -*read_form(kSet + power).drive->graph.torque_Nm);
  const std::string needs =
      "power_kW = 11: needs the speed of the input, which must not be 0; give speed_rpm, or give "
      "torque_Nm in place of the power";
  EXPECT_EQ(refused_form(kSet + "power_kW = 11\n"), "planetary." + needs);
  EXPECT_EQ(refused_form(kSet + "power_kW = 11\nspeed_rpm = 0\n"), "planetary." + needs);
  EXPECT_EQ(refused_form(kStage + "power_kW = 11\n" + second), "stage[1]." + needs);
  EXPECT_NE(refused_form(kSet + power + "torque_Nm = 72\n").find("power_kW"), std::string::npos);
  EXPECT_TRUE(refused_form(kStage + second + power)
                  .starts_with("stage[2].power_kW = 11: must not be given, because the first"));
}

TEST(ReadForms, a_planet_follows_from_sun_and_ring) {
  const auto planet = [](const std::string& keys) {
    return read_form("[planetary]\n" + keys).drive->graph.gears[1].teeth;
  };
  EXPECT_EQ(planet("sun = 20\nring = 80\n"), 30);
  EXPECT_EQ(planet("sun = 19\nring = -57\n"), 19);
  EXPECT_EQ(planet("sun = 20\nplanet = 29\nring = 80\n"), 29);
  EXPECT_EQ(
      refused_form("[planetary]\nsun = 20\nring = 79\n"),
      "planetary.planet: is missing; its default is (ring − sun)/2 = 29.5, which is not a whole "
      "number. Give planet = 29 or 30, for which the profile shifts follow from the common centre "
      "distance, or give ring = 78 or 80");
  EXPECT_EQ(refused_form("[planetary]\nsun = 20\nring = 21\n"),
            "planetary.ring = 21: must have at least 22 teeth, because the planets are between the "
            "ring and the sun, which has 20 teeth");
  EXPECT_NE(refused_form("[planetary]\nsun = 20\nring2 = 80\n").find("planet = 20"),
            std::string::npos);
}

TEST(ReadForms, a_coaxial_output_names_its_stage) {
  const std::string stages =
      "[[stage]]\nteeth = [20, 60]\nnormal_module_mm = 2\n[[stage]]\n"
      "teeth = [20, 61]\nnormal_module_mm = 2\nangle_deg = \"coaxial\"\n";
  EXPECT_TRUE(refused_form(stages).starts_with("stage[2].angle_deg = \"coaxial\": is impossible"))
      << refused_form(stages);
}

TEST(ReadForms, a_range_or_a_table_with_a_distribution) {
  const JobSpec spec = read_form(kScatter +
                                 "crossing_deg = [-0.1, 0.2]\naxial_mm = { range = [-1, 1], "
                                 "distribution = \"normal\", cpk = 1.5 }\n");
  EXPECT_EQ(spec.scatter.errors[1]->range, (std::array{-0.1, 0.2}));
  EXPECT_EQ(spec.scatter.errors[3]->cpk, 1.5);
  const std::string key = "scatter.errors.crossing_deg";
  EXPECT_EQ(refused_form(kScatter + "crossing_deg = 0.02\n"),
            key +
                " = 0.02: must be [least, greatest], or a table with range and distribution; a "
                "tolerance of ±0.02 is [-0.02, 0.02]");
  EXPECT_EQ(refused_form(kScatter + "crossing_deg = [0.1, -0.1]\n"),
            key +
                " = [0.1, -0.1]: must contain the least value before the greatest; a tolerance "
                "of ±0.02 is [-0.02, 0.02]");
  EXPECT_EQ(refused_form(kScatter + "crossing_deg = { range = [-1, 1], cpk = 1 }\n"),
            key + ".cpk = 1: is used only with distribution = \"normal\"");
  EXPECT_NE(refused_form(kScatter + "crossing_deg = { range = [-1, 99] }\n").find(key),
            std::string::npos);
}

TEST(ReadForms, numbers_or_the_name_of_a_series) {
  const auto modules = [](const std::string& value) {
    return read_form("[search]\nratio = 2\n" + value).search->modules;
  };
  EXPECT_EQ(modules("modules_mm = [3, 1]\n"), (std::vector{1.0, 3.0}));
  EXPECT_EQ(modules("").size(), 18u);
  EXPECT_EQ(modules("modules_mm = \"ISO54-I+II\"\n").size(), 36u);
  EXPECT_EQ(modules("diametral_pitches_per_in = [10, 5]\n"), (std::vector{2.54, 5.08}));
  EXPECT_EQ(refused_form("[search]\nratio = 2\nmodules_mm = [2, 2]\n"),
            "search.modules_mm = [2, 2]: contains 2 twice");
  EXPECT_EQ(refused_form("[search]\nratio = 2\nmodules_mm = \"ISO\"\n"),
            "search.modules_mm = \"ISO\": must be \"ISO54-I\", \"ISO54-I+II\", \"ISO54-II\", a "
            "number or a list of numbers in mm");
}

TEST(ReadForms, a_search_reads_the_numbers_of_a_set) {
  const std::string search = "[search]\nkind = \"planetary\"\nratio = [4, 5]\n";
  const JobSpec spec = read_form(search +
                                 "helix_angle_deg = { sun = 10 }\nnormal_module_mm = 2\n"
                                 "face_width_mm = [20, 40]\n");
  const DriveSearchProblem p = read_drive_search(spec.tree->tables["search"]);
  EXPECT_EQ(p.base.helix_deg.of(SetMember::sun), 10.0);
  EXPECT_EQ(p.face_width, (std::array{20.0, 40.0}));
  EXPECT_FALSE(p.base.face_width.all);
  EXPECT_EQ(refused_form("[search]\nkind = \"train\"\nratio = 8\nhelix_angle_deg = { sun = 10 }\n"),
            "search.helix_angle_deg = (a table): must be one number for all stages of a train");
}

TEST(ReadForms, a_quantity_is_given_by_one_of_several_keys) {
  const std::string gear = "[gear1]\nteeth = 20\n";
  const auto of = [&](const std::string& keys) {
    return read_form(gear + keys).gear(1).cylindrical;
  };
  EXPECT_EQ(of("normal_diametral_pitch_per_in = 10\n").normal_module, 2.54);
  EXPECT_NEAR(of("transverse_module_mm = 2\nhelix_angle_deg = 60\n").normal_module, 1.0, 1e-15);
  EXPECT_EQ(refused_form(gear + "normal_module_mm = 2\nnormal_diametral_pitch_per_in = 10\n"),
            "gear1.normal_diametral_pitch_per_in = 10: contradicts normal_module_mm, because both "
            "keys give the normal module; leave out one of the two");
}

// A cutter takes the helix angle of its gear with the opposite hand, and that of a ring with the
// same hand, in whichever way the gear gives the angle.
TEST(ReadForms, a_cutter_takes_the_helix_angle_of_its_gear) {
  const auto helix_of_cutter = [](int teeth, const std::string& keys) {
    const JobSpec spec =
        read_form("[gear1]\nteeth = " + std::to_string(teeth) + "\nnormal_module_mm = 2\n" + keys +
                  "[gear1.cut_by]\nteeth = 20\n");
    return spec.gear(1).cut_by->cutter->cylindrical.helix_angle.deg();
  };
  for (const int teeth : {60, -60}) {
    const double own = teeth > 0 ? -15.0 : 15.0;
    EXPECT_NEAR(helix_of_cutter(teeth, "helix_angle_deg = 15\n"), own, 1e-12);
    EXPECT_NEAR(helix_of_cutter(teeth, "lead_angle_deg = 75\nhand = \"right\"\n"), own, 1e-12);
    EXPECT_NEAR(helix_of_cutter(teeth, "lead_angle_deg = 75\nhand = \"left\"\n"), -own, 1e-12);
  }
  EXPECT_NE(refused_form("[gear1]\nteeth = 0\nnormal_module_mm = 2\nhelix_angle_deg = 15\n"
                         "[gear1.cut_by]\nteeth = 20\n")
                .find("gear1.teeth = 0: must not be 0"),
            std::string::npos);
}

}  // namespace
}  // namespace gearwright
