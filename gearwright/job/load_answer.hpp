// The verb `load`: the pair of a spec under torque, and probes of its teeth.
#pragma once

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/job/job_contact.hpp"

namespace gearwright {

/// Errors    `load` if there is neither a torque nor a probe; `gear2` if it is missing; the errors
///           of loaded()
Result<LoadAnalysis> answer_load(SolvedJob& job, Progress* progress = nullptr);

/// Errors    the errors of answer_load; `load` if there is no torque
Result<LoadTask> load_task(SolvedJob& job);

LoadView load_view(const SolvedJob& job, const LoadAnalysis& answer);

}  // namespace gearwright
