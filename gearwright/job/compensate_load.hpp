// Corrections for loaded teeth: the quantity that `compensate` minimises under the torques of
// [load].
//
// The compliance of the teeth is computed once, because corrections change the flanks by a few µm
// only. Each trial repeats the contact analysis.
//                                            theory: docs/theory/12-loaded-contact.md, [T12.20]
#pragma once

#include <memory>
#include <vector>

#include "gearwright/contact/compensation.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/load/loaded_score.hpp"

namespace gearwright {

class LoadedAim {
 public:
  /// Errors    the errors of load_task; the errors of judge_load if nothing touches or if the
  ///           slices are too fine
  static Result<LoadedAim> of(SolvedJob& job, Progress* progress);

  /// The peak-to-peak transmission error in rad, or the pressure in MPa, for the worst of the
  /// torques.
  CompensationAim aim() const;
  /// The score for each torque with this number of positions per pitch. A score is NaN in the cases
  /// that are described at loaded_scores.
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
