// The verb `scatter`: rejected inputs with their messages, and tolerances of 0, for which the
// result equals that of the verb `contact`.
#include "gearwright/job/scatter_answer.hpp"
#include "gearwright/job/testing/answered.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/inspection/thickness_series.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {
namespace {

Json scatter_answered(const Json& tree, std::string_view verb = "scatter") {
  return testing::answered(tree, verb);
}

Json spec_with(const std::string& scatter) {
  Json spec = Json::parse(R"({"gear1": {"teeth": 20, "normal_module_mm": 2, "profile_shift": 0.2,
    "thickness_allowance_mm": -0.06, "face_width_mm": 20,
    "modifications": {"lead_crowning_um": 8, "profile_crowning_um": 4}},
    "gear2": {"teeth": 40, "profile_shift": 0, "thickness_allowance_mm": -0.06, "face_width_mm": 20},
    "pair": {"center_distance_mm": 60.4}, "contact": {"positions": 8}})");
  if (!scatter.empty()) spec["scatter"] = Json::parse(scatter);
  return spec;
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
  expect_refused(error("[0.02, -0.02]"), crossing, "the least value before the greatest");
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

Json loaded_spec(double torque) {
  Json spec = spec_with(R"({"samples": 1, "replicates": 1, "loaded": true, "percentiles": 50,
    "errors": {"crossing_deg": [-0.02, 0.02], "center_distance_mm": [-0.02, 0.02]}})");
  spec["load"] = {{"torque_Nm", torque}, {"positions", 8}, {"accuracy", "draft"}};
  return spec;
}

// Returns the spec of the only sample, without [scatter].
Json of_sample(Json spec, const Json& spread) {
  spec["errors"] = spread["samples"][0]["errors"];
  spec.erase("scatter");
  return spec;
}

TEST(ScatterAnswer, UnderLoadASampleHasTheNumbersOfLoad) {
  const Json spec = loaded_spec(80);
  const Json answer = scatter_answered(spec);
  ASSERT_TRUE(answer.contains("scatter")) << answer.dump();
  const Json& loaded = answer["scatter"]["loaded"][0];
  EXPECT_EQ(loaded["torque_Nm"], 80);
  EXPECT_EQ(loaded["unsolved"]["count"], 0);
  const Json alone = scatter_answered(of_sample(spec, loaded["peak_to_peak_arcsec"]), "load");
  ASSERT_TRUE(alone.contains("load")) << alone.dump();
  const Json& torque = alone["load"]["torques"][0];
  for (const char* key : {"peak_to_peak_arcsec", "max_pressure_MPa", "face_load_factor"})
    EXPECT_NEAR(loaded[key]["percentiles"][0].get<double>(), torque[key].get<double>(),
                1e-9 * torque[key].get<double>())
        << key;
  EXPECT_EQ(loaded["edge_carries"]["count"], torque["edge_carries"].get<bool>() ? 1 : 0);
}

// Under a light load the teeth are nearly rigid, so the numbers equal those of the verb `contact`,
// which computes no forces.
TEST(ScatterAnswer, UnderALightLoadTeethAreRigid) {
  const Json spec = loaded_spec(1e-4);
  const Json answer = scatter_answered(spec);
  ASSERT_TRUE(answer.contains("scatter")) << answer.dump();
  const Json& spread = answer["scatter"]["loaded"][0]["peak_to_peak_arcsec"];
  const Json rigid = scatter_answered(of_sample(spec, spread), "contact");
  EXPECT_NEAR(spread["percentiles"][0].get<double>(),
              rigid["contact"]["peak_to_peak_arcsec"].get<double>(), 0.01);
}

TEST(ScatterAnswer, UnderLoadNeedsATorque) {
  Json spec = loaded_spec(80);
  spec.erase("load");
  expect_spec_refused(spec, "load.torque_Nm", "100");
}

TEST(ScatterAnswer, UnderLoadHasOneDriver) {
  Json spec = loaded_spec(80);
  spec["load"]["driver"] = 2;
  expect_spec_refused(spec, "load.driver", "driver = 2 in [contact]");
  spec["contact"] = {{"driver", 2}, {"positions", 8}};
  EXPECT_TRUE(scatter_answered(spec).contains("scatter"));
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

TEST(ScatterAnswer, RefusesCorrectionsThatAreNone) {
  const auto robust = [](const std::string& table) {
    return R"({"errors": {"crossing_deg": [-0.02, 0.02]}, "robust": )" + table + "}";
  };
  expect_refused(robust(R"({"corrections": ["gear1.crowning"]})"), "scatter.robust.corrections",
                 "gear1.lead_crowning_um");
  expect_refused(robust(R"({"range": [1, 20]})"), "scatter.robust.range", "must contain 0");
  expect_refused(robust(R"({"percentile": 100})"), "scatter.robust.percentile", "100");
  expect_refused(robust(R"({"corrections": ["gear1.tip_relief_um"]})"),
                 "scatter.robust.corrections", "tip_relief_start_mm");
  expect_refused(robust(R"({"corrections": ["cutter_lead1_deg"]})"), "scatter.robust.corrections",
                 "helical");
}

TEST(ScatterAnswer, TheCorrectedSpecHasTheCorrections) {
  constexpr const char* kRobust = R"({"samples": 32, "replicates": 2, "loosening": true,
    "errors": {"crossing_deg": [-0.06, 0.06]},
    "robust": {"corrections": ["gear1.lead_crowning_um", "gear1.profile_crowning_um"],
               "percentile": 90, "range": [-8, 12]}})";
  const Json answer = scatter_answered(spec_with(kRobust))["scatter"];
  const Json& robust = answer["robust"];
  EXPECT_EQ(robust["percentile"], 90);
  const double before = robust["before"]["percentile_arcsec"];
  const double after = robust["after"]["percentile_arcsec"];
  EXPECT_LT(after, 0.9 * before) << robust.dump();
  // The printed spec is run with the seed of the samples for comparison.
  Json corrected = answer["spec"];
  EXPECT_FALSE(corrected["scatter"].contains("robust"));
  EXPECT_NEAR(corrected["gear1"]["modifications"]["lead_crowning_um"].get<double>(),
              8 + robust["corrections"][0]["value"].get<double>(), 1e-9);
  corrected["scatter"]["seed"] = 2;
  corrected["scatter"]["percentiles"] = {90};
  const Json again = scatter_answered(corrected)["scatter"]["peak_to_peak_arcsec"];
  EXPECT_NEAR(again["percentiles"][0].get<double>(), after, 1e-9);
  // If there is only one tolerance, the result names it as the tolerance to tighten.
  const Json& loosening = answer["loosening"];
  EXPECT_EQ(loosening["tolerances"][0]["input"], "errors.crossing_deg");
  EXPECT_EQ(answer["inputs"].size(), loosening["tolerances"].size());
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
    // The sample contains the errors of the pair in the form of a spec.
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

TEST(ScatterAnswer, AGradeGivesWhatIsNotGiven) {
  Json tree = spec_with(R"({"samples": 2, "replicates": 2, "quality": 6,
    "errors": {"helix_slope1_um": [-1, 1]}, "gear2": {"profile_waves": [2, 3]}})");
  tree["pair"]["center_distance_tolerance"] = "JS7";
  const Json all = Json::array({"errors.helix_slope1_um", "errors.center_distance_mm",
                                "gear1.modifications.profile_slope_um", "gear1.profile_waves",
                                "gear1.helix_waves", "gear1.pitch", "errors.helix_slope2_um",
                                "gear2.modifications.profile_slope_um", "gear2.profile_waves",
                                "gear2.helix_waves", "gear2.pitch", "errors.crossing_deg",
                                "errors.intersecting_deg"});
  const Json scatter = scatter_answered(tree)["scatter"];
  EXPECT_EQ(scatter["inputs"], all) << scatter.dump();
  EXPECT_GT(scatter["long_period_arcsec"]["mean"], scatter["peak_to_peak_arcsec"]["mean"]);
  // The grade of the gears is the default.
  Json by_gear = tree;
  by_gear["scatter"].erase("quality");
  by_gear["gear1"]["tolerance"]["quality"] = by_gear["gear2"]["tolerance"]["quality"] = 6;
  Json same = scatter_answered(by_gear)["scatter"];
  EXPECT_EQ(same["ranges_from"][2], "gear1.tolerance.quality");
  same["ranges_from"] = scatter["ranges_from"];
  EXPECT_EQ(same, scatter);
  expect_refused(R"({"gear1": {"pitch": "F_p"}})", "scatter.gear1.pitch", "needs a grade");
  expect_refused(R"({"quality": 12})", "scatter.quality", "1 to 11");
  by_gear["gear2"]["tolerance"]["quality"] = 12;
  expect_spec_refused(by_gear, "gear2.tolerance.quality", "1 to 11");
  expect_refused(R"({"quality": 6, "gear1": {"helix_waves": [4, 1]}})", "scatter.gear1.helix_waves",
                 "in rising order");
}

TEST(ScatterAnswer, WorstCaseHasWholeWavesAndZeroWavesAreNone) {
  const Json tree = spec_with(R"({"samples": 2, "replicates": 2, "quality": 6, "worst_case": true,
    "errors": {"helix_slope1_um": [0, 0], "helix_slope2_um": [0, 0], "crossing_deg": [0, 0],
               "intersecting_deg": [0, 0]},
    "gear1": {"profile_waves": [0, 0], "helix_waves": [0, 0],
              "modifications": {"profile_slope_um": [0, 0]}},
    "gear2": {"profile_waves": [1, 3], "helix_waves": [0, 0],
              "modifications": {"profile_slope_um": [0, 0]}}})");
  const Json scatter = scatter_answered(tree)["scatter"];
  std::vector<std::string> waves;
  for (const std::string name : scatter["inputs"])
    if (name.ends_with("_waves")) waves.push_back(name);
  EXPECT_EQ(waves, std::vector<std::string>{"gear2.profile_waves"});
  const double count = scatter["worst"]["peak_to_peak_arcsec"]["at"]["gear2.profile_waves"][0];
  EXPECT_EQ(count, std::round(count));
}

// A series of DIN 3967 and JS7 on the drawing have the effect of the same ranges in [scatter].
TEST(ScatterAnswer, TolerancesOfTheDrawingVary) {
  const Json task = {{"samples", 64}, {"replicates", 2}};
  Json drawn = spec_with(""), given = spec_with("");
  drawn["scatter"] = given["scatter"] = task;
  drawn["pair"]["center_distance_tolerance"] = "JS7";
  const double js = js_deviation("JS7", 60.4).value();
  given["scatter"]["errors"]["center_distance_mm"] = {-js, js};
  for (const auto& [gear, diameter] : {std::pair("gear1", 40.0), std::pair("gear2", 80.0)}) {
    drawn[gear].erase("thickness_allowance_mm");
    drawn[gear]["tolerance"]["thickness_series"] = "cd25";
    const auto [lower, upper] = thickness_allowances("cd25", diameter).value();
    given[gear]["thickness_allowance_mm"] = (lower + upper) / 2;
    given["scatter"][gear]["thickness_allowance_mm"] = {-(upper - lower) / 2, (upper - lower) / 2};
  }
  const Json answer = scatter_answered(drawn)["scatter"];
  const Json same = scatter_answered(given)["scatter"];
  EXPECT_EQ(answer["inputs"], same["inputs"]);
  EXPECT_EQ(answer["ranges_from"],
            Json({"pair.center_distance_tolerance", "gear1.tolerance.thickness_series",
                  "gear2.tolerance.thickness_series"}));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(answer["least_play_deg"]["percentiles"][i].get<double>(),
                same["least_play_deg"]["percentiles"][i].get<double>(), 1e-12);
  EXPECT_GT(answer["least_play_deg"]["standard_deviation"], 0.001);
  // A range in [scatter] replaces that of the drawing.
  drawn["scatter"]["errors"]["center_distance_mm"] = {-0.05, 0.05};
  EXPECT_EQ(scatter_answered(drawn)["scatter"]["ranges_from"][0],
            "scatter.errors.center_distance_mm");
}

TEST(ScatterAnswer, UnderLoadTheNumberOfSamplesIsLimited) {
  Json spec = loaded_spec(80);
  spec["scatter"]["samples"] = 4;
  spec["scatter"]["loaded_samples"] = 3;
  EXPECT_EQ(scatter_answered(spec)["scatter"]["loaded"][0]["unsolved"]["of"], 2);
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

// The raster is in the result only if the key `pattern` is given, and the shares are computed from
// at most 256 samples.
TEST(ScatterAnswer, PatternsAreCountedOnRequest) {
  const std::string family =
      R"({"samples": 256, "replicates": 4, "errors": {"crossing_deg": [-0.02, 0.02]})";
  EXPECT_FALSE(scatter_answered(spec_with(family + "}"))["scatter"].contains("pattern"));
  Json spec = spec_with(family + R"(, "pattern": true})");
  spec["contact"]["marking_mm"] = 0.003;
  const Json pattern = scatter_answered(spec)["scatter"]["pattern"];
  EXPECT_EQ(pattern["samples"], 256);
  EXPECT_EQ(pattern["marking_mm"], 0.003);
  for (const char* gear : {"gear1", "gear2"}) {
    const Json& flank = pattern[gear];
    ASSERT_EQ(flank["share"].size(), flank["diameter_mm"].size());
    double most = 0.0, least = 1.0;
    for (const Json& row : flank["share"]) {
      ASSERT_EQ(row.size(), flank["height_mm"].size());
      for (const Json& share : row) {
        most = std::max(most, share.get<double>());
        least = std::min(least, share.get<double>());
      }
    }
    // With 3 µm of marking compound and 8 µm of crowning, the pattern never reaches the ends of the
    // face but always covers some points.
    EXPECT_EQ(most, 1.0);
    EXPECT_EQ(least, 0.0);
  }
}

}  // namespace
}  // namespace gearwright
