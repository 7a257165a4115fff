// The parts of a run that a spec may contain or not: corrections, scatter and strength. A part is
// empty if the spec has no table for it, or if it cannot be computed for these gears.
// Internal to job/.
#pragma once

#include <optional>

#include "gearwright/job/compensate_answer.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/scatter_answer.hpp"

namespace gearwright {

/// The corrections of [compensate]. If they cannot be computed, for example because nothing touches,
/// the result is empty, and the job has a warning.
///
/// Errors    those of answer_compensate()
Result<std::optional<CompensateView>> compensation_part(SolvedJob& job, Progress* progress);

/// The scatter of [scatter]. If there is no contact, the result is empty. No warning is added then,
/// because the contact analysis already warns.
///
/// Errors    those of answer_scatter()
Result<std::optional<ScatterAnswer>> scatter_part(SolvedJob& job, Progress* progress);

/// The strength by [rating]. If it needs the load along the teeth and this load cannot be computed,
/// for example because nothing touches, the result is empty, and the job has a warning.
///
/// Errors    those of answer_rating()
Result<std::optional<RatingAnswer>> rating_part(SolvedJob& job, Progress* progress);

}  // namespace gearwright
