// What `run` has of teeth under load: the answer of `load`, and the report's part about it.
#pragma once

#include <optional>

#include "gearwright/figure/load_scene.hpp"
#include "gearwright/job/load_answer.hpp"

namespace gearwright {

/// The report points into the job; it has a pitch of positions, whatever rotations the answer has.
struct LoadPart {
  LoadAnalysis answer;
  std::optional<LoadScene> report;  ///< none: only probes were asked
};

/// None where [load] asks for neither torques nor probes, and for gears that loaded contact is not
/// made for: then a warning in the job says why.
///
/// Errors    as answer_load, where a number of the spec is wrong
Result<std::optional<LoadPart>> load_part(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
