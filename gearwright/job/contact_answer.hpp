// The verb `contact` analyses the working and the non-working flanks under the errors and
// modifications of the spec. The flanks are those of a pair, of a rack and its pinion, or of both
// halves of a double-helical pair.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/rack_contact.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

/// Returns the errors of the spec, for a pair or for a rack and its pinion. A single gear has none.
ContactErrors errors_of(const SolvedJob& job);

/// Domain    a job with a pair (contract)
/// Errors    `gear1.double_helical` for double-helical gears; the errors of ContactSetup::of
Result<ContactSetup> setup_of(const SolvedJob& job);

/// Returns a copy of `errors` in which the error in row `index` of error_entries() has the value
/// `value`, in the unit of its key.
ContactErrors with_error(const ContactSetup& setup, ContactErrors errors, std::size_t index,
                         double value);

/// The influence of one number of the spec, with the key of its derivative in results.
struct NamedInfluence : NamedSlope {
  Influence influence;
};

/// Returns the influences of all errors that have a derivative (ErrorEntry::kind). For each gear
/// with modifications, the list also contains the influences of all modifications whose range on
/// the flank is known. The errors and modifications of a rack's teeth are not included.
std::vector<NamedInfluence> influences_of(const SolvedJob& job);

struct ContactAnswer : ContactView {
  /// For a double-helical pair, the setup of the half at z > 0; none for a rack.
  std::optional<ContactSetup> setup;
  ContactResult on_halves{};  ///< positions of both halves, on which the verdict is based

  /// Returns the contact of the working flanks on which the verdict is based. For a double-helical
  /// pair, this is `on_halves`.
  const ContactResult& judged() const { return halves.empty() ? driving : on_halves; }
};

bool any_contact(const ContactResult& result);

ContactOptions rack_options(const SolvedJob& job, Progress* progress);

/// Errors    the errors of setup_of; `errors` if no teeth touch at any position and the spec has
///           errors; `pair.center_distance` if no teeth touch and the spec has no errors
Result<ContactAnswer> answer_contact(SolvedJob& job, Progress* progress = nullptr);

std::string contact_listing(const SolvedJob& job, const ContactAnswer& answer);

}  // namespace gearwright
