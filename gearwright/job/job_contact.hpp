// The errors and modifications of a spec for contact analysis, with the names of their influences.
#pragma once

#include <string>
#include <vector>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

/// The errors of the spec; none for a single gear.
ContactErrors errors_of(const SolvedJob& job);

/// Domain    a job with a pair (contract)
/// Errors    as ContactSetup::of
Result<ContactSetup> setup_of(const SolvedJob& job);

/// The errors with one of error_entries set to a value in its own unit.
ContactErrors with_error(const ContactSetup& setup, ContactErrors errors, std::size_t index,
                         double value);

/// True if the halves of a double-helical pair are mirror images under its errors, at all rotations.
bool alike_halves(const SolvedJob& job);

/// A number whose influence is computed, with its key in results and its unit in rad or mm.
struct NamedInfluence {
  std::string key;    ///< "crossing_per_deg", "gear1_lead_crowning_per_um"
  double unit = 1.0;  ///< rad or mm per unit of the key
  Influence influence;
};

/// Every error, and every modification that the drawing places.
std::vector<NamedInfluence> influences_of(const SolvedJob& job);

}  // namespace gearwright
