// The errors and modifications of a spec for contact analysis, and the names of their influences.
#pragma once

#include <string>
#include <vector>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

/// The errors of the spec, for a pair or a rack and its pinion. A single gear has no errors.
ContactErrors errors_of(const SolvedJob& job);

/// Domain    a job with a pair (contract)
/// Errors    the errors of ContactSetup::of
Result<ContactSetup> setup_of(const SolvedJob& job);

/// The errors, with the error `index` of error_entries() set to a value in its own unit.
ContactErrors with_error(const ContactSetup& setup, ContactErrors errors, std::size_t index,
                         double value);

/// True if, under the errors of the spec, the halves of a double-helical pair are mirror images at
/// all rotations.
bool alike_halves(const SolvedJob& job);

/// A number whose influence is computed, with its key in results and its unit in rad or mm.
struct NamedInfluence {
  std::string key;    ///< "crossing_per_deg", "gear1_lead_crowning_per_um"
  double unit = 1.0;  ///< one unit of the key, in rad or mm
  Influence influence;
};

/// The influences of every error, and of every modification whose position on the flank is given.
/// The influences of the modifications of a rack are not included.
std::vector<NamedInfluence> influences_of(const SolvedJob& job);

}  // namespace gearwright
