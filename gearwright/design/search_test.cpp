// The three complete searches of the reference, and laws: (1) a search may be divided at any trial;
// (2) the search for coprime designs gives the designs without common factors; (3) exists() is true
// if and only if range() finds a design. search_rank_test.cpp tests the ranks.
#include "gearwright/design/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/design/testing/found_designs.hpp"
#include "gearwright/design/testing/search_reference.hpp"

namespace gearwright {
namespace {

using nlohmann::json;
using testing::search::Design;
using testing::search::design_of;
using testing::search::Found;
using testing::search::number;
using testing::search::problem_of_search;
using testing::search::reference;
using testing::search::whole;

// The type must not be an aggregate. Otherwise C++20 would accept an initialisation of only some
// members and set the others to 0.
static_assert(!std::is_constructible_v<SearchAnswer, SearchCounts>);

// Rounding error of the doubles in the source. Areas are about 1 modules².
constexpr double kPrintedDouble = 1e-11;

const json& bests() {
  static const json file =
      json::parse(std::ifstream(testing::source_file("tests/oracle/spur_search_bests.json")));
  return file;
}

// All numbers of a row that a file may contain, to the last bit.
std::vector<double> bits_of(const DesignRow& r) {
  std::vector<double> v{static_cast<double>(r.trial.index),
                        r.shift[0],
                        r.shift[1],
                        r.balanced ? 1.0 : 0.0,
                        r.center_distance,
                        r.working_angle.rad(),
                        r.contact_ratio,
                        r.contact_ratio_true,
                        r.overlap_ratio,
                        r.backlash_normal,
                        r.area,
                        r.sums[0],
                        r.sums[1],
                        r.lo[0],
                        r.lo[1],
                        r.hi[0],
                        r.hi[1],
                        r.tip_alteration};
  for (const std::size_t i : {0, 1}) {
    v.push_back(r.tip_thickness[i]);
    v.push_back(r.tip_clearance[i]);
    for (const auto& zeta : r.sliding[i]) v.push_back(zeta.value_or(-1e300));
  }
  return v;
}

TEST(Search, CompleteSearchesOfTheReference) {
  int searches = 0;
  for (const json& expected : reference().at("searches")) {
    const Search search(problem_of_search(expected.at("input")));
    const Found f = whole(search);
    EXPECT_EQ(f.counts.tested, expected.at("tested"));
    EXPECT_EQ(f.counts.feasible, expected.at("feasible_count"));
    std::array<std::int64_t, kLimits> rejected{};
    for (const auto& [name, count] : expected.at("rejected").items()) {
      const Limit limit = name == "centre distance" ? Limit::center_distance : Limit::contact_ratio;
      rejected[static_cast<std::size_t>(limit)] = count;
    }
    EXPECT_EQ(f.counts.rejected, rejected);
    std::vector<Design> designs;
    for (const DesignRow& row : f.rows) designs.push_back(design_of(row));
    std::vector<Design> of_reference;
    for (const json& d : expected.at("feasible")) of_reference.emplace_back(d[0], d[1], d[2]);
    EXPECT_EQ(designs, of_reference);
    const auto balanced = std::count_if(f.rows.begin(), f.rows.end(),
                                        [](const DesignRow& row) { return row.balanced; });
    const json& more = bests().at("searches")[static_cast<std::size_t>(searches)];
    EXPECT_EQ(balanced, more.at("eq11_point_feasible_count"));
    ++searches;
  }
  EXPECT_EQ(searches, 3);
}

TEST(Search, RegionsOfTheReference) {
  int regions = 0;
  for (const json& expected : reference().at("searches")) {
    const Found f = whole(Search(problem_of_search(expected.at("input"))));
    for (const json& d : expected.at("some_regions")) {
      const Design design{number(d.at("m")), d.at("z1"), d.at("z2")};
      const auto row = std::find_if(f.rows.begin(), f.rows.end(),
                                    [&](const DesignRow& r) { return design_of(r) == design; });
      ASSERT_NE(row, f.rows.end()) << d.dump();
      EXPECT_NEAR(row->area, number(d.at("area")), kPrintedDouble) << d.dump();
      EXPECT_NEAR(row->sums[0], number(d.at("S_lo")), kPrintedDouble) << d.dump();
      EXPECT_NEAR(row->sums[1], number(d.at("S_hi")), kPrintedDouble) << d.dump();
      ++regions;
    }
  }
  EXPECT_GT(regions, 30);
}

// The five best designs for each objective. The reference orders designs of equal cost differently.
// The costs are therefore compared, and each of the five designs must be found with all its
// numbers.
TEST(Search, BestFiveOfTheReference) {
  const std::map<std::string, Objective> objectives{
      {"contact_ratio", Objective::formula_contact_ratio},
      {"ratio", Objective::ratio},
      {"size", Objective::size},
      {"area", Objective::area},
      {"shift", Objective::shift}};
  int compared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    SearchProblem p = problem_of_search(reference().at("searches")[i].at("input"));
    const Found f = whole(Search(p));
    for (const auto& [name, expected] : bests().at("searches")[i].at("best").items()) {
      p.objectives = {objectives.at(name)};
      BestDesigns best(p, 5);
      for (const DesignRow& row : f.rows) best.add(row);
      const SearchAnswer answer = std::move(best).answer(f.counts);
      ASSERT_EQ(answer.designs.size(), 5u);
      EXPECT_TRUE(answer.cut);
      EXPECT_TRUE(answer.pareto.empty());
      for (std::size_t k = 0; k < 5; ++k) {
        const json& e = expected[k];
        const auto row = std::find_if(f.rows.begin(), f.rows.end(), [&](const DesignRow& r) {
          return design_of(r) == Design{number(e.at("m")), e.at("z1"), e.at("z2")};
        });
        ASSERT_NE(row, f.rows.end());
        EXPECT_NEAR(row->shift[0], number(e.at("s1")), kPrintedDouble) << e.dump();
        EXPECT_NEAR(row->shift[1], number(e.at("s2")), kPrintedDouble) << e.dump();
        EXPECT_NEAR(row->contact_ratio, number(e.at("eps")), kPrintedDouble) << e.dump();
        EXPECT_NEAR(row->center_distance, number(e.at("C")), kPrintedDouble) << e.dump();
        EXPECT_NEAR(row->area, number(e.at("area")), kPrintedDouble) << e.dump();
        const auto worth = cost(p, *row, p.objectives[0]);
        const auto ours = cost(p, answer.designs[k], p.objectives[0]);
        ASSERT_TRUE(worth && ours);
        EXPECT_NEAR(*ours, *worth, 1e-11 * (1.0 + std::abs(*worth))) << name << " " << k;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 75);
}

TEST(Search, CutAnywhereItIsTheSame) {  // (1)
  std::vector<SearchProblem> problems{problem_of_search(reference().at("searches")[0].at("input")),
                                      testing::search::helical_search()};
  problems[1].coprime = true;
  for (const SearchProblem& p : problems) {
    const Search search(p);
    const std::int64_t size = *search.space().size();
    const Found all = whole(search);
    ASSERT_FALSE(all.rows.empty());
    for (const std::int64_t pieces : {2, 7, 1000}) {
      Found parts;
      for (std::int64_t i = 0; i < pieces; ++i) {
        // A new search for the same problem has no stored data from the preceding piece.
        const Search fresh(p);
        parts.counts += fresh.range(size * i / pieces, size * (i + 1) / pieces, parts.rows);
      }
      EXPECT_EQ(parts.counts, all.counts) << pieces;
      ASSERT_EQ(parts.rows.size(), all.rows.size()) << pieces;
      for (std::size_t i = 0; i < all.rows.size(); ++i)
        EXPECT_EQ(bits_of(parts.rows[i]), bits_of(all.rows[i])) << pieces << " " << i;
    }
  }
}

TEST(Search, CountsAreWhole) {
  for (const SearchProblem& p : {problem_of_search(reference().at("searches")[1].at("input")),
                                 testing::search::helical_search()}) {
    const Found f = whole(Search(p));
    EXPECT_EQ(f.counts.feasible, static_cast<std::int64_t>(f.rows.size()));
    EXPECT_EQ(f.counts.tested, std::accumulate(f.counts.rejected.begin(), f.counts.rejected.end(),
                                               f.counts.feasible));
    EXPECT_TRUE(std::is_sorted(f.rows.begin(), f.rows.end(), [](const auto& a, const auto& b) {
      return a.trial.index < b.trial.index;
    }));
  }
}

// Different racks follow each other at the same helix angle. The filter must process them
// separately.
TEST(Search, EveryTrialHasItsOwnVerdict) {
  SearchProblem p = testing::search::helical_search();
  p.helix = {Angle::radians(0.2)};
  p.mounting = Mounting::extended;
  p.limits.sliding.reset();
  p.limits.contact_ratio = 1.55;
  for (const double addendum : {1.1, 0.8}) {
    p.racks[1].rack[0].addendum = p.racks[1].rack[1].addendum = addendum;
    const Search search(p);
    const Found f = whole(search);
    std::array<std::int64_t, kLimits> rejected{};
    search.space().each(0, *search.space().size(), [&](const Trial& t) {
      const auto limit = search.graph(t).what_kills();
      if (limit) ++rejected[static_cast<std::size_t>(*limit)];
      return true;
    });
    EXPECT_EQ(f.counts.rejected, rejected);
    EXPECT_GT(rejected[static_cast<std::size_t>(Limit::contact_ratio)], 5);
    EXPECT_GT(f.counts.feasible, 5);
  }
}

TEST(Search, RowsAreThoseOfTheTrial) {
  const Search search(testing::search::helical_search());
  const Found f = whole(search);
  std::set<int> racks;
  for (const DesignRow& row : f.rows) {
    const Trial t = search.space().trial(row.trial.index);
    EXPECT_EQ(t.z1, row.trial.z1);
    EXPECT_EQ(t.helix, row.trial.helix);
    EXPECT_EQ(t.rack, row.trial.rack);
    racks.insert(t.rack);
    const auto alone = design_row(search.graph(t));
    ASSERT_TRUE(alone);
    EXPECT_EQ(bits_of(*alone), bits_of(row));
  }
  EXPECT_EQ(racks.size(), 2u);
}

TEST(Search, CoprimeIsTheSearchWithoutCommonFactors) {  // (2)
  SearchProblem p = problem_of_search(reference().at("searches")[0].at("input"));
  const Found all = whole(Search(p));
  p.coprime = true;
  const Found coprime = whole(Search(p));
  std::vector<std::vector<double>> kept;
  for (const DesignRow& row : all.rows)
    if (std::gcd(row.trial.z1, row.trial.z2) == 1) kept.push_back(bits_of(row));
  ASSERT_EQ(coprime.rows.size(), kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(bits_of(coprime.rows[i]), kept[i]);
  EXPECT_LT(kept.size(), all.rows.size());
  std::int64_t tested = 0;
  const Search search(p);
  for (std::int64_t i = 0; i < *search.space().size(); ++i) {
    const Trial t = search.space().trial(i);
    if (std::gcd(t.z1, t.z2) == 1) ++tested;
  }
  EXPECT_EQ(coprime.counts.tested, tested);
}

TEST(Search, ExistsIsWhetherRangeFinds) {  // (3)
  for (const json& expected : reference().at("searches")) {
    const Search search(problem_of_search(expected.at("input")));
    const std::int64_t size = *search.space().size();
    EXPECT_TRUE(search.exists(0, size));
    const std::int64_t step = std::max<std::int64_t>(1, size / 60);
    for (std::int64_t from = 0; from < size; from += step) {
      std::vector<DesignRow> rows;
      const std::int64_t to = std::min(from + step, size);
      search.range(from, to, rows);
      EXPECT_EQ(search.exists(from, to), !rows.empty()) << from;
    }
    EXPECT_FALSE(search.exists(0, 0));
  }
}

}  // namespace
}  // namespace gearwright
