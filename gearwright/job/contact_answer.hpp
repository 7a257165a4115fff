// The pair of a spec under its errors and modifications, for both flanks: the verb `contact`.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/contact/error_map.hpp"
#include "gearwright/contact/pattern.hpp"
#include "gearwright/job/job_contact.hpp"

namespace gearwright {

/// For a double-helical pair, the results are those of the whole gears, whose halves share the load
/// because one gear floats along its axis (contact/halves.hpp); there is no pattern.
struct ContactAnswer {
  ContactSetup setup;             ///< for a double-helical pair, that of the half at z > 0
  ContactResult driving;          ///< flanks of the requested driver
  ContactResult other;            ///< the non-working flanks, at the same positions
  std::optional<Angle> min_play;  ///< of gear 2, between both; < 0 if the gears jam
  /// Peak to peak of the continuous curve of the driving flanks; none if contact is lost.
  std::optional<Angle> continuous_span;
  std::optional<ErrorMap> map;
  std::optional<std::array<FlankRaster, 2>> pattern;  ///< if requested in [contact]
  std::vector<ContactAnswer>
      halves{};                       ///< of a double-helical pair, at z > 0 and z < 0; else empty
  std::vector<double> float_axial{};  ///< mm, as WholeContact, for each position
  ContactResult on_halves{};          ///< the positions of both halves, for the verdict

  /// The working flanks as the verdict judges them.
  const ContactResult& judged() const { return halves.empty() ? driving : on_halves; }
};

/// Errors    as setup_of; `errors` when no tooth touches at any position
Result<ContactAnswer> answer_contact(SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
