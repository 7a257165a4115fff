#include "gearwright/contact/possible_bounds.hpp"

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
      double reached = 0.0, beyond = bound;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = (reached + beyond) / 2;
        (possible(middle) ? reached : beyond) = middle;
      }
      if (reached != 0.0) bound = reached;
    }
  }
  return task;
}

}  // namespace gearwright::detail
