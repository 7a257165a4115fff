// Compares the engine's search with the plain search. Complete searches must give the same designs,
// and every other trial must be rejected by the same limit.
//
// The plain search supports spur and helical pairs, external and internal, extended and
// backlash-free centre distances, without shortened tips. It distinguishes `shift_limits`,
// `center_distance`, `contact_ratio` and, for all later limits, `other`. If it reports a trial as
// ambiguous (two answers within 1e-9 of each other), either answer is accepted.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/design/search.hpp"
#include "tests/oracle/plain_search.hpp"
#include "tests/oracle/search_twin.hpp"

namespace gearwright::oracle {
namespace {

using nlohmann::json;

std::string words_of(const ShiftGraph& graph) {
  const auto limit = graph.what_kills();
  if (!limit) return "";
  return *limit <= Limit::contact_ratio ? std::string(name(*limit)) : "other";
}

struct Compared {
  int designs = 0, ambiguous = 0;
  std::map<std::string, int> rejected;
};

/// Runs the plain search on every trial of the engine's space, together with the complete search of
/// the engine.
Compared expect_same_search(Twin twin) {
  share_doubles(twin);
  const Search search(engine_problem(twin));
  const SearchSpace& space = search.space();
  std::vector<DesignRow> rows;
  const SearchCounts counts = search.range(0, *space.size(), rows);
  std::set<std::int64_t> feasible;
  for (const DesignRow& row : rows) feasible.insert(row.trial.index);

  Compared compared;
  std::int64_t tested = 0;
  std::array<std::int64_t, kLimits> rejected{};
  space.each(0, *space.size(), [&](const Trial& t) {
    ++tested;
    const PlainAnswer plain = region_not_empty(twin.plain, t.module, t.z1, t.z2,
                                               twin.center_distance[0], twin.center_distance[1]);
    const bool found = feasible.count(t.index) == 1;
    const ShiftGraph graph = search.graph(t);
    const auto limit = graph.what_kills();
    EXPECT_EQ(found, !limit.has_value());
    if (limit) ++rejected[static_cast<std::size_t>(*limit)];
    const std::string what =
        std::to_string(t.module) + " " + std::to_string(t.z1) + ":" + std::to_string(t.z2);
    if (plain.verdict == PlainVerdict::ambiguous) {
      ++compared.ambiguous;
    } else {
      EXPECT_EQ(found, plain.verdict == PlainVerdict::not_empty) << what;
      // For an internal gear, the plain search uses only the shifts that the range of centre
      // distances permits.
      const bool out_of_sight = t.z2 < 0 && plain.killed_by == "shift_limits" &&
                                limit == std::optional(Limit::center_distance);
      if (!out_of_sight) {
        EXPECT_EQ(words_of(graph), plain.killed_by) << what;
      }
      if (found) {
        ++compared.designs;
      } else {
        ++compared.rejected[plain.killed_by];
      }
    }
    return true;
  });
  EXPECT_EQ(counts.tested, tested);
  EXPECT_EQ(counts.rejected, rejected);
  return compared;
}

Twin with_shifts(double floor, double ceil) {
  Twin twin;
  twin.plain.floor = floor;
  twin.plain.ceil = ceil;
  return twin;
}

TEST(SearchEngine, SearchesOfTheSource) {
  const json source =
      json::parse(std::ifstream(testing::source_file("tests/oracle/spur_searches.json")));
  const std::vector<double> series{1, 1.25, 1.5, 2,  2.5, 3,  4,  5,  6,
                                   8, 10,   12,  16, 20,  25, 32, 40, 50};
  for (const json& search : source.at("searches")) {
    const json& in = search.at("input");
    Twin twin;
    const json& limits = in.at("limits");
    if (!limits.at("floor").is_null()) twin.plain.floor = limits.at("floor").get<double>();
    if (!limits.at("ceil").is_null()) twin.plain.ceil = limits.at("ceil").get<double>();
    twin.plain.tip_thickness_min = limits.at("sa_min").get<double>();
    twin.plain.contact_ratio_min = in.at("eps_min").get<double>();
    twin.modules = series;
    twin.ratio = in.at("ratio");
    twin.pinion_teeth = in.at("z1");
    twin.center_distance = in.at("C");
    const Compared c = expect_same_search(twin);
    EXPECT_EQ(c.designs + c.ambiguous, search.at("feasible_count"));
    EXPECT_LE(c.ambiguous, 2);  // bands of centre distances that just touch the corner of the
                                // rectangle of shifts
  }
}

TEST(SearchEngine, Helical) {
  Twin twin = with_shifts(-0.6, 1.0);
  twin.plain.beta = 0.35;
  twin.plain.contact_ratio_min = 1.4;
  twin.modules = {1.5, 1.75, 2.0};
  twin.pinion_teeth = {14, 28};
  const Compared c = expect_same_search(twin);
  EXPECT_GT(c.designs, 15);
  EXPECT_GT(c.rejected.at("contact_ratio"), 0);
  EXPECT_EQ(c.ambiguous, 0);
}

TEST(SearchEngine, Tight) {
  Twin twin = with_shifts(-0.6, 1.0);
  twin.plain.tight = true;
  twin.plain.contact_ratio_min = 1.6;
  twin.modules = {2.0, 2.5};
  twin.pinion_teeth = {12, 28};
  const Compared c = expect_same_search(twin);
  EXPECT_GT(c.designs, 10);
  EXPECT_GT(c.rejected.at("contact_ratio"), 0);
}

TEST(SearchEngine, TightWithSlidingAndClearance) {
  Twin twin = with_shifts(-0.5, 0.9);
  twin.plain.tight = true;
  twin.plain.sliding_max = 2.0;
  twin.plain.clearance_min = 0.2;
  twin.modules = {2.0, 2.5};
  twin.pinion_teeth = {12, 28};
  const Compared c = expect_same_search(twin);
  EXPECT_GT(c.designs, 5);
  EXPECT_GT(c.rejected.at("other"), 2);
}

TEST(SearchEngine, WithoutInterference) {
  Twin twin = with_shifts(-0.6, 0.2);
  twin.plain.avoid_interference = true;
  twin.ratio = {2.0, 4.2};
  twin.modules = {1.5, 2.0};
  twin.pinion_teeth = {14, 22};
  twin.center_distance = {60.0, 60.6};
  const Compared c = expect_same_search(twin);
  EXPECT_GT(c.designs, 5);
  EXPECT_GT(c.rejected.at("other"), 2);
}

TEST(SearchEngine, Rings) {
  Twin twin = with_shifts(-0.6, 0.8);
  twin.ratio = {-3.2, -2.5};
  twin.pinion_teeth = {16, 26};
  twin.center_distance = {35.0, 36.0};
  twin.plain.contact_ratio_min = 1.5;
  const Compared c = expect_same_search(twin);
  EXPECT_GT(c.designs, 10);
  twin.plain.tight = true;
  twin.plain.sliding_max = 2.0;
  twin.plain.avoid_interference = true;
  EXPECT_GT(expect_same_search(twin).designs, 5);
}

void expect_same_random_searches(unsigned seed, int searches) {
  TwinRandom random(seed);
  Compared all;
  for (int i = 0; i < searches; ++i) {
    const Compared c = expect_same_search(
        random_twin(random, kTwinKinds[static_cast<std::size_t>(i) % kTwinKinds.size()]));
    all.designs += c.designs;
    all.ambiguous += c.ambiguous;
    for (const auto& [limit, count] : c.rejected) all.rejected[limit] += count;
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "search " << i;
      return;
    }
  }
  EXPECT_GT(all.designs, searches);
  for (const char* limit : {"center_distance", "contact_ratio", "other"})
    EXPECT_GT(all.rejected[limit], searches / 4) << limit;
  EXPECT_LT(all.ambiguous, searches / 10 + 1);
}

TEST(SearchEngine, SmallRandomSearches) { expect_same_random_searches(51, 60); }
TEST(SearchEngine, LongManyRandomSearches) { expect_same_random_searches(52, 3000); }

}  // namespace
}  // namespace gearwright::oracle
