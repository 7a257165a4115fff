// Interfaces of drives: (1) a spec and the graph to which it expands have the same numbers; (2)
// gears of stages and of the graph take the keys of a gear, and impossible values are rejected; (3)
// the verb `rate` rates every mesh; (4) an error of the teeth of a rack is rejected; (5) keys without
// effect and contradictions are named.
#include "gearwright/job/drive_answer.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/testing/drive_spec.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_drive.hpp"

namespace gearwright {
namespace {

using testing::drive_job;
using testing::drive_record;
using testing::refused_drive_key;

constexpr const char* kSet = R"(
[planetary]
sun = 20
planet = 25
ring = 70
planets = 3
normal_module_mm = 2
helix_angle_deg = 12
profile_shift = { sun = 0.2, planet = 0.1 }
thickness_allowance_mm = { sun = -0.05, planet = -0.06 }
tip_diameter_mm = { ring = 141 }
mesh_efficiency = { sun_planet = 0.985 }
speed_rpm = 1500
torque_Nm = 40
material = { sun = { name = "17CrNiMo6" }, planet = { name = "34CrNiMo6" } }
)";

constexpr const char* kTrain = R"(
[[stage]]
planetary = { sun = 20, planet = 19, ring = 58, planets = 4, spacing = "opposite" }
normal_module_mm = 2
friction_coefficient = 0.07
speed_rpm = 1500
torque_Nm = 40
[[stage]]
gears = [ { teeth = 19, normal_module_mm = 3, helix_angle_deg = 10, modifications = { profile_crowning_um = 12, lead_crowning_um = 6 } }, { teeth = 58 } ]
)";

TEST(DriveAnswerTest, ExpandedSpecsHaveTheSameNumbers) {
  for (const char* toml : {kSet, kTrain}) {
    const JobSpec spec = drive_job(toml);
    const auto answer = answer_drive(spec);
    ASSERT_TRUE(answer) << answer.error().message();
    const DriveSpecs specs = answer->drive_specs();
    EXPECT_EQ(specs.meshes.size(), answer->record["drive"]["meshes"].size());
    const std::string text = toml_text(specs.expanded);
    Json expected = answer->record["drive"];
    Json got = drive_record(drive_job(text));
    expected.erase("stages");
    got.erase("stages");
    EXPECT_EQ(json_text(got), json_text(expected)) << text;
    EXPECT_EQ(drive_materials(specs.expanded).size(), drive_materials(spec.tree->tables).size());
  }
}

TEST(DriveAnswerTest, StagesKeepTheirOwnSpacingAndGears) {
  const Json drive = drive_record(drive_job(kTrain));
  EXPECT_EQ(drive["assembly"]["angles_deg"][2], 180.0);
  EXPECT_EQ(drive["bodies"]["s1_sun"]["speed_rpm"], 1500.0);
  // The second gear takes the module and the opposite helix angle of the first gear.
  EXPECT_EQ(drive["meshes"]["s2_gear1_gear2"]["pair"]["kind"], "parallel_external");
  EXPECT_GT(drive["transmission_error"]["output_arcsec_peak_to_peak"], 0.1);
}

// A torque needs the efficiencies of the meshes. Without friction, they are 1.
TEST(DriveAnswerTest, ATorqueWithoutAModuleHasAnEffectOrANote) {
  const std::string set = "[planetary]\nsun = 20\nplanet = 25\nring = 70\nspeed_rpm = 100\n";
  for (const char* load : {"torque_Nm = 10\n", "power_kW = 1\n"}) {
    const DriveJob without = testing::taken(solve_drive(drive_job(set + load)));
    ASSERT_EQ(without.drive.findings.size(), 1u);
    EXPECT_EQ(without.drive.findings.front().code, WarningCode::not_read);
    EXPECT_NE(without.drive.findings.front().message.find(
                  "the efficiencies of sun_planet and planet_ring are unknown; give "
                  "mesh_efficiency, or give normal_module_mm"),
              std::string::npos)
        << without.drive.findings.front().message;
    for (const char* known : {"mesh_efficiency = 0.99\n", "friction_coefficient = 0\n"}) {
      const DriveJob made = testing::taken(solve_drive(drive_job(set + load + known)));
      EXPECT_TRUE(made.drive.findings.empty());
      ASSERT_TRUE(made.drive.flow) << known;
      if (std::string(known).starts_with("friction")) {
        EXPECT_NEAR(made.drive.flow->torque[made.drive.graph.output], -4.5, 1e-12);
        EXPECT_NEAR(made.drive.flow->efficiency, 1.0, 1e-12);
      }
    }
  }
  EXPECT_TRUE(testing::taken(solve_drive(drive_job(set))).drive.findings.empty());
}

// A drive that its files cannot contain, because the gears do not fit together, is red. If the
// directions of a loop are not given, other positions of its axes may be possible.
TEST(DriveAnswerTest, DrivesThatCannotBeAssembledAreRed) {
  const auto drive = [](const std::string& bodies, const std::string& teeth,
                        const std::vector<std::pair<std::string, std::string>>& meshes) {
    std::string text = "[drive]\ninput = \"a\"\noutput = \"" + bodies.substr(1, 1) + "\"\n";
    for (const char body : bodies)
      text += fmt::format("[[drive.body]]\nname = \"{}\"\n{}", body,
                          body == 'r' ? "rides_on = \"a\"\n" : "");
    for (std::size_t g = 0; g < teeth.size(); ++g)
      text += fmt::format(
          "[[drive.gear]]\nname = \"{0}\"\nbody = \"{0}\"\nteeth = {1}0\nnormal_module_mm = "
          "2\n",
          bodies[g], teeth[g]);
    for (const auto& [gears, keys] : meshes)
      text +=
          fmt::format("[[drive.mesh]]\ngears = [\"{}\", \"{}\"]\n{}\n", gears[0], gears[1], keys);
    return testing::taken(solve_drive(drive_job(text)));
  };
  const auto loop = [&](const std::string& angle, const std::string& opposite) {
    return drive(
        "abcd", "2332",
        {{"ab", "angle_deg = 60"}, {"ac", "angle_deg = -60"}, {"bd", angle}, {"cd", opposite}});
  };
  for (const auto& [job, words] :
       {std::pair{drive("abr", "232", {{"ab", ""}, {"rb", ""}}), "a_b: the two gears of this mesh"},
        {loop("angle_deg = 0", "angle_deg = 0"), "100.0000 mm apart instead of 50.0000 mm"},
        {loop("angle_deg = -60", "angle_deg = 60"), "c_d: this mesh closes a loop of gears"}}) {
    EXPECT_FALSE(job.layout);
    EXPECT_EQ(job.verdict.level, Level::red) << words;
    EXPECT_EQ(job.verdict.findings.front().code, WarningCode::not_coaxial);
    EXPECT_NE(job.verdict.headline.find(words), std::string::npos) << job.verdict.headline;
    EXPECT_EQ(job.layout_error.field, "drive.mesh");
    EXPECT_TRUE(job.layout_error.rule.starts_with("the drive cannot be assembled, because "));
  }
  const DriveJob open = loop("", "");
  EXPECT_NE(open.verdict.level, Level::red) << open.verdict.headline;
}

// The gears that mesh with a planet are coaxial, so two distances are a contradiction.
TEST(DriveAnswerTest, TwoDistancesOfAPlanetNameTheirKeys) {
  const std::string set = "sun = 20\nplanet = 25\nring = 70\nplanets = 3\n";
  const auto distances = [](double second) {
    return fmt::format(
        "normal_module_mm = 2\ncenter_distance_mm = {{ sun_planet = 45, planet_ring = {} }}\n",
        second);
  };
  const auto error_of = [](const JobSpec& spec) {
    const auto solved = solve_drive(spec);
    return solved ? "" : solved.error().message();
  };
  const std::string rule =
      " = 46: contradicts the centre distance of 45 mm that is given for the mesh ";
  const JobSpec job = drive_job("[planetary]\n" + set + distances(46));
  EXPECT_TRUE(error_of(job).starts_with("planetary.center_distance_mm.planet_ring" + rule +
                                        "sun_planet, because"))
      << error_of(job);
  const JobSpec graph = drive_job(toml_text(expanded_spec(job.tree->tables, *job.drive)));
  EXPECT_TRUE(error_of(graph).starts_with("drive.mesh[2].center_distance_mm" + rule));
  const JobSpec train = drive_job("[[stage]]\n" + distances(46) +
                                  "planetary = { sun = 20, planet = 25, ring = 70 }\n");
  EXPECT_TRUE(error_of(train).starts_with("stage[1].center_distance_mm.planet_ring" + rule))
      << error_of(train);
  EXPECT_EQ(error_of(drive_job("[planetary]\n" + set + distances(45))), "");
}

TEST(DriveAnswerTest, GearsOfADriveAreRefusedWhatTheyCannotBe) {
  const auto stage = [](const std::string& gear) {
    return "[[stage]]\ngears = [ { teeth = 19, normal_module_mm = 2, " + gear +
           " }, { teeth = 58 } ]\n";
  };
  EXPECT_EQ(refused_drive_key(stage("profile_shift = 0.1")), "");
  EXPECT_EQ(refused_drive_key(stage("cut_by = \"gear2\"")), "stage[1].gears[1].cut_by");
  EXPECT_EQ(refused_drive_key(stage("tip_fillet = { radius_mm = 0.2 }")),
            "stage[1].gears[1].tip_fillet");
  EXPECT_EQ(refused_drive_key(stage("tolerance = { thickness_series = \"cd25\" }")),
            "stage[1].gears[1].tolerance.thickness_series");
  EXPECT_EQ(refused_drive_key("[planetary]\nplanet = 20\nring = 60\nmaterial = { sun = 3 }\n"),
            "planetary.material.sun.material");
  EXPECT_EQ(refused_drive_key("[search]\nkind = \"planetary\"\nratio = 4\nstages = 2\n"),
            "search.stages");
  EXPECT_EQ(refused_drive_key("[search]\nkind = \"planetary\"\nratio = 4\nsun2_teeth = 20\n"),
            "search.sun2_teeth");
}

// The rule is that of a pair. The tip diameter of 21 teeth, m_n = 2, is 46 mm.
TEST(DriveAnswerTest, ModificationsOfItsGearsMustFitTheirFlanks) {
  const auto error_of = [](const std::string& modifications) {
    const auto solved = solve_drive(
        drive_job("[[stage]]\ngears = [ { teeth = 21, normal_module_mm = 2, face_width_mm = 20, "
                  "modifications = { " +
                  modifications + " } }, { teeth = 43 } ]\n"));
    return solved ? "" : solved.error().message();
  };
  EXPECT_EQ(error_of("tip_relief_um = 10, tip_relief_start_mm = 44.5"), "");
  EXPECT_EQ(error_of("tip_relief_um = 10"), "");  // each mesh places its start
  const std::string outside = error_of("tip_relief_um = 10, tip_relief_start_mm = 47");
  EXPECT_EQ(outside.find("stage[1].gears[1].modifications."), 0u) << outside;
  EXPECT_NE(outside.find("tip_relief_start_mm = 47: must lie on the usable flank"), outside.npos)
      << outside;
  EXPECT_NE(error_of("end_relief_um = 10, end_relief_length_mm = 11"), "");
}

// Law (5). The same error of the pinion is computed.
TEST(DriveAnswerTest, ErrorsOfTheTeethOfARackAreRejected) {
  const auto drive_with = [](const std::string& error) {
    return answer_drive(drive_job(
        "[errors]\n" + error +
        "\n[drive]\ninput = \"shaft\"\noutput = \"bar\"\n"
        "[[drive.body]]\nname = \"shaft\"\n[[drive.body]]\nname = \"bar\"\n"
        "[[drive.gear]]\nname = \"pinion\"\nbody = \"shaft\"\nteeth = 20\nnormal_module_mm = 2\n"
        "[[drive.gear]]\nname = \"rack\"\nbody = \"bar\"\nform = \"rack\"\n"
        "[[drive.mesh]]\ngears = [\"pinion\", \"rack\"]\n"));
  };
  const auto of_rack = drive_with("helix_slope2_um = 10");
  ASSERT_FALSE(of_rack);
  EXPECT_EQ(of_rack.error().field, "errors.helix_twist[1]");
  const auto of_pinion = drive_with("helix_slope1_um = 10");
  ASSERT_TRUE(of_pinion) << of_pinion.error().message();
  EXPECT_TRUE(of_pinion->record["drive"]["transmission_error"].is_object());
}

TEST(DriveAnswerTest, RateRatesEveryMesh) {
  const JobSpec spec = drive_job(std::string(kSet) +
                                 "[rating]\nquality = [6, 6]\nface_load_factor = 1.2\n"
                                 "mesh_load_factor = 1.15\nsafety_root_min = 30\n"
                                 "material = { name = \"42CrMo4\" }\n");
  const auto answer = answer_drive_rating(spec);
  ASSERT_TRUE(answer) << answer.error().message();
  const Json& meshes = answer->record["drive"]["meshes"];
  for (const char* mesh : {"sun_planet", "planet_ring"}) {
    const Json& rating = meshes[mesh]["rating"];
    EXPECT_GT(rating["S_H"][0], 0.1) << mesh;
    EXPECT_EQ(rating["K_gamma"], 1.15);
  }
  EXPECT_EQ(meshes["sun_planet"]["rating"]["Y_M"][1], 0.7);
  EXPECT_EQ(meshes["planet_ring"]["rating"]["Y_M"][0], 0.7);
  // The required safety of 30 is not reached.
  EXPECT_NE(answer->verdict->level, Level::green);
  const auto without = answer_drive(spec);
  ASSERT_TRUE(without);
  EXPECT_EQ(without->verdict->not_judged, std::vector<std::string>{"rating"});
  EXPECT_FALSE(without->record["drive"]["meshes"]["sun_planet"].contains("rating"));
}

// The pin of the first planet is 200 µm ahead, so two planets share the load and K_γ is below 2.
TEST(DriveAnswerTest, APlanetWithoutLoadIsAFinding) {
  const auto judged = [](const std::string& rest) {
    const auto answer = answer_drive(drive_job(
        "[planetary]\nsun = 20\nplanet = 25\nring = 70\nplanets = 3\nnormal_module_mm = 2\n"
        "face_width_mm = 20\nthickness_allowance_mm = -0.06\ntorque_Nm = 120\n"
        "[load]\naccuracy = \"draft\"\npositions = 4\npin_error_um = " +
        rest));
    EXPECT_TRUE(answer) << answer.error().message();
    return answer->verdict.value();
  };
  const Verdict idle = judged("[200, 0, 0]\n");
  EXPECT_EQ(idle.level, Level::amber);
  ASSERT_EQ(idle.findings.front().code, WarningCode::mesh_load_factor);
  EXPECT_NE(idle.findings.front().message.find("Planet 1 of 3 carries no load at any position"),
            std::string::npos)
      << idle.findings.front().message;
  EXPECT_EQ(judged("[4, 0, 0]\n").level, Level::green);
}

// `drive` does not rate, but it rejects the same contradictions as `rate`.
TEST(DriveAnswerTest, ALoadOfTheRatingThatContradictsTheDriveIsAnErrorOfEveryVerb) {
  const std::string set = kSet;  // 40 N m at 1500 1/min
  for (const auto& [rating, field] :
       {std::pair{"[rating]\ntorque_Nm = 41\n", "rating.torque_Nm"},
        std::pair{"[rating]\nspeed_rpm = 1400\n", "rating.speed_rpm"}}) {
    const JobSpec spec = drive_job(set + rating);
    const auto answer = answer_drive(spec), rated = answer_drive_rating(spec);
    ASSERT_FALSE(answer) << field;
    ASSERT_FALSE(rated) << field;
    EXPECT_EQ(answer.error().field, field);
    EXPECT_EQ(rated.error().field, field);
  }
  EXPECT_TRUE(answer_drive(drive_job(set + "[rating]\ntorque_Nm = 40\nspeed_rpm = 1500\n")));
}

TEST(DriveAnswerTest, TablesWithoutEffectAreNamed) {
  const auto answer = answer_drive(drive_job(std::string(kSet) + "[scatter]\nquality = 6\n"));
  ASSERT_TRUE(answer) << answer.error().message();
  std::string said;
  for (const Warning& w : answer->warnings)
    if (w.code == WarningCode::not_read) said += w.message;
  EXPECT_NE(said.find("[scatter] has no effect on a drive"), said.npos) << said;
  const auto plain = answer_drive(drive_job(kSet));
  ASSERT_TRUE(plain) << plain.error().message();
  for (const Warning& w : plain->warnings)
    EXPECT_TRUE(w.code != WarningCode::not_read) << w.message;
}

TEST(DriveAnswerTest, FindingsNameKeysWithoutBackticks) {
  const auto job = solve_whole_drive(drive_job(kSet));
  ASSERT_TRUE(job) << job.error().message();
  EXPECT_FALSE(job->verdict.findings.empty());
  for (const Finding& f : job->verdict.findings)
    EXPECT_EQ((f.message + f.remedy).find('`'), std::string::npos) << f.message;
}

}  // namespace
}  // namespace gearwright
