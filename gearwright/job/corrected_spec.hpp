// Corrections by their names, and the spec that has them: for the verbs that search for corrections.
// Internal to job/.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/job/job_contact.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// Those at these places of kCorrections, or the usual ones of the pair if there are none.
///
/// Errors    `field`, of one that the teeth cannot take
Result<std::vector<WorkshopCorrection>> corrections_of(const ContactSetup& setup,
                                                       const std::vector<std::size_t>& places,
                                                       const std::string& field);

/// The key that holds a correction in the corrected spec: the slope of the flank that works, an amount
/// of both.
std::string spec_key(const ContactSetup& setup, const WorkshopCorrection& correction,
                     bool gear2_drives);

/// At the end of the searched range, so that more might be better. A crowning of 0 is not.
bool at_bound(const Correction& range, double value);

FoundCorrection found_correction(const WorkshopCorrection& correction, double value,
                                 std::string spec_key, bool at_bound);

/// The spec of the job with the corrections in it, where its own keys hold them.
Json corrected_spec(const SolvedJob& job, const ContactSetup& setup,
                    const std::vector<WorkshopCorrection>& which, const std::vector<double>& value,
                    bool gear2_drives);

}  // namespace gearwright
