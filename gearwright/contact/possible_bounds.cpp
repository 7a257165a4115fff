#include "gearwright/contact/possible_bounds.hpp"

#include "gearwright/math/root.hpp"

namespace gearwright::detail {

CompensationTask within_teeth(CompensationTask task) {
  constexpr int kHalvings = 12;
  for (std::size_t k = 0; k < task.corrections.size(); ++k) {
    for (double Correction::*end : {&Correction::lo, &Correction::hi}) {
      const auto possible = [&](double x) {
        std::vector<double> v(task.corrections.size(), 0.0);
        v[k] = x;
        return task.pair_at(v, 0) != nullptr;
      };
      double& bound = task.corrections[k].*end;
      if (possible(bound)) continue;
      const double reached = nearest_possible(0.0, bound, possible, kHalvings);
      if (reached != 0.0) bound = reached;
    }
  }
  return task;
}

}  // namespace gearwright::detail
