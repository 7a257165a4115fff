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

/// Returns `errors`, with the error `index` of error_entries() set to a value in its own unit.
ContactErrors with_error(const ContactSetup& setup, ContactErrors errors, std::size_t index,
                         double value);

/// The influence of one number of the spec, with its key in results and the unit of this key.
struct NamedInfluence {
  std::string key;    ///< "crossing_per_deg", "gear1_lead_crowning_per_um"
  double unit = 1.0;  ///< one unit of the key, in rad or mm
  Influence influence;
};

/// Returns the influences of every error with a derivative (ErrorEntry::kind), and of every
/// modification with a given position on the flank. Influences of modifications of a rack are not
/// included.
std::vector<NamedInfluence> influences_of(const SolvedJob& job);

struct ContactAnswer : ContactView {
  /// For a double-helical pair, the setup of the half at z > 0; none for a rack.
  std::optional<ContactSetup> setup;
  ContactResult on_halves{};  ///< positions of both halves, on which the verdict is based

  /// Returns the contact of the working flanks, in the form on which the verdict is based.
  const ContactResult& judged() const { return halves.empty() ? driving : on_halves; }
};

bool any_contact(const ContactResult& result);

ContactOptions rack_options(const SolvedJob& job, Progress* progress);

/// Errors    the errors of setup_of; `errors` if no teeth touch at any position, or
///           `pair.center_distance` if the spec also has no errors
Result<ContactAnswer> answer_contact(SolvedJob& job, Progress* progress = nullptr);

std::string contact_listing(const SolvedJob& job, const ContactAnswer& answer);

}  // namespace gearwright
