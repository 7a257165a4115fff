// The verb `rate`: from a spec with [rating] and materials to a rating, and what to make of it.
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
  WantedSafety wanted;  ///< as the spec has it, else 1
  std::optional<SpectrumRating> spectrum;
  std::optional<double> torque_holding;  ///< N m, the greatest with the wanted safeties
  std::optional<double> face_holding;    ///< mm, the least common face width with them
  std::optional<ToothContact> contact;   ///< where the spec asks for it

  RatingView view() const;
};

/// Rates the pair; limits of the standard that it passes become warnings of the job.
///
/// Errors    `rating` where the spec has none, `gearN.material…` where a limit is not known; as
///           rated_pair and rate, and where `rating.tooth_contact` is asked as answer_load
Result<RatingAnswer> answer_rating(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
