// The verb fit for a pinion with few teeth and the wheel that it cuts ([fit] few_teeth = true).
//
// Internal to job/ and the program.
#pragma once

#include "gearwright/job/fit_answer.hpp"

namespace gearwright {

/// Errors    keys of the spec that are not allowed here, or are missing
Result<FitAnswer> answer_few_teeth(const JobSpec& spec, Progress* progress = nullptr);

}  // namespace gearwright
