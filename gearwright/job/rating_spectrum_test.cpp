// A load spectrum is judged like a single load, and a spectrum of one step has the numbers of a
// single load with the life of this step.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "gearwright/job/testing/answered.hpp"

namespace gearwright {
namespace {

Json rated(const Json& load, const Json& wanted = Json::object()) {
  Json tree = Json::parse(R"({
    "gear1": {"teeth": 21, "normal_module_mm": 3, "face_width_mm": 30, "material": "16MnCr5",
              "thickness_allowance_mm": -0.05},
    "gear2": {"teeth": 60},
    "rating": {"quality": 6, "face_load_factor": 1.2}})");
  tree["rating"].update(load);
  tree["rating"].update(wanted);
  return testing::answered(tree, "rate");
}

Json one_step(double torque_Nm, double hours = 100000) {
  return {{"spectrum", {{{"torque_Nm", torque_Nm}, {"speed_rpm", 1500}, {"duration_h", hours}}}}};
}

Json single(double torque_Nm, double hours = 100000) {
  return {{"torque_Nm", torque_Nm}, {"speed_rpm", 1500}, {"life_h", hours}};
}

TEST(RatingSpectrum, of_one_step_is_the_single_load) {
  const Json a = rated(one_step(300)), b = rated(single(300));
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_NEAR(a["rating"]["S_H_spectrum"][i].get<double>(), b["rating"]["S_H"][i].get<double>(),
                1e-6);
    EXPECT_NEAR(a["rating"]["S_F_spectrum"][i].get<double>(), b["rating"]["S_F"][i].get<double>(),
                1e-6);
  }
  for (const char* key : {"torque_holding_Nm", "face_width_holding_mm"}) {
    const double expected = b["rating"][key];
    EXPECT_NEAR(a["rating"][key].get<double>(), expected, 1e-6 * expected) << key;
  }
  ASSERT_LT(b["rating"]["S_H"][0].get<double>(), 1.0);
  EXPECT_EQ(a["verdict"]["level"], "red");
  EXPECT_EQ(b["verdict"]["level"], "red");
}

TEST(RatingSpectrum, is_judged_like_a_single_load) {
  const auto codes = [](const Json& answer) {
    std::vector<std::string> list;
    for (const Json& finding : answer["verdict"]["findings"]) list.push_back(finding["code"]);
    return list;
  };
  const auto count = [&](const Json& answer) {
    const std::vector<std::string> list = codes(answer);
    return std::count(list.begin(), list.end(), "spectrum_safety");
  };
  const Json failed = rated(one_step(300));
  EXPECT_EQ(count(failed), 1);
  const std::string headline = failed["verdict"]["headline"];
  EXPECT_EQ(
      headline.find("The pair does not withstand its load. The safety factor of gear 1 "
                    "against pitting under the load spectrum is 0.97, which is less than 1. "),
      0u)
      << headline;
  const Json low = rated(one_step(200), {{"safety_flank_min", 1.25}});
  ASSERT_GT(low["rating"]["S_H_spectrum"][0].get<double>(), 1.0);
  ASSERT_LT(low["rating"]["S_H_spectrum"][0].get<double>(), 1.25);
  EXPECT_EQ(low["verdict"]["level"], "amber");
  EXPECT_GE(count(low), 1);
  const Json good = rated(one_step(150));
  EXPECT_EQ(good["verdict"]["level"], "green");
  EXPECT_EQ(count(good), 0);
  EXPECT_NE(good["verdict"]["headline"].get<std::string>().find(
                "Under the load spectrum, the lowest safety factor is "),
            std::string::npos);
}

// The flanks do not withstand 450 N m for an unlimited life, but they do for one hour. Beside a
// spectrum, a single load has no life, so its safety factors are not judged.
TEST(RatingSpectrum, replaces_the_single_load_in_the_verdict) {
  const Json a = rated(one_step(450, 1)), b = rated(single(450, 1));
  ASSERT_LT(a["rating"]["S_H"][0].get<double>(), 1.0);
  EXPECT_NEAR(a["rating"]["S_H_spectrum"][0].get<double>(), b["rating"]["S_H"][0].get<double>(),
              1e-6);
  EXPECT_EQ(b["verdict"]["level"], "green");
  EXPECT_EQ(a["verdict"]["level"], "green");
  Json beside = one_step(200);
  beside.update({{"torque_Nm", 450}, {"speed_rpm", 1500}, {"application_factor", 1.5}});
  EXPECT_EQ(rated(beside)["verdict"]["level"], "green");
  // The remedy is that of the same load with a life.
  const Json weak = rated(one_step(2000, 1)), alone = rated(single(2000, 1));
  ASSERT_EQ(weak["verdict"]["level"], "red");
  const auto remedy = [](const Json& answer) {
    return answer["verdict"]["findings"][0]["remedy"].get<std::string>();
  };
  EXPECT_EQ(remedy(weak), remedy(alone));
}

}  // namespace
}  // namespace gearwright
