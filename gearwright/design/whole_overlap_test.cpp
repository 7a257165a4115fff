// Helix angles for whole overlap ratios. Oracles: (1) the list of all multiples of 0.01°; (2) one
// search for every module, helix angle and face width. Law (3): the parts of a divided search are
// the parts of the whole search. Law (4): see below.
#include "gearwright/design/whole_overlap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <vector>

#include "gearwright/base/testing/draw.hpp"
#include "gearwright/design/testing/found_designs.hpp"

namespace gearwright {
namespace {

using testing::search::Found;
using testing::search::whole;

double overlap_at(int hundredths, double module, double width) {
  return width * std::sin(hundredths * std::numbers::pi / 18'000) / (std::numbers::pi * module);
}

// The first multiple of 0.01° with at least this overlap ratio; 9000 if there is none.
int first_angle(double ratio, double module, double width) {
  int hundredths = 1;
  while (hundredths < 9000 && overlap_at(hundredths, module, width) < ratio) ++hundredths;
  return hundredths;
}

// Multiples of 1 mm between 20 mm and 31 mm and between 8 m_n and 14 m_n.
SearchProblem sized_problem() {
  SearchProblem p;
  p.ratio = {1.8, 2.4};
  p.modules = {1.5, 2.0, 3.0};
  p.pinion_teeth = {16, 22};
  p.face_width = {{20.0, 31.0}};
  p.face_modules = {{8.0, 14.0}};
  p.limits.min_shift = -0.5;
  p.limits.max_shift = 1.0;
  return p;
}

SearchProblem overlapping(const std::vector<double>& ratios, const std::array<double, 2>& band) {
  SearchProblem p = sized_problem();
  p.choices = whole_overlap_choices(p, ratios, band);
  return p;
}

TEST(WholeOverlap, AnglesAreTheFirstHundredths) {  // (1)
  testing::Draw draw(1);
  for (int i = 0; i < 2000; ++i) {
    const double module = draw.uniform(0.5, 10.0);
    const double width = module * draw.uniform(1.0, 40.0);
    const double ratio = draw.whole(1, 4);
    const int first = first_angle(ratio, module, width);
    const auto beta = overlap_helix_deg(ratio, module, width);
    if (first == 9000) {
      EXPECT_TRUE(!beta || *beta == 90.0) << ratio << " " << module << " " << width;
      continue;
    }
    ASSERT_TRUE(beta) << ratio << " " << module << " " << width;
    EXPECT_EQ(std::lround(*beta * 100.0), first) << ratio << " " << module << " " << width;
    if (first < 500) continue;
    EXPECT_LT(overlap_at(first, module, width), 1.002 * ratio);
  }
}

TEST(WholeOverlap, ChoicesAreThoseOfTheList) {  // (1)
  for (const std::array<double, 2>& band :
       {std::array{8.0, 20.0}, std::array{-15.0, 12.5}, std::array{-89.0, 89.0}}) {
    std::set<std::tuple<long, double, double>> expected;
    for (const double module : {1.5, 2.0, 3.0})
      for (int width = 20; width <= 31; ++width)
        for (const double ratio : {1.0, 2.0}) {
          if (width < 8 * module || width > 14 * module) continue;
          const int first = first_angle(ratio, module, width);
          for (const int side : {-1, 1})
            if (first < 9000 && side * first >= 100 * band[0] && side * first <= 100 * band[1])
              expected.insert({side * first, module, width});
        }
    const SearchProblem p = overlapping({1.0, 2.0}, band);
    std::set<std::tuple<long, double, double>> found;
    for (const HelixChoice& c : p.choices)
      found.insert({std::lround(100.0 * c.helix.deg()), c.module, *c.face_width});
    EXPECT_EQ(found, expected);
    EXPECT_EQ(p.choices.size(), expected.size());
    EXPECT_GE(expected.size(), 6u);
  }
}

TEST(WholeOverlap, DesignsAreThoseOfOneSearchForEachChoice) {  // (2)
  const SearchProblem p = overlapping({1.0, 2.0}, {8.0, 25.0});
  const Found all = whole(Search(p));
  Found single;
  for (const HelixChoice& c : p.choices) {
    SearchProblem one = sized_problem();
    one.modules = {c.module};
    one.helix = {c.helix};
    one.face_width = {{*c.face_width, *c.face_width}};
    one.face_modules.reset();
    const Found f = whole(Search(one));
    single.counts += f.counts;
    single.rows.insert(single.rows.end(), f.rows.begin(), f.rows.end());
  }
  EXPECT_EQ(all.counts, single.counts);
  EXPECT_GT(all.counts.feasible, 1000);
  ASSERT_EQ(all.rows.size(), single.rows.size());
  for (std::size_t i = 0; i < all.rows.size(); ++i) {
    const DesignRow &a = all.rows[i], &b = single.rows[i];
    EXPECT_EQ(std::tie(a.trial.module, a.trial.z1, a.trial.z2, a.trial.helix, a.shift, a.face_width,
                       a.overlap_ratio),
              std::tie(b.trial.module, b.trial.z1, b.trial.z2, b.trial.helix, b.shift, b.face_width,
                       b.overlap_ratio));
    const double whole_number = std::round(a.overlap_ratio);
    EXPECT_GE(a.overlap_ratio, whole_number * (1 - 1e-12));
    EXPECT_LT(a.overlap_ratio, 1.002 * whole_number);
  }
}

TEST(WholeOverlap, PartsOfTheSearchAreTheSearch) {  // (3)
  SearchProblem p = overlapping({1.0}, {-25.0, 25.0});
  p.racks = {SearchRacks{}, SearchRacks{}};
  const Search search(p);
  const Found all = whole(search);
  const std::int64_t size = *search.space().size();
  for (std::int64_t i = 0; i < size; i += 7) EXPECT_EQ(search.space().trial(i).index, i);
  for (const std::int64_t pieces : {2, 9}) {
    Found parts;
    for (std::int64_t i = 0; i < pieces; ++i)
      parts.counts += search.range(size * i / pieces, size * (i + 1) / pieces, parts.rows);
    EXPECT_EQ(parts.counts, all.counts);
    ASSERT_EQ(parts.rows.size(), all.rows.size());
    for (std::size_t i = 0; i < parts.rows.size(); ++i) {
      EXPECT_EQ(parts.rows[i].trial.index, all.rows[i].trial.index);
      EXPECT_EQ(parts.rows[i].trial.face_width, all.rows[i].trial.face_width);
      EXPECT_EQ(parts.rows[i].shift, all.rows[i].shift);
    }
  }
}

// Law (4): for a band of b/d_1, the trials are the choices whose widths are in the band of their
// pinion.
TEST(WholeOverlap, WidthsInABandOfDiameters) {  // (4)
  SearchProblem p = sized_problem();
  p.face_width.reset();
  p.face_modules.reset();
  p.face_diameters = {{0.2, 1.0}};
  p.choices = whole_overlap_choices(p, {1.0}, {8.0, 25.0});
  const auto fits = [](const HelixChoice& c, int z1) {
    const double share = *c.face_width / (c.module * z1 / std::cos(c.helix.rad()));
    return 0.2 <= share && share <= 1.0;
  };
  std::int64_t expected = 0, omitted = 0;
  for (const HelixChoice& c : p.choices)
    for (int z1 = 16; z1 <= 22; ++z1)
      for (int z2 = z1; z2 <= 60; ++z2)
        if (1.8 * z1 - 1e-9 <= z2 && z2 <= 2.4 * z1 + 1e-9) ++(fits(c, z1) ? expected : omitted);
  const Found found = whole(Search(p));
  EXPECT_EQ(found.counts.tested, expected);
  EXPECT_GT(found.counts.feasible, 100);
  EXPECT_GT(omitted, 0);
  for (const DesignRow& row : found.rows)
    EXPECT_TRUE(fits({row.trial.module, row.trial.helix[0], row.face_width}, row.trial.z1));
}

}  // namespace
}  // namespace gearwright
