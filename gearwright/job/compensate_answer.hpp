// Corrections that a workshop can make against the errors of a housing: the verb `compensate`.
//
// Closed forms first, where the teeth have them: the tool setting that brings the contact of
// circular-arc teeth back after a change of centre distance, and the lead of either gear that takes
// the slope out of the transmission error. Then the corrections asked for, against the whole range.
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
  std::vector<std::string> spec_keys;  ///< of each: the key that holds it in `corrected`
  std::vector<bool> at_bound;          ///< of each: at the end of what is looked for
  Compensation result;
  std::vector<std::string> scenarios;
  CompensateAim aim = CompensateAim::transmission_error;
  std::vector<AimedLoad> loads;  ///< of an aim under load, by torque
  std::optional<SettingAnswer> setting;
  std::optional<LeadAnswer> lead;
  std::shared_ptr<const SpecTree> corrected;  ///< the spec with the corrections in it
  Verdict verdict;  ///< of the pair with the corrections, under the spec's errors
};

/// Errors    as answer_contact, `errors` when nothing touches as the pair stands;
///           `compensate.corrections` for one that the teeth cannot take; `compensate.range` when
///           nothing touches in a corner of it, whatever is corrected
/// `curves`  as CompensationTask
Result<CompensateAnswer> answer_compensate(SolvedJob& job, Progress* progress = nullptr,
                                           int curves = CompensationTask{}.curves);

}  // namespace gearwright
