#include "gearwright/report/search_figures.hpp"

#include <gtest/gtest.h>

#include "gearwright/report/testing/page_text.hpp"
#include "gearwright/report/testing/sample_search.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

using testing::count_of;
using testing::expect_sound_figure;

TEST(ShiftChartPictures, TheFewestTeethAreThoseOfTheText) {
  const SearchProblem problem = testing::spur_problem();
  const std::string figure = shift_limits_figure(problem, Trial{}, nullptr);
  expect_sound_figure(figure);
  EXPECT_NE(figure.find("8 teeth for a pointed tip, 10 teeth for 0.2, 12 teeth for 0.4"),
            figure.npos);
  for (const char* name : {">pointed<", ">tip 0.2<", ">tip 0.4<"})
    EXPECT_EQ(count_of(figure, name), 1u) << name;
  EXPECT_EQ(count_of(figure, ">undercut<"), 2u);  // one label at the curve and one in the legend
  EXPECT_EQ(count_of(figure, "class=\"room\""), 1u);
  EXPECT_EQ(figure.find("gear 2"), figure.npos);
}

TEST(ShiftChartPictures, TheDesignIsMarkedWhereItIsOnTheChart) {
  const auto sample = testing::spur_search();
  DesignRow row = sample.answer->designs.front();
  const auto rings = [&] {
    const std::string figure = shift_limits_figure(sample.search->problem(), row.trial, &row);
    expect_sound_figure(figure);
    return count_of(figure, "class=\"design-ring\"");
  };
  EXPECT_EQ(rings(), 2u);
  row.trial.z2 = 101;
  EXPECT_EQ(rings(), 1u);
  row.trial.z2 = -60;
  EXPECT_EQ(rings(), 1u);
}

TEST(ShiftChartPictures, TwelveTeethReachTheSoundContactRatio) {
  const std::string figure = identical_gears_figure(testing::spur_problem(), Trial{});
  expect_sound_figure(figure);
  EXPECT_NE(figure.find("From 12 teeth on, some profile shift reaches 1.2."), figure.npos);
  EXPECT_EQ(count_of(figure, "class=\"curve share"), 5u);
  for (const char* name : {">least shift<", ">¼ of the way<", ">½<", ">¾<", ">greatest shift<"})
    EXPECT_EQ(count_of(figure, name), 2u) << name;  // one label at the curve and one in the legend
  EXPECT_EQ(figure.find("required contact ratio"), figure.npos);
  SearchProblem quiet = testing::spur_problem();
  quiet.limits.contact_ratio = 1.4;
  EXPECT_NE(identical_gears_figure(quiet, Trial{}).find("required contact ratio of 1.4"),
            std::string::npos);
}

TEST(ShiftChartPictures, IdenticalGearsSayNothingOfRingsAndCrossedAxes) {
  const auto figure = [](const testing::SearchSample& sample) {
    return identical_gears_figure(sample.search->problem(), sample.answer->designs.front().trial);
  };
  EXPECT_EQ(figure(testing::ring_search()), "");
  EXPECT_EQ(figure(testing::crossed_search()), "");
  const std::string helical = figure(testing::helical_search());
  expect_sound_figure(helical);
  EXPECT_NE(helical.find("helix angle"), helical.npos);
}

TEST(ShiftChartPictures, LimitsThatLeaveNothingDrawNothing) {
  SearchProblem problem = testing::spur_problem();
  problem.limits.min_shift = 1.0;
  problem.limits.max_shift = 0.5;
  expect_sound_figure(shift_limits_figure(problem, Trial{}, nullptr));
  EXPECT_EQ(count_of(shift_limits_figure(problem, Trial{}, nullptr), "class=\"room\""), 0u);
  EXPECT_EQ(identical_gears_figure(problem, Trial{}), "");
  problem.limits.min_shift.reset();
  problem.limits.max_shift.reset();
  expect_sound_figure(shift_limits_figure(problem, Trial{}, nullptr));
  expect_sound_figure(identical_gears_figure(problem, Trial{}));
}

}  // namespace
}  // namespace gearwright
