#include "gearwright/report/search_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/figure/shift_region.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/search_table.hpp"
#include "gearwright/report/testing/page_text.hpp"
#include "gearwright/report/testing/sample_search.hpp"
#include "gearwright/report/testing/strict_html.hpp"

namespace gearwright {
namespace {

using testing::count_of;
using testing::expect_sound_figure;
using testing::SearchSample;

std::string figure_of(const SearchSample& sample, const DesignRow& row) {
  return shift_region_figure(sample.search->graph(row.trial), row);
}

SearchSample one_pair(int z1, int z2, double least, double greatest) {
  SearchProblem p = testing::spur_problem();
  p.ratio = {static_cast<double>(z2) / z1, static_cast<double>(z2) / z1};
  p.pinion_teeth = {z1, z1};
  p.modules = {1};
  p.limits.min_shift = -0.5;
  p.center_distance = {{least, greatest}};
  return testing::search_sample(p);
}

TEST(ShiftRegionPicture, EveryEdgeOfTheRegionIsNamedInTheKey) {
  int edges = 0;
  for (const SearchSample& sample : testing::all_searches()) {
    for (const DesignRow& row : sample.answer->designs) {
      const ShiftGraph graph = sample.search->graph(row.trial);
      const std::string figure = shift_region_figure(graph, row);
      expect_sound_figure(figure, "design-");
      const bool exact = sample.search->problem().center_distance &&
                         (*sample.search->problem().center_distance)[0] ==
                             (*sample.search->problem().center_distance)[1];
      for (const auto& loop : region_boundary(graph, *shift_region(graph))) {
        for (const RegionEdge& e : loop) {
          const bool distance = e.edge == ShiftEdge::Cmin || e.edge == ShiftEdge::Cmax;
          const std::string words(exact && distance ? "exact centre distance" : words_of(e.edge));
          EXPECT_NE(figure.find("</i>" + words + "</span>"), figure.npos)
              << design_name(row.trial) << " " << words;
          ++edges;
        }
      }
    }
  }
  EXPECT_GT(edges, 1000);
}

TEST(ShiftRegionPicture, NumbersAreThoseOfTheRegion) {
  const SearchSample sample = testing::spur_search();
  const DesignRow& row = sample.answer->designs.front();
  const std::string figure = figure_of(sample, row);
  EXPECT_NE(figure.find("Where " + design_name(row.trial) + " is feasible"), figure.npos);
  EXPECT_NE(figure.find("an area of " + fixed(row.area, 4)), figure.npos);
  const auto at = [](double x1, double x2) {
    return with_minus("(" + fixed(x1, 4) + ", " + fixed(x2, 4) + ")");
  };
  EXPECT_NE(figure.find("from " + at(row.lo.x(), row.lo.y()) +
                        " at the least sum of the profile shifts to " + at(row.hi.x(), row.hi.y()) +
                        " at the greatest"),
            figure.npos);
  EXPECT_NE(figure.find("The design is at " + at(row.shift[0], row.shift[1])), figure.npos);
  for (const char* name : {">min ", ">max ", ">design<", ">balanced<"})
    EXPECT_EQ(count_of(figure, name), 1u) << name;
  EXPECT_NE(figure.find(" = 101<"), figure.npos);
  EXPECT_EQ(figure, figure_of(sample, row));
}

// Without profile shifts, 2 · 33:67 has the centre distance 100 mm, which is in the middle of the
// permitted range. Both ends of this range therefore bound the region.
TEST(ShiftRegionPicture, WordsStandBesideTheEdgesOfABand) {
  const SearchSample sample = testing::spur_search();
  for (const DesignRow& row : sample.answer->designs) {
    if (design_name(row.trial) != "2 · 33:67") continue;
    const std::string figure = figure_of(sample, row);
    for (const char* words : {"least centre distance", "greatest centre distance",
                              "least shift of gear 1", "least shift of gear 2"})
      EXPECT_EQ(count_of(figure, std::string(">") + words + "<"), 2u)
          << words;  // at the edge and in the legend
    EXPECT_EQ(count_of(figure, "class=\"distance-line\""), 2u);
    return;
  }
  ADD_FAILURE() << "no such design";
}

TEST(ShiftRegionPicture, OneExactDistanceIsALine) {
  const SearchSample sample = testing::exact_search();
  const std::string figure = figure_of(sample, sample.answer->designs.front());
  EXPECT_EQ(count_of(figure, ">exact centre distance<"), 2u);
  EXPECT_EQ(figure.find(">least centre distance<"), figure.npos);
  EXPECT_EQ(figure.find(">greatest centre distance<"), figure.npos);
  EXPECT_EQ(count_of(figure, "class=\"distance-line\""), 1u);
  EXPECT_NE(figure.find("no area"), figure.npos);
}

// The least possible sum of the shifts is −1, which gives the centre distance 59 mm. If 59 mm is
// the greatest permitted centre distance, the region is this single corner.
TEST(ShiftRegionPicture, APointATinyCornerAndAWholeRectangle) {
  const SearchSample point = one_pair(40, 80, 58.0, 59.0);
  ASSERT_EQ(point.answer->designs.size(), 1u);
  const std::string dot = figure_of(point, point.answer->designs.front());
  expect_sound_figure(dot, "design-");
  EXPECT_NE(dot.find("class=\"region-point\" r=\"3\""), dot.npos);

  const SearchSample tiny = one_pair(40, 80, 58.0, 59.0001);
  const DesignRow& corner = tiny.answer->designs.front();
  EXPECT_NEAR(corner.area, 0.5e-8, 1e-12);
  const std::string small = figure_of(tiny, corner);
  expect_sound_figure(small, "design-");
  EXPECT_NE(small.find("class=\"region-map\""), small.npos);

  const SearchSample whole = one_pair(40, 80, 50.0, 70.0);
  const std::string all = figure_of(whole, whole.answer->designs.front());
  expect_sound_figure(all, "design-");
  EXPECT_EQ(all.find("class=\"region-map\""), all.npos);
}

// If designs with interference are excluded, an internal gear with 60 teeth and a pinion with 40
// teeth have two separate regions.
TEST(ShiftRegionPicture, ARegionInTwoPieces) {
  SearchProblem p = testing::spur_problem();
  p.ratio = {-1.5, -1.5};
  p.pinion_teeth = {40, 40};
  p.modules = {1};
  p.center_distance.reset();
  p.limits = {};
  p.limits.contact_ratio = 1.8;
  p.limits.sliding = 1.1;
  p.limits.avoid_interference = true;
  const SearchSample sample = testing::search_sample(p);
  ASSERT_EQ(sample.answer->designs.size(), 1u);
  const DesignRow& row = sample.answer->designs.front();
  ASSERT_EQ(shift_region(sample.search->graph(row.trial))->sums.size(), 2u);
  const std::string figure = figure_of(sample, row);
  expect_sound_figure(figure, "design-");
  EXPECT_EQ(count_of(figure, "<path class=\"region\""), 2u);
}

TEST(ShiftRegionPicture, ThumbnailsHaveNoLabelsAndLeadToTheirRow) {
  for (const SearchSample& sample : testing::all_searches()) {
    for (std::size_t i = 0; i < std::min<std::size_t>(5, sample.answer->designs.size()); ++i) {
      const DesignRow& row = sample.answer->designs[i];
      const std::string figure =
          shift_region_thumbnail(sample.search->graph(row.trial), row, "small", "#design-7");
      expect_sound_figure(figure, "design-");
      EXPECT_EQ(figure.find("<text"), figure.npos);
      EXPECT_NE(figure.find(with_minus("<a href=\"#design-7\">" + design_name(row.trial) + "</a>")),
                figure.npos);
      EXPECT_NE(figure.find("region"), figure.npos);
    }
  }
}

TEST(ShiftRegionPicture, ARingsPinionTakesAllOfTheShift) {
  const SearchSample sample = testing::ring_search();
  const std::string figure = figure_of(sample, sample.answer->designs.front());
  EXPECT_NE(figure.find("the line on which only the pinion has a profile shift"), figure.npos);
  EXPECT_EQ(figure.find(">balanced<"), figure.npos);
}

}  // namespace
}  // namespace gearwright
