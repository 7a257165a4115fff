// The verb `rate`: computes a rating from a spec with [rating] and materials, and values to improve
// it.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/rating/sizing.hpp"
#include "gearwright/rating/spectrum.hpp"

namespace gearwright {

struct RatingAnswer {
  RatedPair pair;
  RatingInput input;
  Rating rating;
  WantedSafety wanted;  ///< as in the spec, otherwise 1
  std::optional<SpectrumRating> spectrum;
  std::optional<double> torque_holding;  ///< N m, the greatest with the required safeties
  std::optional<double> face_holding;    ///< mm, the least common face width with them
  std::optional<ToothContact> contact;   ///< if the spec requests it

  RatingView view() const;
};

/// Rates the pair; exceeded limits of the standard become warnings of the job.
///
/// Errors    `rating` if the spec has none, `gearN.material…` if a limit is unknown; as rated_pair
///           and rate, and as answer_load if `rating.tooth_contact` is set
Result<RatingAnswer> answer_rating(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
