// [scatter.robust] under load: the answer and the corrected spec, and the optimum of `compensate`
// if nothing varies.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gearwright/job/testing/answered.hpp"

namespace gearwright {
namespace {

Json loaded_spec(const char* scatter) {
  Json spec = Json::parse(R"({
    "gear1": {"teeth": 23, "normal_module_mm": 3, "helix_angle_deg": 12, "face_width_mm": 30},
    "gear2": {"teeth": 41, "face_width_mm": 30},
    "pair": {"backlash_mm": 0.1}, "errors": {"crossing_deg": 0.035},
    "load": {"torque_Nm": 250, "positions": 8, "slices": 8, "accuracy": "draft"}})");
  spec["scatter"] = Json::parse(scatter);
  return spec;
}

Json answered(const Json& tree, std::string_view verb = "scatter") {
  return testing::answered(tree, verb);
}

TEST(ScatterRobust, UnderLoadTheAnswerIsThatOfTheCorrectedSpec) {
  const Json answer = answered(loaded_spec(R"({"samples": 16, "replicates": 2,
    "errors": {"crossing_deg": [-0.02, 0.02]},
    "robust": {"aim": "loaded_transmission_error", "percentile": 80,
               "corrections": ["gear1.lead_slope_um", "gear1.lead_crowning_um"]}})"));
  ASSERT_TRUE(answer.contains("scatter")) << answer.dump();
  EXPECT_FALSE(answer["scatter"].contains("loaded"));
  const Json& robust = answer["scatter"]["robust"];
  EXPECT_EQ(robust["aim"], "loaded_transmission_error");
  const double after = robust["after"]["percentile_arcsec"];
  EXPECT_LT(after, 0.9 * robust["before"]["percentile_arcsec"].get<double>()) << robust.dump();
  EXPECT_EQ(robust["after"]["loaded"][0]["torque_Nm"], 250);
  // `scatter` is run for the corrected spec with the seed of the samples of the comparison.
  Json corrected = answer["scatter"]["spec"];
  corrected["scatter"]["seed"] = 2;
  corrected["scatter"]["loaded"] = true;
  corrected["scatter"]["percentiles"] = {80};
  const Json again = answered(corrected)["scatter"]["loaded"][0]["peak_to_peak_arcsec"];
  EXPECT_NEAR(again["percentiles"][0].get<double>(), after, 1e-9);
}

TEST(ScatterRobust, UnderLoadNeedsATorque) {
  Json spec = loaded_spec(R"({"errors": {"crossing_deg": [-0.02, 0.02]},
    "robust": {"aim": "loaded_transmission_error"}})");
  spec.erase("load");
  EXPECT_EQ(answered(spec)["key"], "load.torque_Nm");
  spec["scatter"]["robust"]["aim"] = "pressure";
  const Json error = answered(spec);
  EXPECT_EQ(error["key"], "scatter.robust.aim");
  EXPECT_NE(error["rule"].get<std::string>().find("loaded_transmission_error"), std::string::npos);
}

// A slope of the helix does not help under errors of both signs. The samples of the comparison are
// not those of the distribution, so a difference between the two is not an effect of corrections.
TEST(ScatterRobust, WithoutACorrectionThereIsNoImprovement) {
  const Json answer = answered(Json::parse(R"({
    "gear1": {"teeth": 20, "normal_module_mm": 2, "face_width_mm": 20},
    "gear2": {"teeth": 40, "face_width_mm": 20}, "pair": {"backlash_mm": 0.1},
    "contact": {"positions": 8}, "scatter": {"samples": 16, "replicates": 2,
    "errors": {"crossing_deg": [-0.05, 0.05]},
    "robust": {"corrections": ["gear1.lead_slope_um"]}}})"));
  const Json& robust = answer["scatter"]["robust"];
  ASSERT_EQ(robust["corrections"][0]["value"], 0.0);
  EXPECT_EQ(robust["before"], robust["after"]);
  const std::string warnings = answer["warnings"].dump();
  EXPECT_NE(warnings.find("in 32 of 32 samples"), warnings.npos) << warnings;
  EXPECT_EQ(warnings.find("corrections"), warnings.npos) << warnings;
}

// Both searches use the same positions, and the family has the errors of the spec as its only
// member.
TEST(ScatterRobust, WithoutWidthItIsTheOptimumOfCompensate) {
  Json spec = loaded_spec(R"({"samples": 1, "replicates": 1, "errors": {"crossing_deg": [0, 0]},
    "robust": {"aim": "loaded_transmission_error",
               "corrections": ["gear1.lead_slope_um", "gear1.lead_crowning_um"]}})");
  const double robust = answered(spec)["scatter"]["robust"]["after"]["percentile_arcsec"];
  spec.erase("scatter");
  spec["compensate"] = Json::parse(R"({"aim": "loaded_transmission_error",
    "corrections": ["gear1.lead_slope_um", "gear1.lead_crowning_um"]})");
  const double nominal =
      answered(spec, "compensate")["compensate"]["under_load"][0]["after"]["peak_to_peak_arcsec"];
  EXPECT_LT(robust, 1.01 * nominal + 0.001);
  EXPECT_GT(robust, 0.9 * nominal);
}

}  // namespace
}  // namespace gearwright
