// Corrections that a workshop can make against the errors of a housing: the verb `compensate`.
//
// If closed forms exist for the teeth, they are computed first: the tool setting that restores the
// contact of circular-arc teeth after a change of centre distance, and the lead of either gear that
// removes the slope of the transmission error. Then the requested corrections are computed for the
// whole range of errors.
#pragma once

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/job/job_contact.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

struct CompensateAnswer : CompensateView {
  Compensation result;
  std::shared_ptr<const SpecTree> corrected;  ///< the spec with the corrections
  Verdict verdict;  ///< verdict on the corrected pair under the spec's errors
};

/// Errors    the errors of answer_contact; `errors` if nothing touches in the uncorrected pair;
///           `compensate.corrections` for a correction that the teeth do not permit;
///           `compensate.range` if nothing touches in a corner of the range with any correction
/// `curves`  like CompensationTask::curves
Result<CompensateAnswer> answer_compensate(SolvedJob& job, Progress* progress = nullptr,
                                           int curves = CompensationTask{}.curves);

}  // namespace gearwright
