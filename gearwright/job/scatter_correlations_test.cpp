// Correlations in [scatter]: rejected inputs with their messages, and correlations of 0, which
// change nothing.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gearwright/job/testing/answered.hpp"

namespace gearwright {
namespace {

Json correlated_spec(const std::string& correlations, bool indices = false) {
  Json spec = Json::parse(R"({"gear1": {"teeth": 20, "normal_module_mm": 2, "profile_shift": 0.2,
    "thickness_allowance_mm": -0.06, "face_width_mm": 20,
    "modifications": {"lead_crowning_um": 8, "profile_crowning_um": 4}},
    "gear2": {"teeth": 40, "profile_shift": 0, "thickness_allowance_mm": -0.06, "face_width_mm": 20},
    "pair": {"center_distance_mm": 60.4}, "contact": {"positions": 4},
    "scatter": {"samples": 16, "replicates": 2, "errors": {"center_distance_mm": [-0.02, 0.02],
    "crossing_deg": [-0.02, 0.02], "intersecting_deg": [-0.03, 0.03]}}})");
  if (!correlations.empty()) spec["scatter"]["correlations"] = Json::parse(correlations);
  if (indices) spec["scatter"]["indices"] = true;
  return spec;
}

void expect_no_correlation(const std::string& correlations, const std::string& key,
                           const std::string& words) {
  const Json error = testing::answered(correlated_spec(correlations), "scatter");
  ASSERT_TRUE(error.contains("key")) << correlations;
  EXPECT_EQ(error["key"], key) << error.dump();
  EXPECT_NE(error["rule"].get<std::string>().find(words), std::string::npos) << error.dump();
}

TEST(ScatterCorrelations, SuggestsTheNearestInputAndNoPhase) {
  Json spec = correlated_spec(
      R"([{"between": ["errors.crosing_deg", "errors.intersecting_deg"], "value": 0.5}])");
  spec["scatter"]["quality"] = 6;
  const std::string rule = testing::answered(spec, "scatter")["rule"];
  EXPECT_NE(rule.find("did you mean errors.crossing_deg?"), std::string::npos) << rule;
  EXPECT_EQ(rule.find("phase_deg"), std::string::npos) << rule;
}

TEST(ScatterCorrelations, RefusesWhatIsNoCorrelation) {
  const std::string first = "scatter.correlations[1]";
  expect_no_correlation("0.5", "scatter.correlations", "between = ");
  expect_no_correlation("[0.5]", first, "must be a table with between, value");
  expect_no_correlation(R"([{"value": 0.5}])", first + ".between", "missing");
  expect_no_correlation(R"([{"between": ["errors.crossing_deg", "errors.intersecting_deg"]}])",
                        first + ".value", "missing");
  expect_no_correlation(R"([{"between": ["errors.crossing_deg"], "value": 0.5}])",
                        first + ".between", "two inputs");
  expect_no_correlation(
      R"([{"between": ["errors.crossing_deg", "errors.crossing_deg"], "value": 0.5}])",
      first + ".between", "different");
  expect_no_correlation(
      R"([{"between": ["errors.crossing_deg", "errors.intersecting_deg"], "value": 1}])",
      first + ".value", "between -1 and 1");
  expect_no_correlation(
      R"([{"between": ["errors.crossing_deg", "errors.axial_mm"], "value": 0.5}])",
      first + ".between", "errors.intersecting_deg");
  const std::string pair = R"({"between": ["errors.crossing_deg", "errors.intersecting_deg"],)";
  const std::string turned = R"({"between": ["errors.intersecting_deg", "errors.crossing_deg"],)";
  expect_no_correlation("[" + pair + R"("value": 0.5},)" + turned + R"("value": 0.4}])",
                        "scatter.correlations[2].between", "twice");
}

TEST(ScatterCorrelations, RefusesAMatrixThatIsNone) {
  expect_no_correlation(
      R"([{"between": ["errors.center_distance_mm", "errors.crossing_deg"], "value": 0.9},
          {"between": ["errors.crossing_deg", "errors.intersecting_deg"], "value": 0.9},
          {"between": ["errors.intersecting_deg", "errors.center_distance_mm"], "value": 0.5}])",
      "scatter.correlations[1].value", "0.8274");
}

// Oracle: the variance that is independent of the other input is 1 − ρ². It must exceed 1e-9, so
// |ρ| is at most about √(1 − 1e-9) = 0.99999999950.
TEST(ScatterCorrelations, StatesTheLimitOfRounding) {
  const std::string pair = R"([{"between": ["errors.crossing_deg", "errors.intersecting_deg"],)";
  expect_no_correlation(pair + R"("value": 0.9999999999}])", "scatter.correlations[1].value",
                        "is 0.9999999995");
  expect_no_correlation(pair + R"("value": -0.9999999999}])", "scatter.correlations[1].value",
                        "is -0.9999999995");
  const Json answer =
      testing::answered(correlated_spec(pair + R"("value": 0.9999999995}])"), "scatter");
  EXPECT_FALSE(answer.contains("rule")) << answer.dump();
}

// A bore is correlated with a bore as a whole, and with a number by one of its coordinates.
TEST(ScatterCorrelations, OfBoresWavesAndPitches) {
  const auto error_of = [](const char* between, int quality = 6) {
    Json spec = correlated_spec("");
    spec["scatter"].erase("errors");
    spec["scatter"]["bearings"] = {{"span_mm", 60}, {"radius_mm", 0.01}};
    spec["scatter"]["quality"] = quality;
    spec["scatter"]["correlations"] = {{{"between", Json::parse(between)}, {"value", 0.6}}};
    const Json answer = testing::answered(spec, "scatter");
    return answer.contains("scatter") ? std::string() : answer["rule"].get<std::string>();
  };
  EXPECT_EQ(error_of(R"(["bearings.bore_a", "bearings.bore_b"])"), "");
  EXPECT_EQ(error_of(R"(["bearings.bore_a.y_mm", "errors.helix_slope1_um"])"), "");
  EXPECT_EQ(error_of(R"(["bearings.bore_a.x_in", "errors.helix_slope1_um"])"), "");
  EXPECT_EQ(error_of(R"(["gear1.profile_waves", "gear2.profile_waves"])"), "");
  EXPECT_EQ(error_of(R"(["gear1.pitch", "gear2.pitch"])"), "");
  EXPECT_EQ(error_of(R"(["gear1.pitch.eccentric", "gear1.modifications.profile_slope_um"])"), "");
  const auto expect = [&](const char* between, const char* words) {
    EXPECT_NE(error_of(between).find(words), std::string::npos) << error_of(between);
  };
  expect(R"(["bearings.bore_a", "gear1.pitch"])", "bearings.bore_a.x_mm or");
  expect(R"(["bearings.bore_a.x_mm", "bearings.bore_a.y_mm"])", "uniform in its circle");
  expect(R"(["gear1.pitch", "gear1.pitch.share"])", "the same input");
  expect(R"(["gear1.profile_waves.phase_deg", "gear1.pitch"])", "gear1.profile_waves.waves, ");
}

TEST(ScatterCorrelations, ErrorsOfInchSpecsNameInputsInInch) {
  Json spec = Json::parse(R"({"units": "inch",
    "gear1": {"teeth": 20, "normal_diametral_pitch_per_in": 10, "face_width_in": 0.8},
    "gear2": {"teeth": 40, "face_width_in": 0.8}, "pair": {"backlash_in": 0.004},
    "scatter": {"samples": 16, "bearings": {"span_in": 4, "radius_in": 0.001}}})");
  for (const char* const other : {"bearings.bore_c", "bearings.bore_a.y_in"}) {
    spec["scatter"]["correlations"] = {
        {{"between", {other, "bearings.bore_a.x_in"}}, {"value", 0.5}}};
    const Json error = testing::answered(spec, "scatter");
    ASSERT_TRUE(error.contains("rule")) << error.dump();
    EXPECT_NE(error.dump().find("bearings.bore_a.x_in"), std::string::npos) << error.dump();
    EXPECT_EQ(error.dump().find("_mm"), std::string::npos) << error.dump();
  }
}

TEST(ScatterCorrelations, IndicesNeedTheBlockInOneGroup) {
  const std::string one =
      R"([{"between": ["errors.crossing_deg", "errors.intersecting_deg"], "value": 0.5}])";
  Json spec = correlated_spec(one, true);
  const Json error = testing::answered(spec, "scatter");
  ASSERT_TRUE(error.contains("key"));
  EXPECT_EQ(error["key"], "scatter.groups");
  spec["scatter"]["groups"] = {{"axes", {"errors.crossing_deg", "errors.intersecting_deg"}}};
  const Json answer = testing::answered(spec, "scatter");
  ASSERT_TRUE(answer.contains("scatter")) << answer.dump();
  EXPECT_EQ(answer["scatter"]["indices"]["groups"].size(), 2u);
  // Without indices, no group is needed.
  EXPECT_TRUE(testing::answered(correlated_spec(one), "scatter").contains("scatter"));
}

TEST(ScatterCorrelations, OfZeroChangesNothing) {
  const Json alone = testing::answered(correlated_spec(""), "scatter");
  const Json zero = testing::answered(
      correlated_spec(
          R"([{"between": ["errors.crossing_deg", "errors.intersecting_deg"], "value": 0}])"),
      "scatter");
  ASSERT_TRUE(alone.contains("scatter")) << alone.dump();
  EXPECT_EQ(alone["scatter"], zero["scatter"]);
  const Json half = testing::answered(
      correlated_spec(
          R"([{"between": ["errors.crossing_deg", "errors.intersecting_deg"], "value": 0.5}])"),
      "scatter");
  EXPECT_NE(alone["scatter"], half["scatter"]);
}

}  // namespace
}  // namespace gearwright
