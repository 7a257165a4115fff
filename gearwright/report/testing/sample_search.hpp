// Small searches with their answers, for the tests of report/.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/report/search_report.hpp"
#include "gearwright/report/testing/page_text.hpp"

namespace gearwright::testing {

/// A search and its answer, with a report that points to both.
struct SearchSample {
  std::shared_ptr<const Search> search;
  std::shared_ptr<const SearchAnswer> answer;
  SearchReport report(std::size_t rows = 200) const {
    return {"Sample", "[search]\nratio = [1.9, 2.1]\n", *search, *answer, {}, rows};
  }
};

inline SearchSample search_sample(const SearchProblem& problem, std::size_t most = 1000) {
  SearchSample sample;
  sample.search = std::make_shared<const Search>(problem);
  std::vector<DesignRow> rows;
  const SearchCounts counts = sample.search->range(0, *sample.search->space().size(), rows);
  BestDesigns best(sample.search->problem(), most);
  for (const DesignRow& row : rows) best.add(row);
  sample.answer = std::make_shared<const SearchAnswer>(std::move(best).answer(counts));
  return sample;
}

/// Returns a search with the target ratio 2, centre distances of 99 to 101 mm and shifts of −0.6
/// to 1. It has 2754 trials and 56 designs.
inline SearchProblem spur_problem() {
  SearchProblem p;
  p.ratio = {1.9, 2.1};
  p.target_ratio = 2.0;
  p.center_distance = {{99.0, 101.0}};
  p.modules = {1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 40, 50};
  p.pinion_teeth = {12, 40};
  p.mounting = Mounting::extended;
  p.limits.min_shift = -0.6;
  p.limits.max_shift = 1.0;
  return p;
}
inline SearchSample spur_search() { return search_sample(spur_problem()); }

inline SearchSample exact_search() {
  SearchProblem p = spur_problem();
  p.center_distance = {{100.0, 100.0}};
  return search_sample(p);
}

/// Returns a search with three objectives, a narrow range of centre distances, and every limit.
inline SearchSample pareto_search() {
  SearchProblem p = spur_problem();
  p.center_distance.reset();
  p.modules = {1, 2, 5};
  p.pinion_teeth = {12, 20};
  p.mounting = Mounting::tight;
  p.limits.avoid_interference = true;
  p.limits.sliding = 2.5;
  p.limits.tip_clearance = 0.2;
  p.objectives = {Objective::size, Objective::contact_ratio, Objective::area};
  return search_sample(p);
}

inline SearchSample helical_search() {
  SearchProblem p = spur_problem();
  p.helix = {Angle::radians(0.2), Angle::radians(0.35)};
  p.limits.overlap_ratio = 1.0;
  p.coprime = true;
  p.objectives = {Objective::ratio};
  return search_sample(p);
}

inline SearchSample ring_search() {
  SearchProblem p = spur_problem();
  p.ratio = {-4.0, -2.5};
  p.target_ratio = -3.0;
  p.center_distance = {{40.0, 60.0}};
  p.modules = {1.5, 2};
  p.pinion_teeth = {17, 24};
  p.objectives = {Objective::size, Objective::contact_ratio};
  return search_sample(p);
}

inline SearchSample crossed_search() {
  SearchProblem p = spur_problem();
  p.shaft_angle = Angle::degrees(90);
  p.helix = {Angle::degrees(45)};
  p.center_distance.reset();
  p.modules = {2};
  p.pinion_teeth = {12, 16};
  return search_sample(p);
}

inline SearchSample empty_search() {
  SearchProblem p = spur_problem();
  p.center_distance = {{3.0, 3.2}};
  return search_sample(p);
}

inline std::vector<SearchSample> all_searches() {
  return {spur_search(), exact_search(),   pareto_search(), helical_search(),
          ring_search(), crossed_search(), empty_search()};
}

}  // namespace gearwright::testing
