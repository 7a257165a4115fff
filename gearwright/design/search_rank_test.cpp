// The ranks of designs. Laws: (1) a short list of the best designs is the head of the full list;
// (2) designs with equal costs are sorted by module and teeth; (3) the front contains exactly the
// designs that no other design dominates, in whatever order they are added.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "gearwright/design/search.hpp"
#include "gearwright/design/testing/found_designs.hpp"
#include "gearwright/design/testing/search_reference.hpp"

namespace gearwright {
namespace {

using testing::search::Design;
using testing::search::design_of;
using testing::search::Found;
using testing::search::helical_search;
using testing::search::problem_of_search;
using testing::search::Random;
using testing::search::reference;
using testing::search::whole;

TEST(SearchRank, TheFewBestAreTheHeadOfTheList) {  // (1)
  SearchProblem p = helical_search();
  const Found f = whole(Search(p));
  for (const Objective objective : {Objective::contact_ratio, Objective::ratio, Objective::size,
                                    Objective::shift, Objective::area, Objective::sliding}) {
    p.objectives = {objective};
    std::vector<DesignRow> sorted = f.rows;
    std::sort(sorted.begin(), sorted.end(), [&](const DesignRow& a, const DesignRow& b) {
      return ranks_before(p, objective, a, b);
    });
    for (std::size_t i = 1; i < sorted.size(); ++i) {
      const auto before = cost(p, sorted[i - 1], objective);
      const auto after = cost(p, sorted[i], objective);
      EXPECT_TRUE(!after || (before && *before <= *after + 1e-11));
    }
    for (const std::size_t most :
         {std::size_t{0}, std::size_t{1}, std::size_t{10}, sorted.size()}) {
      BestDesigns best(p, most);
      for (auto row = f.rows.rbegin(); row != f.rows.rend(); ++row) best.add(*row);
      const SearchAnswer answer = std::move(best).answer(f.counts);
      ASSERT_EQ(answer.designs.size(), most);
      EXPECT_EQ(answer.cut, most < sorted.size());
      for (std::size_t i = 0; i < most; ++i)
        EXPECT_EQ(answer.designs[i].trial.index, sorted[i].trial.index);
    }
  }
}

// The same pair in another module has the same cost except for rounding, so its rank depends on
// module, z1 and z2.
TEST(SearchRank, EqualWorthsComeInOrder) {  // (2)
  SearchProblem p = problem_of_search(reference().at("searches")[2].at("input"));
  const Found f = whole(Search(p));
  int ties = 0;
  for (const Objective objective :
       {Objective::contact_ratio, Objective::ratio, Objective::area, Objective::shift}) {
    for (const DesignRow& a : f.rows) {
      for (const DesignRow& b : f.rows) {
        if (a.trial.index == b.trial.index) continue;
        const auto same = [](double v, double w) { return std::abs(v - w) < 1e-12; };
        if (!same(*cost(p, a, objective), *cost(p, b, objective)) ||
            !same(a.contact_ratio, b.contact_ratio))
          continue;
        ++ties;
        EXPECT_EQ(ranks_before(p, objective, a, b), design_of(a) < design_of(b));
      }
    }
  }
  EXPECT_GT(ties, 100);
}

// The definition of the front, evaluated directly for all pairs of designs.
TEST(SearchRank, TheFrontIsWhatNoneDominates) {  // (3)
  SearchProblem p = helical_search();
  p.objectives = {Objective::size, Objective::contact_ratio, Objective::sliding};
  Found f = whole(Search(p));
  ASSERT_GT(f.rows.size(), 50u);
  std::set<std::int64_t> front;
  const auto costs = [&](const DesignRow& row) {
    std::vector<double> c;
    for (const Objective o : p.objectives)
      if (const auto v = cost(p, row, o)) c.push_back(*v);
    return c;
  };
  for (const DesignRow& row : f.rows) {
    const auto mine = costs(row);
    if (mine.size() < 3) continue;
    const bool beaten = std::any_of(f.rows.begin(), f.rows.end(), [&](const DesignRow& other) {
      const auto its = costs(other);
      if (its.size() < 3) return false;
      bool better = false;
      for (std::size_t i = 0; i < 3; ++i) {
        if (its[i] > mine[i] + 1e-10) return false;
        better = better || its[i] < mine[i] - 1e-10;
      }
      return better;
    });
    if (!beaten) front.insert(row.trial.index);
  }
  ASSERT_GT(front.size(), 2u);
  ASSERT_LT(front.size(), f.rows.size() / 2);
  Random random(41);
  for (int repeat = 0; repeat < 5; ++repeat) {
    for (std::size_t i = f.rows.size(); i > 1; --i)
      std::swap(f.rows[i - 1],
                f.rows[static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1))]);
    BestDesigns best(p, f.rows.size());
    for (const DesignRow& row : f.rows) best.add(row);
    const SearchAnswer answer = std::move(best).answer(f.counts);
    EXPECT_EQ(answer.designs.size(), f.rows.size());
    std::set<std::int64_t> ours;
    for (const std::size_t i : answer.pareto) ours.insert(answer.designs[i].trial.index);
    EXPECT_EQ(ours, front);
    std::set<std::int64_t> all;
    for (const DesignRow& row : answer.designs) all.insert(row.trial.index);
    EXPECT_EQ(all.size(), f.rows.size());  // each design occurs once
  }
}

}  // namespace
}  // namespace gearwright
