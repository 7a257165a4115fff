// Defines the names of corrections, and makes the spec with corrections, for the verbs that search
// for corrections. Internal to job/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Returns the corrections with these indices in correction_entries. If there are no indices,
/// returns the default corrections of the pair.
///
/// Errors    `field` for a correction that is not possible for these teeth
Result<std::vector<WorkshopCorrection>> corrections_of(const ContactSetup& setup,
                                                       const std::vector<std::size_t>& places,
                                                       const std::string& field);

/// Returns the key of a correction in the corrected spec. A slope has the key of the loaded flank.
/// Any other modification has the key of both flanks.
std::string spec_key(const ContactSetup& setup, const WorkshopCorrection& correction,
                     bool gear2_drives);

/// True if the value is at the end of the searched range, so that a larger correction may be
/// better. For the value 0, the result is false, although 0 is an end of the range of a crowning.
bool at_bound(const Correction& range, double value);

FoundCorrection found_correction(const WorkshopCorrection& correction, double value,
                                 std::string spec_key, bool at_bound);

/// Returns the tree with its plain values before its tables. A TOML file requires this order.
Json plain_first(const Json& tree);

/// Returns the spec of the job, with the corrections added under their keys.
Json corrected_spec(const SolvedJob& job, const ContactSetup& setup,
                    const std::vector<WorkshopCorrection>& which, const std::vector<double>& value,
                    bool gear2_drives);

}  // namespace gearwright
