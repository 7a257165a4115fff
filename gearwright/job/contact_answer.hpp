// The pair of a spec under its errors and modifications, for both flanks: the verb `contact`.
#pragma once

#include <array>
#include <optional>

#include "gearwright/contact/error_map.hpp"
#include "gearwright/contact/pattern.hpp"
#include "gearwright/job/job_contact.hpp"

namespace gearwright {

struct ContactAnswer {
  ContactSetup setup;
  ContactResult driving;          ///< flanks of the requested driver
  ContactResult other;            ///< the non-working flanks, at the same positions
  std::optional<Angle> min_play;  ///< of gear 2, between both; < 0 if the gears jam
  /// Peak to peak of the continuous curve of the driving flanks; none if contact is lost.
  std::optional<Angle> continuous_span;
  std::optional<ErrorMap> map;
  std::optional<std::array<FlankRaster, 2>> pattern;  ///< if requested in [contact]
};

/// Errors    as setup_of; `errors` when no tooth touches at any position
Result<ContactAnswer> answer_contact(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
