// Corrections for loaded teeth: what `compensate` makes least under the torques of [load].
//
// The tables of the teeth are made once, for corrections are microns on the flanks; each trial
// repeats the contact.                    theory: docs/theory/12-loaded-contact.md, [T12.20]
#pragma once

#include <memory>
#include <vector>

#include "gearwright/contact/compensation.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/load/loaded_score.hpp"

namespace gearwright {

class LoadedAim {
 public:
  /// Errors    as load_task; where nothing touches, or the slices are too fine, as judge_load
  static Result<LoadedAim> of(SolvedJob& job, Progress* progress);

  /// Peak to peak in rad or pressure in MPa, at the worst of the torques.
  CompensationAim aim() const;
  /// Of each torque, with so many positions per pitch; of none as loaded_scores.
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
