// The load part of `run`: the result of `load`, and its part of the report.
#pragma once

#include <optional>

#include "gearwright/figure/load_scene.hpp"
#include "gearwright/job/load_answer.hpp"

namespace gearwright {

/// The report contains pointers into the job. Its positions always cover one pitch, even if the
/// result has other rotations.
struct LoadPart {
  LoadAnalysis answer;
  std::optional<LoadScene> report;  ///< none if only probes were requested
};

/// The load part, or nothing if [load] requests neither torques nor probes. For gears that loaded
/// contact does not support, there is no part either, and the job gets a warning.
///
/// Errors    the errors of answer_load that are about a wrong number of the spec
Result<std::optional<LoadPart>> load_part(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
