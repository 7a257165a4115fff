// The names of corrections, and the spec with corrections, for the verbs that search for
// corrections. Internal to job/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// The corrections with these indices in correction_entries. Without any index, the result is the
/// default corrections of the pair.
///
/// Errors    `field` for a correction that is not possible for these teeth
Result<std::vector<WorkshopCorrection>> corrections_of(const ContactSetup& setup,
                                                       const std::vector<std::size_t>& places,
                                                       const std::string& field);

/// The key of a correction in the corrected spec. A slope has the key of the loaded flank. Any
/// other modification has the key for both flanks.
std::string spec_key(const ContactSetup& setup, const WorkshopCorrection& correction,
                     bool gear2_drives);

/// True if the value is at the end of the searched range, so that a larger correction might be
/// better. For a value of 0, the result is false, although 0 is an end of the range of a
/// crowning.
bool at_bound(const Correction& range, double value);

FoundCorrection found_correction(const WorkshopCorrection& correction, double value,
                                 std::string spec_key, bool at_bound);


/// The tree with its plain values moved before its tables, as a TOML file requires.
Json plain_first(const Json& tree);

/// The spec of the job with the corrections added under their keys.
Json corrected_spec(const SolvedJob& job, const ContactSetup& setup,
                    const std::vector<WorkshopCorrection>& which, const std::vector<double>& value,
                    bool gear2_drives);

}  // namespace gearwright
