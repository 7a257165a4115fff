// Corrections for loaded teeth: the quantity that `compensate` minimises under the torques of
// [load].
//
// The tables of the teeth are computed once, because corrections are microns on the flanks. Each
// trial repeats the contact.                    theory: docs/theory/12-loaded-contact.md, [T12.20]
#pragma once

#include <memory>
#include <vector>

#include "gearwright/contact/compensation.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/load/loaded_score.hpp"

namespace gearwright {

class LoadedAim {
 public:
  /// Errors    as load_task; if nothing touches, or if the slices are too fine, as judge_load
  static Result<LoadedAim> of(SolvedJob& job, Progress* progress);

  /// Peak to peak in rad or pressure in MPa, for the worst of the torques.
  CompensationAim aim() const;
  /// The score for each torque with this number of positions per pitch; NaN as in loaded_scores.
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
