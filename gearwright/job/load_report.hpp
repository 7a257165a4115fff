// The load part of `run`: the result of `load`, and its part of the report.
#pragma once

#include <optional>

#include "gearwright/figure/load_scene.hpp"
#include "gearwright/job/load_answer.hpp"

namespace gearwright {

/// The report points into the job. It always has a pitch of positions, also if the result has other
/// rotations.
struct LoadPart {
  LoadAnalysis answer;
  std::optional<LoadScene> report;  ///< none if only probes were requested
};

/// None if [load] requests neither torques nor probes, and for gears that loaded contact does not
/// support, with a warning in the job.
///
/// Errors    as answer_load, where a number of the spec is wrong
Result<std::optional<LoadPart>> load_part(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
