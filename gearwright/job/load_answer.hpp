// The pair of a spec under torque, and probes of its teeth: the verb `load`.
#pragma once

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/job/job_contact.hpp"

namespace gearwright {

/// Errors    `load` without torque and probes; `gear2` missing; as loaded()
Result<LoadAnalysis> answer_load(SolvedJob& job, Progress* progress = nullptr);

/// Errors    as answer_load, and `load` without torque
Result<LoadTask> load_task(SolvedJob& job);

LoadView load_view(const SolvedJob& job, const LoadAnalysis& answer);

}  // namespace gearwright
