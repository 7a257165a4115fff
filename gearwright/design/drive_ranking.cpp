// The objectives by which a search ranks drives, and their Pareto front.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "gearwright/design/drive_search.hpp"

namespace gearwright {

double cost_of(const DriveSearchProblem& problem, const DriveCandidate& candidate,
               DriveObjective objective) {
  switch (objective) {
    case DriveObjective::efficiency: return -candidate.efficiency;
    case DriveObjective::ratio: return std::abs(candidate.ratio - problem.target());
    case DriveObjective::size: return candidate.size;
    case DriveObjective::efficiency_backward: return -candidate.efficiency_backward;
    case DriveObjective::clearance: return -candidate.clearance;
    case DriveObjective::planets: return -candidate.planets;
    case DriveObjective::noise: return candidate.noise.value_or(kInfinity);
  }
  return 0.0;
}

std::vector<std::size_t> pareto_front(const DriveSearchProblem& problem,
                                      const std::vector<DriveCandidate>& candidates) {
  if (problem.objectives.size() < 2) return {};
  std::vector<std::vector<double>> costs;
  for (const DriveCandidate& c : candidates) {
    costs.emplace_back();
    for (const DriveObjective o : problem.objectives)
      costs.back().push_back(cost_of(problem, c, o));
  }
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  // The candidates are sorted by their costs, so a candidate can be dominated only by an earlier
  // one.
  std::vector<std::size_t> front;
  const auto beats = [&](const std::vector<double>& a, const std::vector<double>& b) {
    return a != b && std::equal(a.begin(), a.end(), b.begin(), std::less_equal<>());
  };
  for (const std::size_t i : order)
    if (std::none_of(front.begin(), front.end(),
                     [&](std::size_t f) { return beats(costs[f], costs[i]); }))
      front.push_back(i);
  std::sort(front.begin(), front.end());
  return front;
}

}  // namespace gearwright
