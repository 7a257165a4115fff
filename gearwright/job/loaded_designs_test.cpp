// The order of designs by their transmission error under load. tests/search/test_loaded_designs.py
// compares the values with the verb `load`.
#include "gearwright/job/loaded_designs.hpp"

#include <gtest/gtest.h>

namespace gearwright {
namespace {

SearchProblem problem_by_noise(std::vector<Objective> objectives = {Objective::noise}) {
  SearchProblem problem;
  problem.objectives = std::move(objectives);
  problem.loaded_designs = 4;
  return problem;
}

// Six designs, sorted by the estimate. The trial has the index of the design.
SearchAnswer answer_of_six() {
  SearchAnswer answer;
  for (int i = 0; i < 6; ++i) {
    DesignRow row;
    row.trial.index = i;
    row.balanced = true;
    row.noise = 0.1 * i;
    answer.designs.push_back(row);
  }
  return answer;
}

std::vector<LoadedDesign> loaded_with(const std::vector<std::optional<double>>& noises) {
  std::vector<LoadedDesign> loaded;
  for (const auto& noise : noises) {
    Trial trial;
    trial.index = static_cast<std::int64_t>(loaded.size());
    loaded.push_back({trial, noise, noise ? "" : "no value"});
  }
  return loaded;
}

std::vector<std::int64_t> trials_of(const SearchAnswer& answer) {
  std::vector<std::int64_t> trials;
  for (const DesignRow& row : answer.designs) trials.push_back(row.trial.index);
  return trials;
}

using Trials = std::vector<std::int64_t>;

TEST(LoadedDesigns, AreSortedAndDesignsWithoutValueComeAfterThem) {
  SearchAnswer answer = answer_of_six();
  rank_loaded(problem_by_noise(), loaded_with({3.0, {}, 1.0, 2.0}), 100, answer);
  EXPECT_EQ(trials_of(answer), (Trials{2, 3, 0, 1, 4, 5}));
  EXPECT_EQ(answer.designs[0].loaded_noise, 1.0);
  EXPECT_FALSE(answer.designs[3].loaded_noise);
  EXPECT_EQ(answer.loaded[3].reason, "no value");
  EXPECT_FALSE(answer.cut);
}

TEST(LoadedDesigns, ParetoFrontStaysBeforeOtherDesigns) {
  SearchAnswer answer = answer_of_six();
  answer.pareto = {0, 1};
  rank_loaded(problem_by_noise({Objective::noise, Objective::mass}),
              loaded_with({4.0, 3.0, 1.0, 2.0}), 100, answer);
  EXPECT_EQ(trials_of(answer), (Trials{1, 0, 2, 3, 4, 5}));
}

TEST(LoadedDesigns, DesignsWithoutRankStayLast) {
  SearchAnswer answer = answer_of_six();
  for (const std::size_t i : {2, 3, 4, 5}) answer.designs[i].balanced = false;
  rank_loaded(problem_by_noise(), loaded_with({4.0, 3.0, 2.0, 1.0}), 100, answer);
  EXPECT_EQ(trials_of(answer), (Trials{1, 0, 3, 2, 4, 5}));
}

TEST(LoadedDesigns, OtherFirstObjectivesKeepTheirOrder) {
  SearchAnswer answer = answer_of_six();
  rank_loaded(problem_by_noise({Objective::mass, Objective::noise}),
              loaded_with({4.0, 3.0, 2.0, 1.0}), 100, answer);
  EXPECT_EQ(trials_of(answer), (Trials{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(answer.designs[3].loaded_noise, 1.0);
}

// The first designs are the same for every number of listed designs.
TEST(LoadedDesigns, FirstDesignsDoNotDependOnTop) {
  const SearchProblem problem = problem_by_noise();
  for (std::size_t top = 1; top <= 6; ++top) {
    SearchAnswer answer = answer_of_six();
    answer.pareto = {0, 1, 2};
    answer.designs.resize(std::min(designs_to_keep(problem, top), answer.designs.size()));
    ASSERT_EQ(designs_to_load(problem, answer), 4u);
    rank_loaded(problem, loaded_with({4.0, 3.0, 2.0, 1.0}), top, answer);
    const Trials all{2, 1, 0, 3, 4, 5};
    EXPECT_EQ(trials_of(answer), Trials(all.begin(), all.begin() + static_cast<int>(top)));
    EXPECT_EQ(answer.pareto.size(), std::min<std::size_t>(top, 3));
    EXPECT_EQ(answer.loaded.size(), 4u);
    EXPECT_EQ(answer.cut, top < 4);
  }
}

TEST(LoadedDesigns, AreComputedOnlyIfASearchRanksByNoise) {
  const SearchProblem by_mass = problem_by_noise({Objective::mass});
  EXPECT_EQ(designs_to_load(by_mass, answer_of_six()), 0u);
  EXPECT_EQ(designs_to_keep(by_mass, 2), 2u);
  SearchProblem none = problem_by_noise();
  none.loaded_designs = 0;
  EXPECT_EQ(designs_to_load(none, answer_of_six()), 0u);
}

}  // namespace
}  // namespace gearwright
