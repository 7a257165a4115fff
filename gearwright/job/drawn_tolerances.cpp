#include "gearwright/arrange/tolerance_ends.hpp"
#include "gearwright/job/scatter_answer.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

std::vector<ScatterTolerance> drawn_tolerances(const SolvedJob& job) {
  std::vector<ScatterTolerance> all;
  const PairInput& pair = job.completed.pair;
  for (const TolerancedNumber& t : tolerances_of(job)) {
    const bool distance = t.of == TolerancedNumber::Of::distance;
    if (t.of == TolerancedNumber::Of::tip || (distance && job.spec.scatter.bearings) ||
        (!distance && job.pair->arcs()))
      continue;
    const double nominal =
        distance ? job.pair->center_distance() : job.gear(t.gear).spec.thickness_allowance;
    const auto range = Distribution::of({{t.ends[0] - nominal, t.ends[1] - nominal}}).value();
    if (distance) {
      all.push_back({"errors." + std::string(error_entries()[0].key), 1.0, range,
                     VaryingError::center_distance,
                     pair.distance_tolerance ? "pair.center_distance_tolerance"
                                             : "pair.center_distance_deviations_mm"});
      continue;
    }
    std::string source = "pair.backlash_mm";
    for (const char* key : {"thickness_allowance_mm", "tolerance.thickness_series",
                            "tolerance.span_mm", "tolerance.over_balls_mm"})
      if (job.spec.given.contains(gear_field(t.gear, key))) source = gear_field(t.gear, key);
    all.push_back({gear_field(t.gear, "thickness_allowance_mm"), 1.0, range,
                   VaryingThickness{t.gear}, source});
  }
  return all;
}

}  // namespace gearwright
