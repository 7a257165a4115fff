// Searches for trains: (1) a list of modules finds what its modules find alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "gearwright/job/drive_answer.hpp"

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

}  // namespace
}  // namespace gearwright
