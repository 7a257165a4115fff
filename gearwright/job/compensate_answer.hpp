// The verb `compensate` computes corrections with which a workshop can compensate housing errors.
//
// Two corrections have closed forms for some teeth, and these are computed first. The first is the
// tool setting that restores the contact of circular-arc teeth after a change of the centre
// distance. The second is the change of lead of each gear that removes the slope of the
// transmission error. After that, the requested corrections are computed for the whole range of
// errors.
#pragma once

#include <functional>
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
  std::shared_ptr<const SpecTree> corrected;  ///< the spec with the corrections
  Verdict verdict;  ///< of the corrected pair under the errors of the spec
};

/// Errors    an input that [compensate] requires but that is absent; the errors of setup_of;
///           `errors` or `pair.center_distance` if no teeth of the uncorrected pair touch;
///           `compensate.corrections` for a correction that the teeth do not permit;
///           `compensate.range` if no teeth touch at a corner of the range, even with the computed
///           corrections; the errors of LoadedAim::of if the aim is under load; the errors of
///           reading, solving and analysing the corrected spec
/// `curves`  see CompensationTask::curves
Result<CompensateAnswer> answer_compensate(SolvedJob& job, Progress* progress = nullptr,
                                           int curves = CompensationTask{}.curves);

std::string compensate_listing(const SolvedJob& job, const CompensateAnswer& answer);

// The quantity that `compensate` minimises for loaded teeth, under the torques of [load].
//
// The compliance of the teeth is computed only once, because corrections change the flanks by only
// a few µm. The gaps of a corrected pair are usually derived from the gaps of a pair that has been
// analysed (NearbyLoad). This requires that all corrections remove material from flanks with line
// contact, and that their values are close to those of the analysed pair. In all other cases, the
// contact analysis is repeated.
//                                            theory: docs/theory/12-loaded-contact.md, [T12.20]

class LoadedAim {
 public:
  /// Computes the compliance of the teeth for the load of the job.
  ///
  /// Errors    the errors of load_task; the errors of judge_load if no teeth touch or if the
  ///           slices are too fine
  static Result<LoadedAim> of(SolvedJob& job, Progress* progress);

  /// Returns the score for each torque of the pair of a task with these corrections, under the
  /// scenario with this index. The list is empty if there is no pair.
  using Scores = std::function<std::vector<LoadedScore>(const std::vector<double>&, int, int)>;
  /// Returns a function that computes scores and stores them. The last argument of this function is
  /// the number of positions per pitch.
  Scores scores_of(const CompensationTask& task) const;
  /// Returns the quantity to minimise. It is the peak-to-peak transmission error in rad, or the
  /// pressure in MPa, under the torque for which it is greatest. `scores` are those of the task. If
  /// `corrections` modify a gear, this gear must have a field of removed material.
  CompensationAim aim(const CompensationTask& task, const Scores& scores,
                      const std::vector<WorkshopCorrection>& corrections) const;
  /// Returns the score for each torque. `positions` is the number of positions per pitch. See
  /// loaded_scores() for the cases in which a score is NaN.
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
