#include "gearwright/math/minimise.hpp"

#include <exception>
#include <nlopt.hpp>

#include "gearwright/base/contract.hpp"

namespace gearwright {

bool can_minimise() { return true; }

std::vector<double> minimise(Minimiser how, const MinimiserTask& task, std::vector<double> start) {
  GW_EXPECTS(task.lo.size() == start.size() && task.hi.size() == start.size() &&
             task.step.size() == start.size());
  nlopt::opt opt(how == Minimiser::whole_box ? nlopt::GN_DIRECT_L : nlopt::LN_SBPLX,
                 static_cast<unsigned>(start.size()));
  opt.set_lower_bounds(task.lo);
  opt.set_upper_bounds(task.hi);
  opt.set_initial_step(task.step);
  opt.set_maxeval(task.evaluations);
  opt.set_ftol_rel(task.relative_gain);
  opt.set_ftol_abs(task.gain);
  // An exception of f must not pass through the C code of NLopt. It is stored, NLopt is stopped,
  // and the exception is thrown again after the call of NLopt.
  struct Objective {
    const MinimiserTask& task;
    std::exception_ptr thrown;
  } called{task, nullptr};
  const auto objective = [](const std::vector<double>& x, std::vector<double>&,
                            void* data) -> double {
    Objective& o = *static_cast<Objective*>(data);
    try {
      return o.task.f(x);
    } catch (...) {
      o.thrown = std::current_exception();
      throw nlopt::forced_stop();
    }
  };
  opt.set_min_objective(objective, &called);
  double least = 0.0;
  try {
    opt.optimize(start, least);
  } catch (const nlopt::roundoff_limited&) {
    // Rounding prevents further progress; `start` then contains the best point.
  } catch (const nlopt::forced_stop&) {
    std::rethrow_exception(called.thrown);
  }
  return start;
}

}  // namespace gearwright
