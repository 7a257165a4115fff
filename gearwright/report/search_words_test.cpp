#include "gearwright/report/search_table.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/figure/shift_region.hpp"
#include "gearwright/report/testing/sample_search.hpp"

namespace gearwright {
namespace {

TEST(SearchWords, EveryEdgeHasWordsOfItsOwnAndAColour) {
  std::set<std::string_view> words;
  const std::string style(figure_style());
  for (std::size_t i = 0; i < kShiftEdges; ++i) {
    const auto edge = static_cast<ShiftEdge>(i);
    EXPECT_FALSE(words_of(edge).empty());
    words.insert(words_of(edge));
    const std::string name(style_of(edge).substr(0, style_of(edge).find(' ')));
    EXPECT_NE(style.find("." + name + "{stroke:"), style.npos) << name;
  }
  EXPECT_EQ(words.size(), kShiftEdges);
  EXPECT_EQ(words_of(ShiftEdge::s2max), "greatest shift of gear 2");
  EXPECT_EQ(words_of(ShiftEdge::eps_true), "effective contact ratio");
  EXPECT_EQ(words_of(ShiftEdge::mesh), "no working pressure angle");
}

TEST(SearchWords, EveryLimitHasWordsOfItsOwn) {
  std::set<std::string_view> words;
  for (int i = 0; i < kLimits; ++i) words.insert(words_of(static_cast<Limit>(i)));
  EXPECT_EQ(words.size(), static_cast<std::size_t>(kLimits));
  EXPECT_EQ(words_of(Limit::interference), "interference");
}

TEST(SearchWords, FindingsFollowTheVerdict) {
  SearchCounts counts;
  counts.rejected[static_cast<std::size_t>(Limit::interference)] = 5;
  counts.rejected[static_cast<std::size_t>(Limit::verdict)] = 3;
  counts.findings[static_cast<std::size_t>(WarningCode::jam)] = 1;
  counts.findings[static_cast<std::size_t>(WarningCode::no_backlash)] = 2;
  const std::vector<RejectedBy> list = rejected_by(counts);
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].words, "interference");
  EXPECT_EQ(list[1].trials, 3);
  EXPECT_FALSE(list[1].of_verdict);
  EXPECT_EQ(list[2].words, meaning_of(WarningCode::jam).reason);
  EXPECT_EQ(list[3].words, "no_backlash");  // this code has no clause for headlines
  EXPECT_TRUE(list[2].of_verdict && list[3].of_verdict);
  counts.rejected[static_cast<std::size_t>(Limit::verdict)] = 5;
  ASSERT_EQ(rejected_by(counts).size(), 5u);
  EXPECT_EQ(rejected_by(counts)[4].trials, 2);  // drawings that cannot be made
}

// The value of an objective has the sign of its quantity. A lower cost is always better. Designs
// without a rank have values, too.
TEST(SearchWords, ValuesAreCostsWithTheirNaturalSign) {
  const SearchProblem problem = testing::spur_problem();
  DesignRow row;
  row.trial = {0, 2.5, 20, 41, {}, 0};
  row.ratio = 2.05;
  row.contact_ratio = 1.5;
  row.contact_ratio_true = row.contact_ratio;
  row.area = 0.25;
  row.shift = {0.2, -0.5};
  EXPECT_FALSE(cost(problem, row, Objective::contact_ratio));
  EXPECT_EQ(value_of(problem, row, Objective::contact_ratio), 1.5);
  EXPECT_EQ(value_of(problem, row, Objective::area), 0.25);
  EXPECT_NEAR(*value_of(problem, row, Objective::ratio), 0.05, 1e-12);
  EXPECT_EQ(value_of(problem, row, Objective::size), 2.5 * 2.5 * (20 * 20 + 41 * 41));
  EXPECT_NEAR(*value_of(problem, row, Objective::shift), 0.3, 1e-15);
  EXPECT_FALSE(value_of(problem, row, Objective::sliding));  // the problem sets no limit for ζ
}

TEST(SearchWords, NamesAndCounts) {
  EXPECT_EQ(design_name({0, 2.5, 28, 54, {}, 0}), "2.5 · 28:54");
  EXPECT_EQ(design_name({0, 1, 18, -60, {}, 0}), "1 · 18:-60");
  const Angle beta = Angle::degrees(8);
  EXPECT_EQ(design_name({0, 1, 18, 60, {beta, -beta}, 0}), "1 · 18:60 · 8°");
  EXPECT_EQ(counted(0), "0");
  EXPECT_EQ(counted(999), "999");
  EXPECT_EQ(counted(2754), "2\u202f754");
  EXPECT_EQ(counted(1234567), "1\u202f234\u202f567");
  EXPECT_EQ(counted(-123), "-123");
}

}  // namespace
}  // namespace gearwright
