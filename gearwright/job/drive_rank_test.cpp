// The order of the drives in the result of a search:
// (1) A short list is the beginning of every longer list, for every kind and objective.
// (2) The mass of a design is the mass of its bodies.
// (3) No listed design is better than a design of the front in both objectives.
// (4) The first trains of a search for the least mass are the lightest of all trains.
// (5) Limits on common factors and on the overlap ratio hold for every mesh.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <random>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {
namespace {

constexpr const char* kRankLoad =
    "[rating]\npower_kW = 4\nspeed_rpm = 1450\nlife_h = 10000\nquality = 7\n"
    "face_load_factor = 1.3\nmaterial = { name = \"16MnCr5\" }\n";

Answer ranked_search(const std::string& keys, std::size_t top) {
  const JobSpec spec = testing::taken(read_spec("[search]\n" + keys, SpecFormat::toml));
  return testing::taken(answer_drive_search(spec, top, 2));
}

// Returns the mass of the gears of a printed spec, computed as cylinders of steel, kg.
double mass_of_cylinders(const Json& printed) {
  const JobSpec spec = testing::taken(read_spec(toml_text(printed), SpecFormat::toml));
  const Drive drive = testing::taken(solve_drive(spec)).drive;
  double mass = 0.0;
  for (std::size_t g = 0; g < drive.graph.gears.size(); ++g) {
    const Gear& gear = *drive.geometry.gears[g];
    const double mean = (gear.tip_diameter + gear.root_diameter) / 2;
    const bool ring = gear.spec.teeth < 0;
    const double outer = ring ? gear.root_diameter + 5 * gear.spec.normal_module : mean;
    const double inner = ring ? mean : 0.0;
    mass += drive.graph.body(drive.graph.gears[g]).count * 7.83e-6 * gear.spec.face_width *
            std::numbers::pi / 4 * (outer * outer - inner * inner);
  }
  return mass;
}

// Law (1). The bands are random, so that some searches find fewer drives than the list is long.
TEST(DriveRank, AShortListIsTheBeginningOfALongOne) {
  std::mt19937 random(7);
  const auto between = [&](int lo, int hi) {
    return std::uniform_int_distribution(lo, hi)(random);
  };
  std::size_t reordered = 0;
  for (int k = 0; k < 7; ++k) {
    const int sun = between(14, 30), pinion = between(17, 24), wheel = between(45, 60);
    const bool train = k % 2 == 1, rated = k % 7 == 3;
    std::string keys =
        train ? fmt::format(
                    "kind = \"train\"\nratio = [8.8, {}]\npinion_teeth = [{}, "
                    "{}]\nwheel_teeth = [{}, {}]\n",
                    between(9, 11) + 0.3, pinion, pinion + 2, wheel, wheel + (rated ? 12 : 20))
              : fmt::format(
                    "kind = \"planetary\"\nratio = [3.8, {}]\nplanets = [3, 4]\n"
                    "sun_teeth = [{}, {}]\n",
                    between(42, 52) / 10.0, sun, sun + 6);
    constexpr const char* kObjectives[] = {"\"efficiency\"", "\"size\"",
                                           "\"noise\"",      "\"mass\"",
                                           "\"ratio\"",      "[\"mass\", \"efficiency\"]",
                                           "\"efficiency\""};
    keys += fmt::format("objective = {}\nnormal_module_mm = {}\n", kObjectives[k],
                        rated ? "[1.5, 2, 2.5]" : "2");
    if (rated)
      keys += "face_width_mm = [10, 50]\nsafety_flank_min = 1.1\n" + std::string(kRankLoad);
    std::vector<Json> lists;
    for (const std::size_t top : {1, 5, 100, 1000})
      lists.push_back(ranked_search(keys, top).record["search"]["designs"]);
    const std::size_t tops[] = {1, 5, 100};
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_LE(std::min(tops[i], lists[3].size()), lists[i].size()) << keys;
      for (std::size_t row = 0; row < std::min(tops[i], lists[3].size()); ++row)
        EXPECT_EQ(lists[i][row], lists[3][row]) << keys << "row " << row << " of " << tops[i];
    }
    const Json& all = lists[3];
    for (std::size_t row = 1; row < all.size(); ++row)
      reordered += all[row]["efficiency"] > all[row - 1]["efficiency"] ? 1 : 0;
  }
  EXPECT_GT(reordered, 20u);  // near ties are sorted by size
}

// Laws (2) and (3). The oracle adds the cylinders of the printed specs.
TEST(DriveRank, TheLightestDriveComesFirst) {
  for (const bool train : {false, true}) {
    const std::string keys =
        train
            ? "kind = \"train\"\nratio = [9.9, 10.1]\npinion_teeth = [17, 20]\nwheel_teeth = "
              "[50, 70]\n"
            : "kind = \"planetary\"\nratio = [4.3, 4.7]\nplanets = [3, 4]\nsun_teeth = [15, 24]\n";
    const Answer answer = ranked_search(keys +
                                            "objective = [\"mass\", \"efficiency\"]\n"
                                            "normal_module_mm = [1.5, 2]\nface_width_mm = 20\n",
                                        100);
    const Json& designs = answer.record["search"]["designs"];
    ASSERT_GT(designs.size(), 10u);
    const Json& front = answer.record["search"]["pareto"];
    ASSERT_GE(front.size(), 2u);
    double before = 0.0;
    for (std::size_t i = 0; i < designs.size(); ++i) {
      const double mass = mass_of_cylinders(answer.specs[i]);
      const double own = designs[i]["mass_kg"];
      EXPECT_NEAR(own, mass, 1e-12 * mass);
      EXPECT_GE(own, before);
      before = own;
      for (const Json& f : front)
        EXPECT_FALSE(own < designs[f.get<std::size_t>()]["mass_kg"] &&
                     designs[i]["efficiency"] > designs[f.get<std::size_t>()]["efficiency"]);
    }
  }
}

// Law (1) for rated trains whose stages have their own modules. Trains of one ratio, or of one
// number of planets, are sorted by their size, which follows from the chosen modules.
TEST(DriveRank, TrainsOfOneRatioAreSortedByTheirSize) {
  for (const char* objective : {"ratio", "planets"}) {
    const std::string keys = fmt::format(
        "kind = \"train\"\nratio = [8.8, 9.3]\npinion_teeth = [17, 18]\nwheel_teeth = [45, 60]\n"
        "objective = \"{}\"\nnormal_module_mm = [1.5, 2, 2.5]\nface_width_mm = [10, 50]\n"
        "safety_flank_min = 1.1\n{}",
        objective, kRankLoad);
    const Json one = ranked_search(keys, 1).record["search"]["designs"];
    const Json many = ranked_search(keys, 20).record["search"]["designs"];
    ASSERT_GT(many.size(), 3u);
    EXPECT_EQ(one[0], many[0]) << objective;
    for (std::size_t row = 1; row < many.size(); ++row) {
      if (*objective != 'p' && many[row]["ratio"] != many[row - 1]["ratio"]) continue;
      EXPECT_GE(many[row]["size_mm"], many[row - 1]["size_mm"]) << objective << " " << row;
    }
    EXPECT_TRUE(many[0]["planets"].is_null());
  }
}

// A load that is missing is an error, and not a drive that is left out.
TEST(DriveRank, AMissingLoadIsAnError) {
  const JobSpec spec = testing::taken(
      read_spec("[search]\nkind = \"wolfrom\"\nratio = [-95, 95]\nsun_teeth = [14, 16]\n"
                "planet_teeth = [18, 19]\nnormal_module_mm = 4\nface_width_mm = 40\n"
                "objective = \"size\"\n[rating]\nlife_h = 10000\nspeed_rpm = 1000\nquality = 7\n"
                "face_load_factor = 1.3\nmaterial = { name = \"16MnCr5\" }\n",
                SpecFormat::toml));
  const auto answer = answer_drive_search(spec, 10, 2);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().field, "rating.torque_Nm");
}

// A search that computes the face widths sorts by the mass of the drives with these widths.
TEST(DriveRank, TheMassHasTheChosenWidths) {
  const Answer answer = ranked_search(
      "kind = \"planetary\"\nratio = [4.4, 4.6]\nsun_teeth = [17, 22]\n"
      "normal_module_mm = [1, 1.5, 2]\nface_width_mm = [8, 50]\n"
      "safety_flank_min = 1.1\nobjective = \"mass\"\n" +
          std::string(kRankLoad),
      20);
  const Json& designs = answer.record["search"]["designs"];
  ASSERT_GT(designs.size(), 3u);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const double own = designs[i]["mass_kg"], mass = mass_of_cylinders(answer.specs[i]);
    EXPECT_NEAR(own, mass, 1e-12 * mass);
    if (i > 0) {
      EXPECT_LE(designs[i - 1]["mass_kg"], own);
    }
  }
}

// Law (4). The list of all trains shows which of them is the lightest. A train that is computed
// after the first hundred may be lighter than all of these, because its faces are sized only then.
void expect_the_lightest(const std::string& keys, std::size_t most) {
  const std::string search =
      "kind = \"train\"\nobjective = \"mass\"\nnormal_module_mm = [1.5, 2, 2.5, 3]\n" + keys +
      kRankLoad;
  const Json all = ranked_search(search, 100000).record["search"];
  ASSERT_GT(all["computed"].get<std::size_t>(), most) << keys;
  EXPECT_EQ(all["beyond_limit"], 0);
  double least = kInfinity;
  for (const Json& design : all["designs"])
    least = std::min(least, design["mass_kg"].get<double>());
  EXPECT_EQ(ranked_search(search, 1).record["search"]["designs"][0]["mass_kg"], least) << keys;
}

TEST(DriveRank, TheLightestTrainIsFoundBeyondAHundred) {
  expect_the_lightest(
      "ratio = [8.9, 9.05]\npinion_teeth = [20, 24]\nwheel_teeth = [48, 72]\n"
      "face_width_mm = [8, 50]\nsafety_flank_min = 1.1\n",
      250);
}

TEST(LongDriveRank, TheLightestTrainIsFoundBeyondAHundred) {
  std::mt19937 random(5);
  const auto between = [&](int lo, int hi) {
    return std::uniform_int_distribution(lo, hi)(random);
  };
  for (int k = 0; k < 5; ++k) {
    const int pinion = between(17, 22), wheel = between(45, 52), ratio = between(83, 100);
    expect_the_lightest(
        fmt::format("ratio = [{}, {}]\npinion_teeth = [{}, {}]\n"
                    "wheel_teeth = [{}, {}]\nface_width_mm = [{}, {}]\n"
                    "safety_flank_min = {}\n",
                    ratio / 10.0, ratio / 10.0 + 0.35, pinion, pinion + 4, wheel, wheel + 24,
                    between(5, 12), between(40, 70), between(10, 13) / 10.0),
        300);
  }
}

// Law (5).
TEST(DriveRank, CommonFactorsAndOverlapAreLimited) {
  const std::string keys =
      "ratio = [3.9, 4.6]\nnormal_module_mm = 2\ncoprime = true\n"
      "helix_angle_deg = 15\nface_width_mm = 30\noverlap_ratio_min = ";
  const std::string set = "kind = \"planetary\"\nsun_teeth = [17, 26]\n";
  const std::string train =
      "kind = \"train\"\nstages = [1, 2]\npinion_teeth = [17, 19]\nwheel_teeth = [36, 42]\n";
  for (const std::string& kind : {set, train}) {
    const Answer answer = ranked_search(kind + keys + "1.2\n", 50);
    const Json& designs = answer.record["search"]["designs"];
    ASSERT_GT(designs.size(), 3u) << kind;
    for (const Json& spec : answer.specs) {
      const JobSpec job = testing::taken(read_spec(toml_text(spec), SpecFormat::toml));
      const Drive drive = testing::taken(solve_drive(job)).drive;
      for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m) {
        const DriveMesh& mesh = drive.graph.meshes[m];
        EXPECT_EQ(std::gcd(drive.graph.gear(mesh, 0).teeth, drive.graph.gear(mesh, 1).teeth), 1);
        EXPECT_GE(drive.geometry.involutes(m)->mesh.overlap_ratio, 1.2);
      }
    }
    const Json none = ranked_search(kind + keys + "1.3\n", 50).record["search"];
    EXPECT_EQ(none["designs"].size(), 0u);
    EXPECT_EQ(none["left_out"]["overlap"], none["computed"]);
  }
  // The search tests and counts only pairs of tooth numbers without a common factor.
  long long pairs = 0;
  for (int a = 17; a <= 19; ++a)
    for (int b = 36; b <= 42; ++b) pairs += std::gcd(a, b) == 1 ? 1 : 0;
  EXPECT_EQ(ranked_search(train + keys + "1.2\n", 50).record["search"]["tested"],
            pairs + pairs * pairs);
}

}  // namespace
}  // namespace gearwright
