// Tolerances of a spec, which is solved at both ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/job/verbs.hpp"

namespace gearwright {
namespace {

Json answer(std::string_view verb, const Json& spec) {
  const JobSpec read = testing::taken(read_spec(json_text(spec), SpecFormat::json));
  return testing::taken(answer_json(verb, read));
}

Error refused_spec(std::string_view verb, const Json& spec) {
  const auto read = read_spec(json_text(spec), SpecFormat::json);
  if (!read) return read.error();
  const auto got = answer_json(verb, *read);
  EXPECT_FALSE(got) << json_text(spec);
  return got ? Error{} : got.error();
}

Json gear(int teeth, const Json& allowance) {
  Json g{
      {"teeth", teeth}, {"normal_module_mm", 2.5}, {"face_width_mm", 20}, {"profile_shift", 0.1}};
  if (!allowance.is_null()) g["thickness_allowance_mm"] = allowance;
  return g;
}

// (1) each end equals the result of the spec with that number   (2) the gear is made at the mean
TEST(ToleranceEnds, are_the_answers_at_both_numbers) {
  const Json two{{"gear1", gear(17, {-0.10, -0.06})},
                 {"gear2", gear(40, {-0.12, -0.08})},
                 {"pair", {{"center_distance_mm", 72}}}};
  const auto at = [&](double first, double second) {
    Json spec = two;
    spec["gear1"]["thickness_allowance_mm"] = first;
    spec["gear2"]["thickness_allowance_mm"] = second;
    return answer("pair", spec);
  };
  const Json both = answer("pair", two), thin = at(-0.10, -0.12), thick = at(-0.06, -0.08),
             mean = at(-0.08, -0.10);
  for (const char* key :
       {"generating_profile_shift", "reference_tooth_thickness_normal_mm", "root_diameter_mm"}) {
    EXPECT_EQ(both["gears"][0]["interval"][key][0], thin["gears"][0][key]) << key;  // (1)
    EXPECT_EQ(both["gears"][0]["interval"][key][1], thick["gears"][0][key]) << key;
    EXPECT_DOUBLE_EQ(both["gears"][0][key].get<double>(), mean["gears"][0][key]);  // (2)
  }
  const Json& range = both["pair"]["interval"]["backlash"]["normal_mm"];
  EXPECT_EQ(range[0], thin["pair"]["backlash"]["normal_mm"]);
  EXPECT_EQ(range[1], thick["pair"]["backlash"]["normal_mm"]);
  EXPECT_GT(range[0], range[1]);
  EXPECT_FALSE(both["pair"]["interval"].contains("center_distance_mm"));
  EXPECT_FALSE(mean["pair"].contains("interval"));
}

TEST(ToleranceEnds, of_the_centre_distance_go_with_the_backlash) {
  Json spec{{"gear1", gear(17, {-0.10, -0.06})},
            {"gear2", gear(40, -0.1)},
            {"pair", {{"center_distance_mm", 72}, {"center_distance_tolerance", "JS7"}}}};
  const Json a = answer("pair", spec)["pair"]["interval"]["center_distance_mm"];
  // Thin teeth and a great centre distance have the most backlash.
  EXPECT_DOUBLE_EQ(a[0].get<double>(), 72.015);
  EXPECT_DOUBLE_EQ(a[1].get<double>(), 71.985);
  // Profile shifts that were computed from the centre distance keep the values of the drawing.
  spec["gear2"].erase("profile_shift");
  const Json free = answer("pair", spec);
  EXPECT_FALSE(free["gears"][1]["interval"].contains("profile_shift"));
  spec["pair"]["center_distance_tolerance"] = "K7";
  EXPECT_EQ(refused_spec("pair", spec).field, "pair.distance_tolerance");
}

// Contact ratio and tip clearances are compared for short teeth far apart and for long teeth close
// together.
TEST(ToleranceEnds, of_the_tip_diameters_move_contact_ratio_and_clearance) {
  for (const int mate : {40, -60}) {
    Json spec{{"gear1", gear(17, -0.08)}, {"gear2", gear(mate, -0.1)}};
    spec["pair"]["center_distance_mm"] = mate > 0 ? 72 : 54.5;
    const Json drawn = answer("pair", spec);
    Json tolerated = spec;
    for (const char* g : {"gear1", "gear2"})
      tolerated[g]["tolerance"]["tip_diameter_deviations_mm"] = {-0.1, 0.02};
    const Json both = answer("pair", tolerated);
    for (const int end : {0, 1}) {
      Json plain = spec;
      for (const int i : {0, 1}) {
        const double deviation = (end == 1) == (i == 0 || mate > 0) ? 0.02 : -0.1;
        const double tip = drawn["gears"][i]["tip_diameter_mm"].get<double>() + deviation;
        plain[i == 0 ? "gear1" : "gear2"]["tip_diameter_mm"] = tip;
        EXPECT_EQ(both["gears"][i]["interval"]["tip_diameter_mm"][end], tip);
      }
      const Json at = answer("pair", plain)["pair"];
      EXPECT_EQ(both["pair"]["interval"]["contact_ratio"][end], at["contact_ratio"]);
      for (const int i : {0, 1})
        EXPECT_EQ(both["pair"]["interval"]["tip_clearance_mm"][i][end], at["tip_clearance_mm"][i]);
    }
    EXPECT_LT(both["pair"]["interval"]["contact_ratio"][0], drawn["pair"]["contact_ratio"]);
  }
  Json rounded{{"gear1", gear(17, nullptr)}};
  rounded["gear1"]["tip_fillet"] = {{"radius_mm", 0.3}};
  rounded["gear1"]["tolerance"]["tip_diameter_deviations_mm"] = {-0.1, 0.0};
  EXPECT_EQ(refused_spec("gear", rounded).field, "gear1.tolerance.tip_deviations");
}

TEST(ToleranceEnds, a_backlash_range_says_the_allowances) {
  Json spec{{"gear1", gear(17, nullptr)},
            {"gear2", gear(40, nullptr)},
            {"pair",
             {{"center_distance_mm", 72},
              {"backlash_mm", {0.10, 0.20}},
              {"center_distance_deviations_mm", {-0.01, 0.01}}}}};
  const Json pair = answer("pair", spec)["pair"];
  EXPECT_NEAR(pair["interval"]["backlash"]["normal_mm"][0].get<double>(), 0.20, 1e-9);
  EXPECT_NEAR(pair["interval"]["backlash"]["normal_mm"][1].get<double>(), 0.10, 1e-9);
  spec["pair"]["center_distance_deviations_mm"] = {-0.2, 0.2};
  EXPECT_EQ(refused_spec("pair", spec).field, "pair.backlash");
}

TEST(ToleranceEnds, a_span_or_balls_say_the_allowance) {
  for (const int teeth : {23, 24, -60}) {
    Json plain{{"gear1", gear(teeth, {-0.11, -0.05})}};
    const Json measured = answer("measure", plain)["gears"][0]["measure"];
    const Json &W = measured["interval"]["span"]["length_mm"],
               &M = measured["interval"]["over_balls"]["dimension_mm"];
    const auto growing = [](Json ends) {
      if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
      return ends;
    };
    Json by_span{{"gear1", gear(teeth, nullptr)}}, by_balls = by_span;
    by_span["gear1"]["measure"] = {{"span_teeth", measured["span"]["teeth"]}};
    by_span["gear1"]["tolerance"] = {{"span_mm", growing(W)}};
    by_balls["gear1"]["measure"] = {
        {"ball_diameter_mm", measured["over_balls"]["ball_diameter_mm"]}};
    by_balls["gear1"]["tolerance"] = {{"over_balls_mm", growing(M)}};
    const Json wanted = answer("gear", plain)["gears"][0]["interval"];
    for (const Json& spec : {by_span, by_balls}) {
      const Json got = answer("gear", spec)["gears"][0]["interval"];
      for (const int end : {0, 1})
        EXPECT_NEAR(got["reference_tooth_thickness_normal_mm"][end].get<double>(),
                    wanted["reference_tooth_thickness_normal_mm"][end].get<double>(), 1e-12)
            << teeth;
    }
  }
  Json series{{"gear1", gear(40, nullptr)}};
  series["gear1"]["tolerance"] = {{"thickness_series", "cd25"}};
  const Json s = answer("gear", series)["gears"][0]["interval"];
  const Json full = answer("gear", Json{{"gear1", gear(40, 0.0)}})["gears"][0];
  EXPECT_NEAR(s["reference_tooth_thickness_normal_mm"][0].get<double>(),
              full["reference_tooth_thickness_normal_mm"].get<double>() - 0.11, 1e-14);
  series["gear1"]["tolerance"]["thickness_series"] = "zz99";
  EXPECT_EQ(refused_spec("gear", series).field, "gear1.tolerance.series");
}

// Every number of `interval` encloses the number of a gear or a pair within the tolerances.
void expect_enclosed(const Json& interval, const Json& at, const std::string& path) {
  if (interval.is_null()) return;
  if (interval.is_array() && interval.size() == 2 && interval[0].is_number() && at.is_number()) {
    const double a = interval[0], b = interval[1], x = at;
    const double noise = 1e-9 * std::max(std::abs(a), std::abs(b));
    EXPECT_GE(x, std::min(a, b) - noise) << path;
    EXPECT_LE(x, std::max(a, b) + noise) << path;
  } else if (interval.is_object() && at.is_object()) {
    for (const auto& [key, inner] : interval.items())
      if (at.contains(key)) expect_enclosed(inner, at[key], path + "." + key);
  } else if (interval.is_array() && at.is_array()) {
    for (std::size_t i = 0; i < std::min(interval.size(), at.size()); ++i)
      expect_enclosed(interval[i], at[i], path + "[" + std::to_string(i) + "]");
  }
}

// The nominal centre distance without backlash, 47.1969 mm, lies outside the tolerance.
TEST(ToleranceEnds, exclude_a_nominal_value_outside_the_tolerance) {
  Json spec{{"gear1", gear(17, nullptr)},
            {"gear2", {{"teeth", 30}, {"face_width_mm", 20}}},
            {"pair", {{"center_distance_deviations_mm", {0.05, 0.1}}}}};
  spec["gear1"]["normal_module_mm"] = 2;
  const auto at = [&](double deviation) {
    Json plain = spec;
    plain["pair"] = {{"center_distance_mm", 47.1969 + deviation}};
    plain["gear2"]["profile_shift"] = 0;
    return answer("pair", plain)["pair"]["backlash"]["normal_mm"].get<double>();
  };
  const Json drawn = answer("pair", spec)["pair"];
  const double a = drawn["center_distance_mm"];
  EXPECT_NEAR(a, 47.1969, 5e-5);
  EXPECT_NEAR(drawn["interval"]["center_distance_mm"][0].get<double>(), a + 0.1, 1e-12);
  EXPECT_NEAR(drawn["interval"]["center_distance_mm"][1].get<double>(), a + 0.05, 1e-12);
  EXPECT_NEAR(drawn["interval"]["backlash"]["normal_mm"][0].get<double>(), at(0.1), 1e-4);
  EXPECT_NEAR(drawn["interval"]["backlash"]["normal_mm"][1].get<double>(), at(0.05), 1e-4);

  // Equal deviations are a tolerance of width 0 beside the nominal value.
  spec["pair"]["center_distance_deviations_mm"] = {0.1, 0.1};
  const Json equal = answer("pair", spec);
  for (const int end : {0, 1}) {
    EXPECT_NEAR(equal["pair"]["interval"]["center_distance_mm"][end].get<double>(), a + 0.1, 1e-12);
    EXPECT_NEAR(equal["pair"]["interval"]["backlash"]["normal_mm"][end].get<double>(), at(0.1),
                1e-4);
  }
  EXPECT_FALSE(equal["pair"]["interval"].contains("gear_ratio"));
  const std::string headline = equal["verdict"]["headline"];
  EXPECT_NE(headline.find(" Within the tolerances, the backlash is 0.076"), std::string::npos)
      << headline;
  EXPECT_EQ(headline.find(" mm to "), std::string::npos) << headline;

  // At both ends of this tolerance the gears jam.
  spec["pair"]["center_distance_deviations_mm"] = {-0.1, -0.1};
  EXPECT_EQ(answer("pair", spec)["verdict"]["level"], "red");

  spec["gear1"]["tolerance"] = {{"tip_diameter_deviations_mm", {-0.3, -0.2}}};
  const Json tips = answer("gear", {{"gear1", spec["gear1"]}})["gears"][0];
  const double tip = tips["tip_diameter_mm"];
  EXPECT_NEAR(tips["interval"]["tip_diameter_mm"][0].get<double>(), tip - 0.3, 1e-12);
  EXPECT_NEAR(tips["interval"]["tip_diameter_mm"][1].get<double>(), tip - 0.2, 1e-12);
}

TEST(ToleranceEnds, combinations_are_arranged_once_for_all_outputs) {
  const Json spec{{"gear1", gear(17, {-0.10, -0.06})},
                  {"gear2", gear(40, {-0.12, -0.08})},
                  {"pair", {{"center_distance_mm", 72}}}};
  const JobSpec read = testing::taken(read_spec(json_text(spec), SpecFormat::json));
  const SolvedJob job = testing::taken(solve(read, Scope::pair));
  const SolvedJob copy = job;
  EXPECT_EQ(job.corners().size(), 4u);
  EXPECT_EQ(&job.corners(), &copy.corners());
}

// A thin tooth with a great tip diameter has the thinnest tip, and this combination occurs at
// neither end. With z 119, m 8, x −0.4, the tip is 6.5142 mm and 6.5061 mm thick at the ends, and
// its nominal thickness is 6.4657 mm.
TEST(ToleranceEnds, enclose_all_combinations) {
  const Json big{{"gear1",
                  {{"teeth", 119},
                   {"normal_module_mm", 8},
                   {"helix_angle_deg", 8.1},
                   {"profile_shift", -0.4},
                   {"face_width_mm", 160},
                   {"tolerance", {{"thickness_series", "c26"}, {"tip_diameter_fit", "h9"}}}}}};
  const Json wheel = answer("gear", big)["gears"][0];
  const Json limits = wheel["interval"];
  const Json& tip = limits["tip_tooth_thickness_normal_mm"];
  Json at = big;
  at["gear1"].erase("tolerance");
  const auto thickness = [&](std::size_t allowance, std::size_t diameter) {
    at["gear1"]["thickness_allowance_mm"] = limits["thickness_allowance_mm"][allowance];
    at["gear1"]["tip_diameter_mm"] = limits["tip_diameter_mm"][diameter];
    return answer("gear", at)["gears"][0]["tip_tooth_thickness_normal_mm"].get<double>();
  };
  EXPECT_NEAR(tip[0].get<double>(), thickness(0, 1), 1e-12);
  EXPECT_NEAR(tip[1].get<double>(), thickness(1, 0), 1e-12);
  EXPECT_LT(tip[0], wheel["tip_tooth_thickness_normal_mm"]);
  EXPECT_GT(tip[1], wheel["tip_tooth_thickness_normal_mm"]);

  for (const int mate : {40, -60}) {
    Json pair{{"gear1", gear(17, {-0.10, -0.06})}, {"gear2", gear(mate, {-0.12, -0.08})}};
    const double a = mate > 0 ? 72 : 54.5;
    pair["pair"] = {{"center_distance_mm", a}, {"center_distance_deviations_mm", {-0.02, 0.02}}};
    const Json drawn = answer("pair", pair);
    Json tolerated = pair;
    for (const char* g : {"gear1", "gear2"})
      tolerated[g]["tolerance"]["tip_diameter_deviations_mm"] = {-0.1, 0.02};
    const Json all = answer("measure", tolerated);
    const Json of_pair = answer("pair", tolerated);
    for (const double u : {0.0, 0.3, 1.0}) {
      for (const double v : {0.0, 0.6, 1.0}) {
        Json inner = pair;
        inner["gear1"]["thickness_allowance_mm"] = -0.10 + 0.04 * u;
        inner["gear2"]["thickness_allowance_mm"] = -0.12 + 0.04 * v;
        inner["pair"] = {{"center_distance_mm", a - 0.02 + 0.04 * v}};
        for (const std::size_t i : {0u, 1u})
          inner[i == 0 ? "gear1" : "gear2"]["tip_diameter_mm"] =
              drawn["gears"][i]["tip_diameter_mm"].get<double>() - 0.1 + 0.12 * (1 - u);
        inner["gear1"]["measure"] = {{"span_teeth", all["gears"][0]["measure"]["span"]["teeth"]}};
        const Json at_inner = answer("pair", inner);
        expect_enclosed(of_pair["pair"]["interval"], at_inner["pair"], "pair");
        for (const std::size_t i : {0u, 1u})
          expect_enclosed(of_pair["gears"][i]["interval"], at_inner["gears"][i], "gear");
      }
    }
  }
}

// The nominal span over 3 teeth is 22.98 mm, and that over 4 teeth is 31.84 mm. An allowance may be
// half a pitch, 4.71 mm.
TEST(ToleranceEnds, refuse_a_dimension_of_another_number_of_teeth) {
  Json gear{{"teeth", 20}, {"normal_module_mm", 3}, {"face_width_mm", 25}};
  gear["measure"] = {{"span_teeth", 3}, {"ball_diameter_mm", 5}};
  gear["tolerance"] = {{"span_mm", {31.8, 31.85}}};
  const Error span = refused_spec("gear", {{"gear1", gear}});
  EXPECT_EQ(span.field, "gear1.tolerance.span");
  EXPECT_NE(span.message().find("nearest to the span over 4 teeth"), std::string::npos)
      << span.message();
  gear["tolerance"] = {{"over_balls_mm", {77, 77.1}}};
  EXPECT_EQ(refused_spec("gear", {{"gear1", gear}}).field, "gear1.tolerance.over_balls");
  gear["tolerance"] = {{"span_mm", {20.8, 20.85}}};
  const Json thin = answer("gear", {{"gear1", gear}})["gears"][0];
  EXPECT_NEAR(thin["reference_tooth_thickness_normal_mm"].get<double>(),
              1.5 * std::numbers::pi + (20.825 - 22.981330) / std::cos(std::numbers::pi / 9), 1e-4);
}

}  // namespace
}  // namespace gearwright
