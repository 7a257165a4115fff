// Searches for drives: (1) a drive in the result has the numbers that the verb `drive` computes for
// its spec; (2) the chosen profile shifts, the limits of sliding and the thickness series hold for
// each drive; (3) found drives have the load of [rating].
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

TEST(DriveSearchAnswerTest, SearchesHaveTheNumbersOfTheirSpecs) {
  for (const std::string search :
       {"kind = \"planetary\"\nratio = [4.4, 4.6]\nplanets = [3, 4]\nsun_teeth = [15, 24]\n"
        "objective = [\"efficiency\", \"size\"]",
        "kind = \"wolfrom\"\nratio = [-60, 60]\nplanet_teeth = [20, 22]\nmesh_efficiency = 0.99",
        "kind = \"two_suns\"\nratio = [-40, -10]\nplanets = 2\nplanet_teeth = [38, 40]\n"
        "mesh_efficiency = 0.98",
        "kind = \"train\"\nratio = [11.9, 12.1]\npinion_teeth = [17, 19]\nwheel_teeth = [55, "
        "70]"}) {
    const JobSpec spec =
        drive_job("[search]\n" + search + "\nnormal_module_mm = 2\nspeed_rpm = 1500\n");
    ASSERT_TRUE(searches_drives(spec));
    const auto answer = answer_drive_search(spec, 4, 1);
    ASSERT_TRUE(answer) << answer.error().message();
    const Json& designs = answer->record["search"]["designs"];
    ASSERT_GE(designs.size(), 4u) << search;
    ASSERT_EQ(answer->specs.size(), designs.size());
    for (std::size_t i = 0; i < designs.size(); ++i) {
      const Json drive = drive_record(drive_job(toml_text(answer->specs[i])));
      for (const char* key :
           {"ratio", "ratio_exact", "efficiency", "efficiency_backward", "center_distance_mm"})
        EXPECT_EQ(designs[i][key], drive[key]) << search << " " << key;
      if (!drive["assembly"].is_null()) {
        EXPECT_EQ(designs[i]["positions"], drive["assembly"]["positions"]);
        EXPECT_EQ(designs[i]["neighbour_clearance_mm"],
                  drive["assembly"]["neighbour_clearance_mm"]);
      }
    }
    for (std::size_t i = 1; i < designs.size(); ++i)
      EXPECT_GE(designs[i - 1]["efficiency"], designs[i]["efficiency"].get<double>() - 1e-4);
  }
}

// Law: if the spec of a search gives no profile shifts, no external gear of a listed drive is
// undercut, and the spec of that drive leads to the numbers in the list. Every drive with a green
// verdict for x = 0 is also listed, with at least the same efficiency.
TEST(DriveSearchAnswerTest, SearchesChooseProfileShifts) {
  struct Case {
    std::string keys, unshifted;
    std::size_t least;  // the number of designs that must be listed
  };
  for (const Case& each :
       {Case{"kind = \"planetary\"\nratio = [4.8, 5.2]\nsun_teeth = [10, 16]\n",
             "{ sun = 0, planet = 0 }", 12},
        Case{"kind = \"planetary\"\nratio = [4.4, 4.6]\nsun_teeth = [15, 24]\n",
             "{ sun = 0, planet = 0 }", 12},
        Case{"kind = \"stepped\"\nratio = [9.3, 9.4]\nsun_teeth = [17, 24]\nplanet2_teeth = "
             "[14, 20]\n",
             "{ sun = 0, planet = 0 }", 12},
        Case{"kind = \"train\"\nratio = [11.99, 12.01]\npinion_teeth = [10, 13]\n"
             "wheel_teeth = [35, 50]\n",
             "0", 8}}) {
    const std::string search = "[search]\nnormal_module_mm = 2\n" + each.keys;
    const auto answer = answer_drive_search(drive_job(search), 300, 2);
    ASSERT_TRUE(answer) << answer.error().message();
    const Json& designs = answer->record["search"]["designs"];
    EXPECT_GE(designs.size(), each.least) << search;
    std::map<std::string, double> efficiency;
    for (std::size_t i = 0; i < designs.size(); ++i) {
      const auto solved = solve_drive(drive_job(toml_text(answer->specs[i])));
      ASSERT_TRUE(solved);
      EXPECT_EQ(solved->verdict.level, Level::green) << solved->verdict.headline;
      const Drive& drive = solved->drive;
      EXPECT_EQ(designs[i]["ratio"], drive.motion.ratio->value());
      for (std::size_t g = 0; g < drive.graph.gears.size(); ++g) {
        EXPECT_FALSE(drive.geometry.gears[g]->undercut);
        EXPECT_EQ(designs[i]["profile_shift"][drive.graph.gears[g].name], *drive.geometry.shift[g]);
      }
      const Json& a = designs[i]["center_distance_mm"];
      for (const auto& distance : drive.geometry.distance) {
        if (!a.is_null()) {
          EXPECT_NEAR(a, *distance, 1e-9);
        }
      }
      efficiency[designs[i]["teeth"].dump() + designs[i]["stages"].dump()] =
          designs[i]["efficiency"];
    }
    const auto before =
        answer_drive_search(drive_job(search + "profile_shift = " + each.unshifted + "\n"), 300, 2);
    ASSERT_TRUE(before) << before.error().message();
    EXPECT_LT(before->record["search"]["designs"].size(), designs.size());
    for (const Json& was : before->record["search"]["designs"]) {
      const std::string teeth = was["teeth"].dump() + was["stages"].dump();
      ASSERT_TRUE(efficiency.contains(teeth)) << teeth;
      EXPECT_GE(efficiency[teeth], was["efficiency"].get<double>() - 1e-12) << teeth;
    }
  }
}

// The specific sliding of a design is the greatest of its meshes in the verb `drive`.
TEST(DriveSearchAnswerTest, SearchesLimitTheSpecificSliding) {
  const std::string search =
      "[search]\nkind = \"planetary\"\nratio = [4.4, 4.6]\nnormal_module_mm = 2\nobjective = "
      "\"size\"\n";
  const auto greatest_of = [&](const std::string& limit) {
    const auto answer = answer_drive_search(drive_job(search + limit), 3, 2).value();
    double greatest = 0.0;
    for (std::size_t i = 0; i < answer.specs.size(); ++i) {
      double most = 0.0;
      const Json drive = drive_record(drive_job(toml_text(answer.specs[i])));
      for (const auto& [name, mesh] : drive["meshes"].items())
        for (const auto& [gear, ends] : mesh["pair"]["specific_sliding"].items())
          for (const Json& zeta : ends) most = std::max(most, std::abs(zeta.get<double>()));
      EXPECT_EQ(answer.record["search"]["designs"][i]["sliding_max"], most);
      greatest = std::max(greatest, most);
    }
    EXPECT_EQ(answer.record["search"]["left_out"]["sliding"] > 0, !limit.empty());
    return greatest;
  };
  EXPECT_GT(greatest_of(""), 4.0);
  const double limited = greatest_of("sliding_max = 3\n");
  EXPECT_LE(limited, 3.0);
  EXPECT_GT(limited, 0.0);
  EXPECT_EQ(refused_drive_key("[search]\nkind = \"planetary\"\nratio = 4\nsliding_max = 3\n"),
            "search.sliding_max");
}

// A listed drive has the backlash of a series of DIN 3967 in every mesh, unless the search has
// allowances of its own, and the verdict of its spec is green.
TEST(DriveSearchAnswerTest, SearchesGiveTheBacklashOfTheirSeries) {
  for (const std::string kind : {"kind = \"planetary\"\nratio = [4.4, 4.6]\nsun_teeth = [15, 24]\n",
                                 "kind = \"train\"\nratio = [11.9, 12.1]\npinion_teeth = [17, "
                                 "19]\nwheel_teeth = [55, 70]\n"}) {
    const auto backlash = [&](const std::string& keys) {
      const auto answer =
          answer_drive_search(drive_job("[search]\nnormal_module_mm = 2\n" + kind + keys), 3, 1);
      EXPECT_TRUE(answer) << answer.error().message();
      std::vector<double> list;
      for (const Json& spec : answer->specs) {
        const JobSpec job = drive_job(toml_text(spec));
        const auto solved = solve_drive(job);
        EXPECT_TRUE(solved);
        EXPECT_EQ(solved->verdict.level, Level::green) << solved->verdict.headline;
        for (const auto& pair : solved->drive.geometry.pairs)
          list.push_back(pair->involute()->mesh.backlash.normal);
      }
      EXPECT_GE(list.size(), 6u);
      return list;
    };
    // The means of cd25 are −69, −90 and −120 µm up to 50, 125 and 280 mm, and j_n = −(E_sn1 +
    // E_sn2) at α_wn = α_n. Profile shifts change j_n by a few percent.
    for (const double j : backlash("")) {
      EXPECT_GT(j, 0.95 * (0.069 + 0.069));
      EXPECT_LT(j, 1.05 * (0.120 + 0.120));
    }
    for (const double j : backlash("thickness_series = \"none\"\n")) EXPECT_NEAR(j, 0.0, 1e-12);
    for (const double j : backlash("thickness_allowance_mm = -0.03\n")) EXPECT_NEAR(j, 0.06, 0.003);
    // A given backlash applies to every mesh. A band is represented by its mean.
    for (const double j : backlash("backlash_mm = 0.12\n")) EXPECT_NEAR(j, 0.12, 1e-9);
    for (const double j : backlash("backlash_mm = [0.05, 0.09]\n")) EXPECT_NEAR(j, 0.07, 1e-9);
  }
  for (const char* keys :
       {"backlash_mm = 0.1\n", "backlash_mm = -0.1\nnormal_module_mm = 2\n",
        "backlash_mm = [0.2, 0.1]\nnormal_module_mm = 2\n",
        "backlash_mm = 0.1\nthickness_series = \"cd25\"\nnormal_module_mm = 2\n"})
    EXPECT_EQ(refused_drive_key(fmt::format("[search]\nkind = \"planetary\"\nratio = 4\n{}", keys)),
              "search.backlash_mm")
        << keys;
  EXPECT_EQ(refused_drive_key("[search]\nkind = \"planetary\"\nratio = 4\nnormal_module_mm = 2\n"
                              "thickness_series = \"zz9\"\n"),
            "search.thickness_series");
  EXPECT_EQ(refused_drive_key("[search]\nkind = \"planetary\"\nratio = 4\nthickness_series = "
                              "\"cd25\"\n"),
            "search.thickness_series");
}

TEST(DriveSearchAnswerTest, RatedSearchesNameWhatTheirLoadLacks) {
  const auto without = answer_drive_search(
      drive_job("[search]\nkind = \"planetary\"\nratio = 4\nnormal_module_mm = 2\n"
                "face_width_mm = [10, 60]\n"),
      4, 1);
  ASSERT_FALSE(without);
  EXPECT_EQ(without.error().field, "rating.torque_Nm");
  const auto flat = answer_drive_search(
      drive_job("[search]\nkind = \"planetary\"\nratio = 4\nsafety_root_min = 1.5\n"), 4, 1);
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.error().field, "search.normal_module_mm");
  EXPECT_EQ(refused_drive_key("[search]\nkind = \"planetary\"\nratio = 4\n"
                              "face_width_mm = [20, 10]\n"),
            "search.face_width_mm");
}

// The torque and the speed of [rating] are also those of the drive, so forces and loads need no
// further key.
TEST(DriveSearchAnswerTest, FoundDrivesHaveTheLoadOfTheRating) {
  for (const std::string kind : {"kind = \"planetary\"\nratio = [4.4, 4.6]\nsun_teeth = [18, 22]\n",
                                 "kind = \"train\"\nratio = [-3.6, -3.4]\nstages = 1\n"
                                 "pinion_teeth = [19, 21]\n"}) {
    const auto answer = answer_drive_search(
        drive_job("[search]\n" + kind +
                  "normal_module_mm = 2\nface_width_mm = 30\n[rating]\ntorque_Nm = 40\n"
                  "speed_rpm = 1450\nquality = 6\nmaterial = \"18CrNiMo7-6\"\n"),
        1, 1);
    ASSERT_TRUE(answer) << answer.error().message();
    ASSERT_FALSE(answer->specs.empty()) << kind;
    const Json& spec = answer->specs.front();
    const Json& table = spec.contains("stage") ? spec["stage"][0] : spec["planetary"];
    EXPECT_EQ(table["torque_Nm"], 40) << kind;
    EXPECT_EQ(table["speed_rpm"], 1450) << kind;
    EXPECT_TRUE(
        drive_record(drive_job(toml_text(spec)))["bodies"].begin().value().contains("torque_Nm"));
  }
}

}  // namespace
}  // namespace gearwright
