#include "gearwright/math/minimise.hpp"

#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/box_search.hpp"
#include "gearwright/math/subplex.hpp"

namespace gearwright {

std::vector<double> minimise(Minimiser how, const MinimiserTask& task, std::vector<double> start) {
  GW_EXPECTS(task.lo.size() == start.size() && task.hi.size() == start.size() &&
             task.step.size() == start.size() && !start.empty() && task.evaluations >= 1);
  for (std::size_t i = 0; i < start.size(); ++i)
    GW_EXPECTS(task.lo[i] < task.hi[i] && task.lo[i] <= start[i] && start[i] <= task.hi[i]);
  detail::Trials trials(task);
  return how == Minimiser::whole_box ? detail::search_box(task, trials)
                                     : detail::subplex(task, trials, std::move(start));
}

}  // namespace gearwright
