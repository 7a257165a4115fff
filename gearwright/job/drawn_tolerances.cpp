// The tolerances of a drawing as inputs of `scatter`.
#include <algorithm>

#include "gearwright/catalogue/modification_keys.hpp"
#include "gearwright/job/scatter_answer.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

std::vector<ScatterTolerance> drawn_tolerances(const SolvedJob& job) {
  std::vector<ScatterTolerance> all;
  if (!job.ends) return all;
  const auto add = [&](const std::string& name, double a, double b, double nominal, const auto& of,
                       const std::string& source) {
    if (a == b) return;
    const std::array<double, 2> range{std::min(a, b) - nominal, std::max(a, b) - nominal};
    all.push_back({name, 1.0, Distribution::of({range}).value(), of, source});
  };
  const auto& [lower, upper] = *job.ends;
  const PairInput& pair = job.completed.pair;
  if ((pair.distance_tolerance || pair.distance_deviations) && !job.spec.scatter.bearings)
    add("errors." + std::string(error_entries()[0].key), lower.pair->center_distance(),
        upper.pair->center_distance(), job.pair->center_distance(), VaryingError::center_distance,
        pair.distance_tolerance ? "pair.center_distance_tolerance"
                                : "pair.center_distance_deviations_mm");
  for (const int which : {1, 2}) {
    const GearInput& gear = job.completed.gear(which);
    if (job.pair->arcs() || gear.cut_by || gear.basic) continue;
    std::string source = "pair.backlash_mm";
    for (const char* key : {"thickness_allowance_mm", "tolerance.thickness_series",
                            "tolerance.span_mm", "tolerance.over_balls_mm"})
      if (job.spec.given.contains(gear_field(which, key))) source = gear_field(which, key);
    const auto allowance = [&](const Arranged& at) {
      return at.gear(which).spec.thickness_allowance;
    };
    add(gear_field(which, "thickness_allowance_mm"), allowance(lower), allowance(upper),
        allowance(job), VaryingThickness{which}, source);
  }
  return all;
}

}  // namespace gearwright
