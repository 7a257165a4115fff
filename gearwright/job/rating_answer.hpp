// The verb `rate`: computes a rating from a spec with [rating] and materials, and values to improve
// it.
#pragma once

#include "gearwright/base/progress.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright {

struct RatingAnswer : RatingView {
  WantedSafety wanted;  ///< as in the spec, otherwise 1
};

/// Rates the pair; exceeded limits of the standard become warnings of the job.
///
/// Errors    `rating` if the spec has none, `gearN.material…` if a limit is unknown; as rated_pair
///           and rate, and as answer_load if `rating.tooth_contact` is set
Result<RatingAnswer> answer_rating(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
