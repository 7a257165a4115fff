// Searches for trains: (1) a list of modules finds what its modules find alone; (2) the axial forces
// on an intermediate shaft have opposite directions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "gearwright/drive/drive_forces.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/spec/toml_text.hpp"

namespace gearwright {
namespace {

Result<Answer> trains_of(const std::string& modules, const std::string& keys, std::size_t top) {
  const auto spec = read_spec(
      "[search]\nkind = \"train\"\nhelix_angle_deg = 15\nobjective = \"size\"\nnormal_module_mm "
      "= " +
          modules + "\n" + keys +
          "[rating]\npower_kW = 5.5\nspeed_rpm = 1450\nlife_h = 20000\nquality = 7\n"
          "application_factor = 1.25\nface_load_factor = 1.3\nmaterial = \"18CrNiMo7-6\"\n",
      SpecFormat::toml);
  EXPECT_TRUE(spec) << spec.error().message();
  return answer_drive_search(*spec, top, 2);
}

// Law (1). The sets of each module are numerous enough for the estimate of the safeties.
TEST(TrainSearchAnswerTest, AListOfModulesFindsWhatEachModuleFinds) {
  const std::string keys =
      "ratio = [11.8, 12.2]\npinion_teeth = [17, 28]\nwheel_teeth = [50, 110]\n"
      "face_width_mm = [15, 60]\nsafety_flank_min = 1.5\nsafety_root_min = 1.6\n";
  constexpr std::size_t kTop = 4;
  std::vector<double> sizes;
  long long hopeless = 0;
  for (const char* module : {"1.25", "2", "2.5"}) {
    const auto alone = trains_of(module, keys, kTop);
    ASSERT_TRUE(alone) << alone.error().message();
    const Json& search = alone->record["search"];
    EXPECT_GT(search["feasible_count"], 1000) << module;
    EXPECT_EQ(search["beyond_limit"], 0);
    hopeless += search["hopeless"].get<long long>();
    for (const Json& design : search["designs"]) sizes.push_back(design["size_mm"]);
  }
  EXPECT_GT(hopeless, 1000);
  std::sort(sizes.begin(), sizes.end());
  ASSERT_GE(sizes.size(), kTop);
  sizes.resize(kTop);
  const auto all = trains_of("[1.25, 2, 2.5]", keys, kTop);
  ASSERT_TRUE(all) << all.error().message();
  const Json& search = all->record["search"];
  std::vector<double> found;
  for (const Json& design : search["designs"]) found.push_back(design["size_mm"]);
  EXPECT_EQ(found, sizes);
}

// If no train has the safeties, the advice names keys of trains.
TEST(TrainSearchAnswerTest, AdviceForUnsafeTrainsIsForTrains) {
  const auto answer = trains_of("1.5",
                                "ratio = [11.8, 12.2]\npinion_teeth = [17, 28]\n"
                                "wheel_teeth = [50, 110]\nsafety_flank_min = 9\n",
                                4);
  ASSERT_TRUE(answer) << answer.error().message();
  const Json& search = answer->record["search"];
  EXPECT_EQ(search["hopeless"], search["feasible_count"]);
  const std::string text = answer->listing();
  EXPECT_NE(text.find("greater pinion_teeth"), std::string::npos) << text;
  EXPECT_EQ(text.find("planets or"), std::string::npos) << text;
}

// Law (2). The forces of a gear and of its mate are opposite, so the forces on the shaft have opposite
// directions if its force is the difference of their magnitudes.
TEST(TrainSearchAnswerTest, AxialForcesOnAnIntermediateShaftAreOpposite) {
  const auto answer = trains_of("6",
                                "ratio = [-58, -56]\nstages = 3\npinion_teeth = 18\n"
                                "wheel_teeth = [68, 72]\nface_width_mm = 100\n",
                                1);
  ASSERT_TRUE(answer) << answer.error().message();
  ASSERT_FALSE(answer->specs.empty());
  const Json& stages = answer->specs[0]["stage"];
  ASSERT_EQ(stages.size(), 3u);
  EXPECT_EQ(stages[0]["helix_angle_deg"], 15);
  EXPECT_EQ(stages[1]["helix_angle_deg"], -15);
  EXPECT_EQ(stages[2]["helix_angle_deg"], 15);
  Json loaded = answer->specs[0];
  loaded["stage"][0]["torque_Nm"] = 36.0;
  loaded["stage"][0]["speed_rpm"] = 1450;
  const auto spec = read_spec(toml_text(loaded), SpecFormat::toml);
  ASSERT_TRUE(spec) << spec.error().message();
  const auto job = solve_drive(*spec);
  ASSERT_TRUE(job) << job.error().message();
  const DriveGraph& graph = job->drive.graph;
  std::size_t shafts = 0;
  for (std::size_t b = 0; b < graph.bodies.size(); ++b) {
    std::vector<double> axial;
    for (std::size_t m = 0; m < graph.meshes.size(); ++m)
      for (const int side : {0, 1})
        if (graph.gear(graph.meshes[m], side).body == b)
          axial.push_back(std::abs(mesh_forces(job->drive, m)->axial));
    if (axial.size() != 2) continue;
    ++shafts;
    const double sum = std::abs(body_forces(job->drive, b)->axial);
    EXPECT_NEAR(sum, std::abs(axial[0] - axial[1]), 1e-9 * (axial[0] + axial[1]));
    EXPECT_GT(std::min(axial[0], axial[1]), 100.0);
  }
  EXPECT_EQ(shafts, 2u);
}

}  // namespace
}  // namespace gearwright
