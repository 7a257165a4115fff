#include "gearwright/contact/tangent_descent.hpp"

#include <algorithm>

#include "gearwright/math/minimise.hpp"

namespace gearwright::detail {

namespace {

constexpr double kFirstRadius = 0.25;  // first trust radius, relative to the width of the box
constexpr double kLastRadius = 1e-3;   // the descent ends below this radius
constexpr int kMostTangentSteps = 20;  // greatest number of steps of a descent

}  // namespace

std::vector<double> descend(const DescentTask& task, std::vector<double> v) {
  double radius = kFirstRadius;
  DescentTask::Function model = task.model_at(v);
  double here = model(v);
  for (int step = 0; step < kMostTangentSteps && radius >= kLastRadius; ++step) {
    MinimiserTask near{
        .evaluations = 200 * static_cast<int>(v.size()), .gain = task.gain, .f = model};
    for (std::size_t i = 0; i < v.size(); ++i) {
      const Correction& c = task.box[i];
      const double reach = radius * (c.hi - c.lo);
      near.lo.push_back(std::max(c.lo, v[i] - reach));
      near.hi.push_back(std::min(c.hi, v[i] + reach));
      near.step.push_back(0.5 * reach);
    }
    const std::vector<double> next = minimise(Minimiser::downhill, near, v);
    const double promised = here - model(next);
    if (!(promised > task.gain)) break;
    const double there = task.f(next);
    const double gained = here - there;
    if (gained < 0.25 * promised) radius *= 0.35;
    if (gained > 0.75 * promised) radius = std::min(1.0, 2.0 * radius);
    if (!(gained > 0.0)) continue;
    v = next;
    here = there;
    model = task.model_at(v);
  }
  return v;
}

}  // namespace gearwright::detail
