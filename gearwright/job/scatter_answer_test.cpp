// The verb scatter: what it refuses and in which words, and an answer that tolerances of 0 make that of
// the verb contact.
#include "gearwright/job/scatter_answer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {
namespace {

Json spec_with(const std::string& scatter) {
  Json spec = Json::parse(R"({"gear1": {"teeth": 20, "normal_module_mm": 2, "profile_shift": 0.2,
    "thickness_allowance_mm": -0.06, "face_width_mm": 20,
    "modifications": {"lead_crowning_um": 8, "profile_crowning_um": 4}},
    "gear2": {"teeth": 40, "profile_shift": 0, "thickness_allowance_mm": -0.06, "face_width_mm": 20},
    "pair": {"center_distance_mm": 60.4}, "contact": {"positions": 8}})");
  if (!scatter.empty()) spec["scatter"] = Json::parse(scatter);
  return spec;
}

// The answer, or its error as a file has it.
Json scatter_answered(const Json& tree, std::string_view verb = "scatter") {
  const auto spec = read_spec_tree(tree, {}, find_verb(verb)->use);
  const auto answer = spec ? answer_json(verb, *spec) : Result<Json>(spec.error());
  if (answer) return *answer;
  const Error error = spec ? spelled(answer.error(), spec->given) : answer.error();
  return {{"key", error.field}, {"rule", error.rule}};
}

void expect_spec_refused(const Json& spec, const std::string& key, const std::string& words) {
  const Json error = scatter_answered(spec);
  ASSERT_TRUE(error.contains("key")) << key;
  EXPECT_EQ(error["key"], key) << error.dump();
  EXPECT_NE(error["rule"].get<std::string>().find(words), std::string::npos) << error.dump();
}

void expect_refused(const std::string& scatter, const std::string& key, const std::string& words) {
  expect_spec_refused(spec_with(scatter), key, words);
}

TEST(ScatterAnswer, RefusesRangesThatAreNone) {
  const std::string crossing = "scatter.errors.crossing_deg";
  const auto error = [](const std::string& value) {
    return R"({"errors": {"crossing_deg": )" + value + "}}";
  };
  expect_refused(error("[0.02, -0.02]"), crossing, "the least value, then the greatest");
  expect_refused(error("0.02"), crossing, "[-0.02, 0.02]");
  expect_refused(error("[0.02]"), crossing, "[least, greatest]");
  expect_refused(error("[-20, 20]"), crossing, "10");
  expect_refused(error(R"({"range": [-0.02, 0.02], "distribution": "normal", "cpk": 0})"),
                 crossing + ".cpk", "must be > 0");
  expect_refused(error(R"({"range": [-0.02, 0.02], "distribution": "normal", "offset": 0.03})"),
                 crossing + ".offset", "must lie between -0.02 and 0.02");
  expect_refused(error(R"({"range": [-0.02, 0.02], "distribution": "beta", "shape": [2, 0]})"),
                 crossing + ".shape", "must be > 0");
  expect_refused(error(R"({"range": [-0.02, 0.02], "cpk": 1.33})"), crossing + ".cpk", "normal");
  expect_refused(error(R"({"distribution": "normal"})"), crossing + ".range", "missing");
}

TEST(ScatterAnswer, RefusesATaskThatIsNone) {
  for (const char* none : {"", "{}", R"({"samples": 64})"})
    expect_refused(none, "scatter.errors", "crossing_deg = [-0.02, 0.02]");
  const std::string error = R"("errors": {"crossing_deg": [-0.02, 0.02]})";
  expect_refused("{\"samples\": 1000, " + error + "}", "scatter.samples", "power of two");
  expect_refused("{\"samples\": 524288, " + error + "}", "scatter.samples", "at most 524288");
  expect_refused("{\"percentiles\": [100], " + error + "}", "scatter.percentiles", "100");
  expect_refused(R"({"bearings": {"span_mm": 100, "radius_mm": 0.02}, )" + error + "}",
                 "scatter.bearings", "scatter.errors.crossing_deg");
  expect_refused(R"({"bearings": {"span_mm": 100, "radius_mm": -0.02}})",
                 "scatter.bearings.radius_mm", "negative");
  expect_refused(R"({"groups": {"housing": ["errors.crossing"]}, )" + error + "}",
                 "scatter.groups.housing", "errors.crossing_deg");
}

TEST(ScatterAnswer, NamesWhatItDoesNotCompute) {
  for (const char* key : {"quality", "loaded", "robust", "correlations"}) {
    expect_refused(
        std::string("{\"") + key + R"(": true, "errors": {"crossing_deg": [-0.02, 0.02]}})",
        std::string("scatter.") + key, "are not");
  }
}

TEST(ScatterAnswer, RefusesWhatTheTeethCannotHave) {
  expect_refused(R"({"gear1": {"modifications": {"tip_relief_um": [0, 5]}}})",
                 "scatter.gear1.modifications.tip_relief_um", "tip_relief_start_mm");
  Json relief = spec_with(R"({"gear1": {"modifications": {"tip_relief_um": [-5, 5]}}})");
  relief["gear1"]["modifications"]["tip_relief_um"] = 2;
  relief["gear1"]["modifications"]["tip_relief_start_mm"] = 43;
  expect_spec_refused(relief, "scatter.gear1.modifications.tip_relief_um", "tip_relief_um");
  expect_refused(R"({"errors": {"cutter_lead1_deg": [-0.01, 0.01]}})",
                 "scatter.errors.cutter_lead1_deg", "spur");
}

TEST(ScatterAnswer, NoWidthIsTheAnswerOfContact) {
  Json spec = spec_with(R"({"samples": 2, "replicates": 2, "worst_case": true,
    "errors": {"crossing_deg": [0, 0]}, "gear1": {"thickness_allowance_mm": [0, 0]}})");
  spec["errors"] = {{"crossing_deg", 0.05}, {"center_distance_mm", 0.01}};
  for (const int driver : {1, 2}) {
    spec["contact"]["driver"] = driver;
    const Json scatter = scatter_answered(spec)["scatter"];
    const Json contact = scatter_answered(spec, "contact")["contact"];
    EXPECT_EQ(scatter["harmonic1_arcsec"]["mean"], contact["harmonics_arcsec"][0]);
    EXPECT_EQ(scatter["least_play_deg"]["percentiles"][2], contact["least_play_deg"]);
    EXPECT_EQ(scatter["least_play_deg"]["standard_deviation"], 0.0);
    EXPECT_GE(scatter["peak_to_peak_arcsec"]["mean"], contact["peak_to_peak_arcsec"]);
    EXPECT_EQ(scatter["worst"]["peak_to_peak_arcsec"]["value"],
              scatter["peak_to_peak_arcsec"]["mean"]);
    // The sample as a spec: its errors are those of the pair.
    EXPECT_EQ(scatter["mean_arcsec"]["samples"][0]["errors"]["crossing_deg"], 0.05);
  }
}

TEST(ScatterAnswer, IndicesAreByGroup) {
  const Json answer = scatter_answered(spec_with(R"({"samples": 16, "indices": true,
    "errors": {"center_distance_mm": [-0.01, 0.01], "crossing_deg": [-0.02, 0.02]},
    "gear2": {"thickness_allowance_mm": [-0.03, 0.03]},
    "groups": {"housing": ["errors.crossing_deg", "errors.center_distance_mm"]}})"))["scatter"];
  EXPECT_EQ(answer["inputs"], Json::array({"errors.center_distance_mm", "errors.crossing_deg",
                                           "gear2.thickness_allowance_mm"}));
  EXPECT_EQ(answer["indices"]["groups"], Json::array({"housing", "gear2.thickness_allowance_mm"}));
  const Json& play = answer["indices"]["least_play_deg"];
  EXPECT_EQ(play["total"].size(), 2u);
  EXPECT_NEAR(play["total"][0].get<double>() + play["total"][1].get<double>(), 1.0, 0.1);
  EXPECT_EQ(answer["probability"]["jam"]["of"], 128);
  EXPECT_TRUE(answer["contact_along_profile"].is_null());
}

TEST(ScatterAnswer, TablesHaveARowForEachSample) {
  const Json tree = spec_with(R"({"samples": 4, "replicates": 2, "seed": 7,
    "bearings": {"span_mm": 100, "radius_mm": 0.02}})");
  const auto spec = read_spec_tree(tree, {}, SpecUse::scatter);
  ASSERT_TRUE(spec) << spec.error().message();
  const auto answer = find_verb("scatter")->run(*spec, nullptr);
  ASSERT_TRUE(answer) << answer.error().message();
  const std::string csv = answer->csv();
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 9);
  EXPECT_NE(csv.find("bearings.bore_a.x_mm"), std::string::npos);
  EXPECT_NE(answer->listing().find("less than"), std::string::npos);
  EXPECT_EQ(scatter_answered(tree), scatter_answered(tree));
}

}  // namespace
}  // namespace gearwright
