// Corrections that a workshop can make against the errors of a housing: the verb `compensate`.
//
// Closed forms come first, if the teeth have them: the tool setting that restores the contact of
// circular-arc teeth after a change of centre distance, and the lead of either gear that removes
// the slope of the transmission error. Then the requested corrections are computed for the whole
// range.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/contact/compensation.hpp"
#include "gearwright/job/job_contact.hpp"
#include "gearwright/load/loaded_score.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

struct CompensateAnswer {
  std::vector<WorkshopCorrection> corrections;
  std::vector<std::string> spec_keys;  ///< for each correction: its key in `corrected`
  std::vector<bool> at_bound;  ///< for each correction: true if at the end of the search range
  Compensation result;
  std::vector<std::string> scenarios;
  CompensateAim aim = CompensateAim::transmission_error;
  std::vector<AimedLoad> loads;  ///< for an aim under load, by torque
  std::optional<SettingAnswer> setting;
  std::optional<LeadAnswer> lead;
  std::shared_ptr<const SpecTree> corrected;  ///< the spec with the corrections
  Verdict verdict;  ///< of the pair with the corrections, under the spec's errors
};

/// Errors    as answer_contact, `errors` if nothing touches in the uncorrected pair;
///           `compensate.corrections` for a correction that the teeth do not permit;
///           `compensate.range` if nothing touches in a corner of it with any correction
/// `curves`  as CompensationTask
Result<CompensateAnswer> answer_compensate(SolvedJob& job, Progress* progress = nullptr,
                                           int curves = CompensationTask{}.curves);

}  // namespace gearwright
