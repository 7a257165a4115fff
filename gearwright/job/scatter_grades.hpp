// The tolerances of `scatter` that a grade of ISO 1328-1 gives. Internal to job/.
#pragma once

#include <vector>

#include "gearwright/job/solved_job.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

/// Adds the tolerances from the grades of the spec that are not in `all` yet.
///
/// Errors    `scatter.quality` of a grade that the edition does not have, or of circular-arc teeth;
///           `scatter.gearN.…` of a key that needs a grade; `tolerance` as js_deviation()
std::optional<Error> add_graded(const SolvedJob& job, std::vector<ScatterTolerance>& all);

}  // namespace gearwright
