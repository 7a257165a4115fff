// The verb `rate` rates the pair of a spec that has [rating] and materials. It also computes values
// that would improve the rating.
#pragma once

#include "gearwright/base/progress.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright {

struct RatingAnswer : RatingView {
  WantedSafety wanted;  ///< required safeties in the spec, or 1
};

/// Rates the pair. If a limit of the standard is exceeded, the job gets a warning.
///
/// Errors    `rating` if the spec has none; `gearN.material…` if a strength of the material is
///           unknown; the errors of rated_pair and rate; the errors of answer_load if
///           `rating.tooth_contact` is set
Result<RatingAnswer> answer_rating(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
