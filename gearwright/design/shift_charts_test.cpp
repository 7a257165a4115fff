// The charts are compared with 40-digit values that share no code with the engine.
#include "gearwright/design/shift_charts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/design/testing/search_reference.hpp"
#include "gearwright/design/trial_gear.hpp"

namespace gearwright {
namespace {

using testing::search::number;

constexpr double kAccuracy = 1e-12;  // modules, as stated in the header

const nlohmann::json& charts() {
  static const nlohmann::json file =
      nlohmann::json::parse(std::ifstream(testing::source_file("tests/oracle/shift_charts.json")));
  return file;
}

SearchProblem spur(double edge_depth = 1.0) {
  SearchProblem problem;
  problem.racks[0].undercut_depth = {edge_depth, edge_depth};
  problem.mounting = Mounting::extended;
  return problem;
}

TEST(ShiftCharts, LimitsAreThoseOfTheReference) {
  const auto chart = shift_limit_chart(spur(), 0, Angle(), 0, 7, 100);
  const auto sharp = shift_limit_chart(spur(1.25), 0, Angle(), 0, 7, 100);
  ASSERT_EQ(chart.size(), 94u);
  EXPECT_EQ(charts()["limits"].size(), 33u);
  for (const auto& row : charts()["limits"]) {
    const auto i = row["z"].get<std::size_t>() - 7;
    EXPECT_EQ(chart[i].teeth, row["z"].get<int>());
    EXPECT_NEAR(chart[i].undercut, number(row["undercut_1"]), kAccuracy);
    EXPECT_NEAR(sharp[i].undercut, number(row["undercut_1.25"]), kAccuracy);
    for (std::size_t tip = 0; tip < kChartTips.size(); ++tip)
      EXPECT_NEAR(chart[i].tip[tip], number(row["tip"][tip]), kAccuracy) << chart[i].teeth;
  }
}

TEST(ShiftCharts, TheProblemsOwnLimitsAreThoseOfItsTrials) {
  SearchProblem problem = spur();
  problem.limits.min_shift = -0.6;
  problem.limits.max_shift = 1.0;
  problem.limits.tip_thickness = 0.4;
  for (const ShiftLimits& row : shift_limit_chart(problem, 0, Angle::radians(0.3), 1, 9, 60)) {
    const TrialGear gear = trial_gear(problem, row.teeth, Angle::radians(0.3), 0, 1);
    EXPECT_EQ(row.min, gear.x_min);
    EXPECT_EQ(row.max, gear.x_max);
    EXPECT_EQ(row.min, std::max(-0.6, row.undercut));
    EXPECT_EQ(row.max, std::min(1.0, row.tip[2]));
    EXPECT_GT(row.tip[0], row.tip[1]);
    EXPECT_GT(row.tip[1], row.tip[2]);
  }
}

TEST(ShiftCharts, LimitsMeetWhereTheReferenceHasThem) {
  const auto chart = shift_limit_chart(spur(), 0, Angle(), 0, 7, 40);
  for (std::size_t tip = 0; tip < kChartTips.size(); ++tip) {
    const double exact = number(charts()["teeth_where_limits_meet"][tip]);
    const auto meet = where_limits_meet(chart, tip);
    ASSERT_TRUE(meet);
    EXPECT_NEAR(meet->teeth, exact, 0.01);
    EXPECT_EQ(meet->fewest, static_cast<int>(std::ceil(exact)));
    EXPECT_NEAR(meet->shift,
                1.0 - exact * std::pow(std::sin(spur().normal_pressure_angle.rad()), 2) / 2.0,
                0.01);
  }
  EXPECT_FALSE(where_limits_meet(shift_limit_chart(spur(), 0, Angle(), 0, 20, 40), 0));
}

TEST(ShiftCharts, ContactRatiosOfIdenticalGears) {
  int numbers = 0;
  int none = 0;
  for (const auto& row : charts()["identical_gears"]) {
    SearchProblem problem = spur();
    if (!row["floor"].is_null()) problem.limits.min_shift = row["floor"].get<double>();
    problem.limits.tip_thickness = row["tip_thickness"].get<double>();
    const int z = row["z"].get<int>();
    const auto chart = identical_gears_chart(problem, 0, Angle(), z, z);
    ASSERT_EQ(chart.size(), 1u);
    EXPECT_NEAR(chart[0].limits.min, number(row["shifts"][0]), kAccuracy) << z;
    EXPECT_NEAR(chart[0].limits.max, number(row["shifts"][1]), kAccuracy) << z;
    for (std::size_t k = 0; k < 5; ++k) {
      const auto& eps = row["contact_ratio"];
      const bool exists = !eps.is_null() && !eps[k].is_null();
      ASSERT_EQ(chart[0].contact_ratio[k].has_value(), exists) << z << " " << k;
      if (exists) {
        EXPECT_NEAR(*chart[0].contact_ratio[k], number(eps[k]), kAccuracy) << z << " " << k;
        ++numbers;
      } else {
        ++none;
      }
    }
  }
  EXPECT_GT(numbers, 250);
  EXPECT_GT(none, 20);
}

// At tight centres without a lower limit, a short addendum is reduced further until no flank
// remains.
TEST(ShiftCharts, TipsInsideTheirBaseCirclesHaveNoContactRatio) {
  SearchProblem problem = spur();
  problem.mounting = Mounting::tight;
  problem.shorten_tips = true;
  problem.racks[0].rack[0].addendum = 0.8;
  int none = 0;
  for (const IdenticalGears& row : identical_gears_chart(problem, 0, Angle(), 7, 400)) {
    for (const auto& eps : row.contact_ratio) {
      if (!eps) {
        ++none;
      } else {
        EXPECT_GT(*eps, 0.0) << row.limits.teeth;
      }
    }
  }
  EXPECT_GT(none, 300);
}

// The chart describes pairs of identical external gears, so the ratio, the centre distance and the
// rack of the wheel of the problem have no effect.
TEST(ShiftCharts, TheProblemsDistanceRatioAndWheelRackChangeNothing) {
  SearchProblem problem = spur();
  const auto plain = identical_gears_chart(problem, 0, Angle(), 12, 30);
  problem.ratio = {-3.0, -2.5};
  problem.center_distance = std::array<double, 2>{99.0, 99.0};
  problem.racks[0].rack[1].addendum = 0.8;
  problem.racks[0].undercut_depth[1] = 1.25;
  const auto asked = identical_gears_chart(problem, 0, Angle(), 12, 30);
  for (std::size_t i = 0; i < plain.size(); ++i)
    EXPECT_EQ(plain[i].contact_ratio, asked[i].contact_ratio);
}

}  // namespace
}  // namespace gearwright
