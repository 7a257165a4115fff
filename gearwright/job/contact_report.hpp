// Makes the contact part of the report, which contains the result, patterns and maps, and the
// errors in words.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gearwright/contact/halves.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/report/contact_report.hpp"

namespace gearwright {

/// Returns an error with its value in the unit of its key. `index` is the row in error_entries().
NamedAmount named_error(std::size_t index, double value);

/// True if the report has a contact part. This requires a pair, or a rack with its pinion. In
/// addition, the spec must have [errors], [contact] or modifications, or the teeth must be circular
/// arcs.
bool wants_contact(const SolvedJob& job);

/// The contact of one pair of flanks over a pitch, with the data of its pictures. The flanks belong
/// to two gears, to a pinion and its rack, or to one half of a double-helical pair.
struct FlankContact : ContactScene {
  std::shared_ptr<const ContactPair> pair;  ///< the mirror image, for the half at z < 0
  bool below = false;                       ///< true for the half at z < 0
  Angle behind{};                           ///< rotation of this half minus the rotation of gear 1

  /// Returns the patterns on both gears. For a rack, only the pattern on the pinion is used.
  std::array<FlankRaster, 2> pattern(int positions, const RasterSize& size) const;
  /// Returns the gap on gear 1 at a position of this scene.
  FlankRaster gap(const ContactPoint& at, const RasterSize& size) const;
};

/// Returns the contact of both halves, from their results over a pitch. If the halves are mirror
/// images, the list contains only the half at z > 0.
std::vector<FlankContact> flanks_of(const std::array<const Gear*, 2>& gears, const HalvesPair& pair,
                                    double marking,
                                    const std::array<const ContactResult*, 2>& results);

/// A result and its part of the report. The report contains pointers to data of the job, so the job
/// must outlive it.
struct ContactPart {
  ContactAnswer answer;
  ContactReport report;
};

/// Returns the contact part of a report, or none if the spec does not request it. If no teeth
/// touch, there is also no part, and the job gets a warning. The report needs equally spaced
/// positions over one pitch. Other rotations or pitches of the spec apply to the result only.
///
/// Errors    all other errors of answer_contact, for example modifications that do not fit
Result<std::optional<ContactPart>> contact_part(SolvedJob& job, Progress* progress);

}  // namespace gearwright
