// Soft teeth whose contact is wider than the default slices. Laws: without a number of slices, each
// verb (1) has a result and (2) computes the pair as given as `load` does, with half as many slices;
// (3) with the default number as an input, each verb rejects this number.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gearwright/job/testing/answered.hpp"

namespace gearwright {
namespace {

Json soft_pair() {
  return Json::parse(R"({
    "gear1": {"teeth": 20, "normal_module_mm": 2, "face_width_mm": 20, "quality": 8,
              "material": {"youngs_modulus_MPa": 2800}},
    "gear2": {"teeth": 40, "thickness_allowance_mm": -0.2},
    "load": {"torque_Nm": 15, "positions": 4, "accuracy": "draft"},
    "compensate": {"corrections": ["gear1.lead_slope_um"], "aim": "pressure"},
    "scatter": {"errors": {"crossing_deg": [0, 0.0001]}, "samples": 1,
                "replicates": 2, "loaded": true}})");
}

TEST(WideContact, HasTheResultsOfLoadInEachVerb) {
  const Json spec = soft_pair();
  const Json load = testing::answered(spec, "load");
  ASSERT_TRUE(load.contains("load")) << load.dump();
  const Json& torque = load["load"]["torques"][0];
  ASSERT_EQ(torque["face_load_N_per_mm"].size(), 16u);
  const double pressure = torque["max_pressure_MPa"];

  const Json propose = testing::answered(spec, "propose");
  ASSERT_TRUE(propose.contains("propose")) << propose.dump();
  const Json& proposals = propose["propose"]["proposals"];
  EXPECT_EQ(proposals[0]["worst"]["max_pressure_MPa"], pressure);
  const Json relieved = testing::answered(proposals[1]["spec"], "load");
  EXPECT_EQ(proposals[1]["worst"]["max_pressure_MPa"],
            relieved["load"]["torques"][0]["max_pressure_MPa"]);
  for (const Json& proposal : proposals)
    EXPECT_FALSE(proposal["at_helix_limits"]["max_pressure_MPa"].is_null());

  const Json compensate = testing::answered(spec, "compensate");
  ASSERT_TRUE(compensate.contains("compensate")) << compensate.dump();
  EXPECT_EQ(compensate["compensate"]["under_load"][0]["before"]["max_pressure_MPa"], pressure);

  const Json scatter = testing::answered(spec, "scatter");
  ASSERT_TRUE(scatter.contains("scatter")) << scatter.dump();
  EXPECT_GT(scatter["scatter"]["loaded"][0]["max_pressure_MPa"]["least"].get<double>(),
            0.9 * pressure);
}

TEST(WideContact, RejectsAGivenNumberOfSlices) {
  Json spec = soft_pair();
  spec["load"]["slices"] = 32;
  for (const char* verb : {"load", "propose", "compensate", "scatter"})
    EXPECT_EQ(testing::answered(spec, verb)["key"], "load.slices") << verb;
}

}  // namespace
}  // namespace gearwright
