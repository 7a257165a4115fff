#include "gearwright/report/search_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "gearwright/figure/designs.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/report/search_table.hpp"
#include "gearwright/report/testing/sample_search.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

using testing::count_of;
using testing::SearchSample;

bool at_least(double a, double b, bool greater) { return greater ? a >= b : a <= b; }

TEST(ParetoPicture, TheStaircaseIsTheBorderOfWhatWasFound) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 10.0);
  for (int trial = 0; trial < 200; ++trial) {
    const std::array<bool, 2> greater{trial % 2 == 0, trial % 4 < 2};
    std::vector<Vec2> points;
    for (int i = 0; i < 1 + trial % 30; ++i)
      // Whole numbers give ties.
      points.push_back({std::floor(place(random)), std::floor(place(random))});
    const std::vector<Vec2> corners = staircase(points, greater);
    ASSERT_FALSE(corners.empty());
    // (1) for every point, a corner of the staircase is at least as good in both objectives
    for (const Vec2& p : points) {
      EXPECT_TRUE(std::any_of(corners.begin(), corners.end(), [&](const Vec2& c) {
        return at_least(c.x(), p.x(), greater[0]) && at_least(c.y(), p.y(), greater[1]);
      }));
    }
    // (2) each step is parallel to an axis, and all steps go in one direction
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Vec2 step = corners[i] - corners[i - 1];
      EXPECT_TRUE((step.x() == 0.0) != (step.y() == 0.0));
      EXPECT_TRUE(at_least(corners[i - 1].x(), corners[i].x(), greater[0]));
      EXPECT_TRUE(at_least(corners[i].y(), corners[i - 1].y(), greater[1]));
    }
    // every second corner is one of the points
    for (std::size_t i = 0; i < corners.size(); i += 2)
      EXPECT_NE(std::find(points.begin(), points.end(), corners[i]), points.end());
  }
  EXPECT_TRUE(staircase({}, {true, true}).empty());
}

TEST(ParetoPicture, OnlyTwoObjectivesHaveAStaircase) {
  const std::vector<DesignDot> dots{
      {{1, 3}, "dot-front", "1"}, {{2, 2}, "dot-front taken", "2"}, {{3, 3}, "dot-design", "3"}};
  const DesignAxis size{{"size", "mm²"}, Better::smaller}, other{{"centre distance", "mm"}};
  const Figure f = designs_figure(size, {{"contact ratio", ""}, Better::greater}, dots);
  EXPECT_EQ(f.x.unit, "mm², smaller values are better");
  EXPECT_EQ(f.y.unit, "greater values are better");
  EXPECT_EQ(f.marks.front().style, "staircase");
  EXPECT_EQ(f.marks.size(), dots.size() + 1);
  EXPECT_EQ(designs_figure(size, other, dots).marks.size(), dots.size());
  EXPECT_EQ(designs_figure(size, other, dots).y.unit, "mm");
}

TEST(ParetoPicture, ADotForEveryDesignWithItsWords) {
  for (const SearchSample& sample : testing::all_searches()) {
    const SearchProblem& problem = sample.search->problem();
    const std::string figure = pareto_figure(problem, *sample.answer);
    if (sample.answer->designs.empty()) {
      EXPECT_EQ(figure, "");
      continue;
    }
    for (const std::string& fault : testing::StrictHtml::read(testing::as_page(figure)).faults)
      ADD_FAILURE() << fault;
    EXPECT_EQ(figure.find("nan"), figure.npos);
    std::size_t middles = 0;
    for (const DesignRow& row : sample.answer->designs) {
      EXPECT_NE(figure.find("<title>" + with_minus(design_name(row.trial)) + ": x1 = "),
                figure.npos);
      if (!row.balanced) ++middles;
    }
    EXPECT_EQ(count_of(figure, "<title>"), sample.answer->designs.size());
    EXPECT_EQ(count_of(figure, "class=\"dot-front\""), sample.answer->pareto.size());
    EXPECT_EQ(count_of(figure, "class=\"dot-middle\""), middles);
    EXPECT_EQ(figure.find("class=\"staircase\"") != figure.npos, sample.answer->pareto.size() > 1);
  }
}

TEST(ParetoPicture, AxesSayWhatTheyAre) {
  const auto has = [](const SearchSample& sample, const char* words) {
    return pareto_figure(sample.search->problem(), *sample.answer).find(words) != std::string::npos;
  };
  EXPECT_TRUE(has(testing::spur_search(), "greater values are better"));
  EXPECT_TRUE(has(testing::spur_search(), ", mm</text>"));
  EXPECT_TRUE(has(testing::exact_search(), "Designs by gear ratio and contact ratio"));
  EXPECT_TRUE(has(testing::ring_search(), "mm², smaller values are better"));
  EXPECT_TRUE(
      has(testing::pareto_search(), "Filled dots are the Pareto front over all objectives"));
  // Modules of 1 to 5 mm give sizes from 1 to 30. The axis is therefore logarithmic.
  EXPECT_TRUE(has(testing::pareto_search(), ">1\u202f000</text>"));
}

TEST(ParetoPicture, NoMoreDotsThanAReaderTellsApart) {
  SearchAnswer answer;
  const SearchProblem problem = testing::spur_problem();
  DesignRow row;
  row.balanced = true;
  for (std::size_t i = 0; i < kMaxDots + 50; ++i) {
    row.trial = {static_cast<std::int64_t>(i), 1.0, 12, 24, {}, 0};
    row.center_distance = 50.0 + 0.001 * static_cast<double>(i);
    row.contact_ratio = 1.5 - 1e-4 * static_cast<double>(i);
    answer.designs.push_back(row);
  }
  answer.counts.feasible = static_cast<std::int64_t>(answer.designs.size());
  const std::string figure = pareto_figure(problem, answer);
  EXPECT_EQ(count_of(figure, "class=\"dot-design\""), kMaxDots);
  EXPECT_NE(figure.find("The picture shows 2\u202f000 of 2\u202f050"), figure.npos);
}

}  // namespace
}  // namespace gearwright
