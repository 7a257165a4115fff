// The verb `compensate` computes corrections by which a workshop can compensate errors of a
// housing.
//
// If closed forms exist for the teeth, they are computed first. One is the tool setting that
// restores the contact of circular-arc teeth after a change of centre distance. The other is the
// change of lead, for each gear, that removes the slope of the transmission error. Then the
// requested corrections are computed for the whole range of errors.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/contact/compensation.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/load/load_summary.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

struct CompensateAnswer : CompensateView {
  Compensation result;
  std::shared_ptr<const SpecTree> corrected;  ///< the spec with the corrections
  Verdict verdict;  ///< verdict on the corrected pair under the spec's errors
};

/// Errors    the errors of answer_contact; `errors` if nothing touches in the uncorrected pair;
///           `compensate.corrections` for a correction that the teeth do not permit;
///           `compensate.range` if nothing touches at a corner of the range, even with the computed
///           corrections
/// `curves`  is described at CompensationTask::curves
Result<CompensateAnswer> answer_compensate(SolvedJob& job, Progress* progress = nullptr,
                                           int curves = CompensationTask{}.curves);

std::string compensate_listing(const SolvedJob& job, const CompensateAnswer& answer);

// The quantity that `compensate` minimises for loaded teeth, under the torques of [load].
//
// The compliance of the teeth is computed once, because corrections change the flanks by a few µm
// only. If all corrections remove material from flanks with line contact, and their values are close
// to those of an analysed pair, the gaps are derived from the gaps of that pair (NearbyLoad). For
// all other values, the contact analysis is repeated.
//                                            theory: docs/theory/12-loaded-contact.md, [T12.20]

class LoadedAim {
 public:
  /// Computes the compliance of the teeth for the load of the job.
  ///
  /// Errors    the errors of load_task; the errors of judge_load if nothing touches or if the
  ///           slices are too fine
  static Result<LoadedAim> of(SolvedJob& job, Progress* progress);

  /// The peak-to-peak transmission error in rad, or the pressure in MPa, under the worst
  /// torque. The gears that `corrections` modify must have fields of removed material.
  CompensationAim aim(const std::vector<WorkshopCorrection>& corrections) const;
  /// The score for each torque with this number of positions per pitch. loaded_scores describes the
  /// cases in which a score is NaN.
  std::vector<LoadedScore> scores(const ContactPair& pair, int positions) const;
  int positions() const { return held_->task.request.positions; }
  const std::vector<double>& torques() const { return held_->task.request.torques; }  ///< N mm

 private:
  struct Held {
    LoadTask task;
    PairCompliance compliance;
    CompensateAim aim;
  };
  explicit LoadedAim(std::shared_ptr<const Held> held) : held_(std::move(held)) {}
  std::shared_ptr<const Held> held_;
};

}  // namespace gearwright
