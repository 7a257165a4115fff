// Computes the optional parts of a run, which are corrections, scatter and strength. A part is
// empty if there is no pair, if the spec has no table for the part, or if it cannot be computed for
// these gears. Internal to job/.
#pragma once

#include <optional>

#include "gearwright/job/analysis.hpp"

namespace gearwright {

/// Returns the corrections of [compensate]. If they cannot be computed, for example because no
/// teeth touch, the result is empty, and the job gets a warning.
///
/// Errors    all other errors of answer_compensate()
Result<std::optional<CompensateAnswer>> compensation_part(SolvedJob& job, Progress* progress);

/// Returns the scatter of [scatter]. If there is no contact, the result is empty. There is no
/// further warning, because the contact analysis already adds one.
///
/// Errors    all other errors of answer_scatter()
Result<std::optional<ScatterAnswer>> scatter_part(SolvedJob& job, Progress* progress);

/// Returns the rating of the pair according to [rating]. If the rating needs the load along the
/// teeth, and this load cannot be computed, for example because no teeth touch, the result is
/// empty, and the job gets a warning.
///
/// Errors    all other errors of answer_rating()
Result<std::optional<RatingAnswer>> rating_part(SolvedJob& job, Progress* progress);

}  // namespace gearwright
