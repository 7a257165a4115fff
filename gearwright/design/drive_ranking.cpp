// The objectives by which a search ranks drives, and their Pareto front.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "gearwright/design/design_strength.hpp"
#include "gearwright/design/drive_space.hpp"

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
    case DriveObjective::mass: return candidate.mass.value_or(kInfinity);
  }
  return 0.0;
}

std::optional<double> estimated_mass(const DriveSearchProblem& problem,
                                     const DriveCandidate& candidate) {
  if (!problem.asks(DriveObjective::mass) || problem.modules.empty()) return std::nullopt;
  const PerMember& helix = problem.base.helix_deg;
  const double transverse =
      1.0 / std::cos(Angle::degrees(helix.each[0].value_or(helix.all.value_or(0.0))).rad());
  const auto mass = [&](int teeth, double module, double width, double density) {
    const double sigma = side_of(teeth), d = module * std::abs(teeth) * transverse;
    return GearBody{density, width, teeth, d + 2 * sigma * module, d - 2.5 * sigma * module, module}
        .mass();
  };
  const auto& given = problem.base.face_width;
  const DriveCandidate sized =
      candidate.face_widths.empty() ? widest(problem, candidate) : candidate;
  double sum = 0.0;
  for (std::size_t k = 0; k < sized.stages.size(); ++k) {
    const double module = sized.stage_module(k);
    const double width = sized.face_widths.empty() ? given.all.value_or(kFaceModules * module)
                                                   : sized.face_widths[k];
    for (const int teeth : sized.stages[k]) sum += mass(teeth, module, width, problem.density[0]);
  }
  const PerMember widths = member_face_widths(sized);
  for (std::size_t m = 0; m < kSetMembers; ++m) {
    if (sized.teeth[m] == 0) continue;
    const auto member = static_cast<SetMember>(m);
    const bool rides = member == SetMember::planet || member == SetMember::planet2;
    const double width =
        widths.each[m].value_or(given.of(member).value_or(kFaceModules * sized.module));
    sum += (rides ? sized.planets : 1) *
           mass(signed_teeth(member, sized.teeth[m]), sized.module, width, problem.density[m]);
  }
  return sum;
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
  // The candidates are sorted by cost, so only an earlier candidate can dominate a candidate.
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
