// If K_Hβ = "computed", the verb `rate` takes K_Hβ from the verb `load`, at the worse limit of the
// mesh misalignment f_ma.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/testing/answered.hpp"

namespace gearwright {
namespace {

// Returns a case-hardened pair with a pinion near one of its bearings. Most tests use spur gears,
// for which the load is computed three times as fast.
Json shafted_pair(double crowning_um = 0.0, double helix_angle_deg = 0.0) {
  Json tree = Json::parse(R"({
    "gear1": {"teeth": 23, "normal_module_mm": 3, "face_width_mm": 30,
              "material": "16MnCr5", "bore": {"diameter_mm": 30},
              "shaft": {"bearings_mm": [-40, 90], "diameter_mm": 30}},
    "gear2": {"teeth": 41, "bore": {"diameter_mm": 40}},
    "load": {"positions": 6, "slices": 8, "accuracy": "draft"},
    "rating": {"torque_Nm": 250, "speed_rpm": 1500, "application_factor": 1.25, "quality": 6,
               "life_h": 20000, "face_load_factor": "computed"}})");
  tree["gear1"]["helix_angle_deg"] = helix_angle_deg;
  if (crowning_um != 0.0) tree["gear1"]["modifications"]["lead_crowning_um"] = crowning_um;
  return tree;
}

Json face_rated(const Json& tree) {
  const Json answer = testing::answered(tree, "rate");
  EXPECT_TRUE(answer.contains("rating")) << answer;
  return answer["rating"];
}

// Returns K_Hβ as the verb `load` computes it with this deflection slope.
double face_load_of(Json tree, double torque_Nm, double slope_um) {
  tree.erase("rating");
  tree["load"]["torque_Nm"] = torque_Nm;
  tree["load"]["deflection_slope_um"] = slope_um;
  return testing::answered(tree, "load")["load"]["torques"][0]["face_load_factor"];
}

TEST(RatingFaceLoad, is_that_of_load_at_the_worse_limit) {
  const Json tree = shafted_pair(8.0, 15.0);
  SolvedJob job = testing::taken(solve(testing::taken(read_spec_tree(tree)), Scope::pair));
  Progress progress;
  const RatingAnswer answer = testing::taken(answer_rating(job, &progress));
  EXPECT_STREQ(progress.state().stage, "computing K_Hβ from the load along the teeth");
  const Rating& r = answer.rating;
  const auto& [one, two] = *r.tolerance;
  const double slope = std::hypot(one.f_Hbeta, two.f_Hbeta) * std::cos(answer.pair.beta_b);
  const double torque = 250 * 1.25 * r.K_v.value;
  const double lower = face_load_of(tree, torque, -slope);
  const double upper = face_load_of(tree, torque, slope);
  EXPECT_GT(std::abs(upper - lower), 0.05);
  EXPECT_NEAR(r.face.K_Hbeta.value, std::max(lower, upper), 1e-9);
  EXPECT_FALSE(answer.face_holding);
  for (const Warning& w : job.warnings) EXPECT_NE(w.code, WarningCode::rating_crowning);
}

// `propose` computes the same limits from its own deviation, which is normal to the flank.
TEST(RatingFaceLoad, is_that_of_propose_for_the_same_deviation) {
  Json tree = shafted_pair(8.0, 15.0);
  tree["rating"].erase("application_factor");
  tree["rating"]["dynamic_factor"] = 1.0;
  const Json proposed = testing::answered(tree, "propose")["propose"];
  const double normal = proposed["helix_deviation_um"];
  const double beta_b =
      std::asin(std::sin(Angle::degrees(15).rad()) * std::cos(Angle::degrees(20).rad()));
  tree["rating"]["misalignment_um"] = normal / std::cos(beta_b);
  EXPECT_NEAR(face_rated(tree)["K_Hbeta"].get<double>(),
              proposed["proposals"][0]["at_helix_limits"]["face_load_factor"].get<double>(), 1e-9);
}

TEST(RatingFaceLoad, has_a_minimum_over_the_crowning) {
  const auto K_Hbeta = [](double um) {
    return face_rated(shafted_pair(um))["K_Hbeta"].get<double>();
  };
  const double none = K_Hbeta(0), middle = K_Hbeta(8), much = K_Hbeta(60);
  EXPECT_LT(middle, none - 0.02);
  EXPECT_LT(middle, much - 0.2);
}

TEST(RatingFaceLoad, holds_at_the_torque_of_the_required_safeties) {
  Json tree = shafted_pair(8.0);
  tree["rating"]["safety_flank_min"] = 1.3;
  tree["rating"]["safety_root_min"] = 1.6;
  const Json first = face_rated(tree);
  tree["rating"]["torque_Nm"] = first["torque_holding_Nm"];
  const Json again = face_rated(tree);
  EXPECT_GT(std::abs(again["K_Hbeta"].get<double>() - first["K_Hbeta"].get<double>()), 1e-3);
  double share = 1e9;  // the least of the safeties relative to the required ones
  for (const std::size_t i : {0u, 1u}) {
    share = std::min(share, again["S_H"][i].get<double>() / 1.3);
    share = std::min(share, again["S_F"][i].get<double>() / 1.6);
  }
  EXPECT_GE(share, 1 - 1e-9);
  EXPECT_LE(share, 1 + 1e-5);
}

TEST(RatingFaceLoad, is_computed_for_each_step_of_a_spectrum) {
  Json one = shafted_pair(8.0);
  one["rating"]["torque_Nm"] = 30;
  one["rating"]["application_factor"] = 1.0;
  const Json alone = face_rated(one);
  Json steps = shafted_pair(8.0);
  steps["rating"].erase("life_h");
  steps["rating"]["spectrum"] = {{{"torque_Nm", 30}, {"speed_rpm", 1500}, {"duration_h", 20000}}};
  const Json spectrum = face_rated(steps);
  EXPECT_GT(std::abs(spectrum["K_Hbeta"].get<double>() - alone["K_Hbeta"].get<double>()), 0.01);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_NEAR(spectrum["S_H_spectrum"][i].get<double>(), alone["S_H"][i].get<double>(), 1e-6);
    EXPECT_NEAR(spectrum["S_F_spectrum"][i].get<double>(), alone["S_F"][i].get<double>(), 1e-6);
  }
}

TEST(RatingFaceLoad, has_no_remedy_for_another_face_width) {
  Json tree = shafted_pair();
  tree["rating"]["torque_Nm"] = 1500;
  const Json verdict = testing::answered(tree, "rate")["verdict"];
  ASSERT_EQ(verdict["level"], "red") << verdict;
  EXPECT_EQ(verdict.dump().find("face width"), std::string::npos) << verdict;
}

TEST(RatingFaceLoad, is_rejected_without_its_inputs_and_for_other_specs) {
  const auto expect = [](const Json& tree, const char* key, const char* words) {
    const Json answer = testing::answered(tree, "rate");
    ASSERT_TRUE(answer.contains("key")) << answer;
    EXPECT_EQ(answer["key"], key) << answer;
    EXPECT_NE(answer["rule"].get<std::string>().find(words), std::string::npos) << answer;
  };
  Json tree = shafted_pair();
  tree["gear1"].erase("shaft");
  expect(tree, "gear1.shaft", "deflection_slope_um");
  tree["load"]["deflection_slope_um"] = 0;
  EXPECT_GT(face_rated(tree)["K_Hbeta"].get<double>(), 1.0);

  tree = shafted_pair();
  tree["rating"].erase("quality");
  tree["rating"]["dynamic_factor"] = 1.1;
  tree["rating"]["transverse_load_factor"] = 1.1;
  expect(tree, "rating.quality", "helix slopes");
  tree["rating"]["misalignment_um"] = 10;
  EXPECT_GT(face_rated(tree)["K_Hbeta"].get<double>(), 1.0);

  tree = shafted_pair();
  tree["rating"]["face_load_factor"] = "by load";
  expect(tree, "rating.face_load_factor", "must be a number, or \"computed\"");
  tree["rating"]["face_load_factor"] = 0.5;
  expect(tree, "rating.face_load_factor", "between 1 and 100");

  tree = shafted_pair();
  tree["gear1"].erase("shaft");
  tree["rating"]["mounting"] = {{"bearing_span_mm", 130}, {"shaft_diameter_mm", 30}};
  expect(tree, "rating.face_load_factor", "[rating.mounting]");

  tree = shafted_pair(0.0, 15.0);
  tree["gear1"]["double_helical"] = {{"gap_mm", 4}};
  tree["gear2"]["double_helical"] = {{"gap_mm", 4}};
  tree["gear1"].erase("shaft");
  expect(tree, "rating.face_load_factor", "single-helical");
  tree.erase("load");
  expect(tree, "rating.face_load_factor", "single-helical");

  Json search = {{"search", {{"ratio", 2}, {"center_distance_mm", 100}, {"safety_flank_min", 1.2}}},
                 {"gear1", {{"material", "16MnCr5"}}},
                 {"rating", shafted_pair()["rating"]}};
  search["rating"].erase("life_h");
  const auto read = read_spec_tree(search);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().field, "rating.face_load_factor");
  EXPECT_NE(read.error().rule.find("is not supported in a search"), std::string::npos);
}

}  // namespace
}  // namespace gearwright
