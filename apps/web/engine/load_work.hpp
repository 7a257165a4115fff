// Teeth under load in steps: a table for each gear, which takes longest, then position by position.
//
// The tables stay when the work is done: torque, errors and modifications do not change them, so that
// a page that pulls these waits for the positions alone.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/web/engine/session.hpp"
#include "gearwright/job/load_answer.hpp"

namespace gearwright::web {

/// What the JSON of `load` does not hold, for pictures; rows [position * slices + slice].
struct LoadPicture {
  struct Tooth {
    int pair;                                  // as many pitches behind tooth pair 0
    Numbers share;                             // by position; NaN: it does not carry
    Numbers pressure, diameter_1, diameter_2;  // MPa, mm; NaN: does not carry
  };
  struct Torque {
    Numbers stiffness;  // N/(mm µm), by position
    std::vector<Tooth> teeth;
  };
  Numbers height;  // mm, middles of the slices, of gear 1
  std::vector<Torque> torques;
};

class LoadWork {
 public:
  /// Errors    as load_task
  static Result<std::shared_ptr<LoadWork>> begin(std::shared_ptr<Session> session,
                                                 std::optional<ComplianceAccuracy> accuracy);
  Result<Steps> step(double milliseconds);
  bool finished() const { return picture_.has_value(); }
  /// What `gearwright load SPEC --json` prints but for probes; empty before the end.
  const std::string& json() const { return json_; }
  const std::optional<LoadPicture>& picture() const { return picture_; }

 private:
  LoadWork(SolvedJob job, LoadTask task) : job_(std::move(job)), task_(std::move(task)) {}
  std::optional<Error> make_table(int which);
  std::optional<Error> close();

  SolvedJob job_;
  LoadTask task_;
  std::array<std::shared_ptr<const ToothTable>, 2> tables_;
  std::optional<ContactPair> pair_;
  std::optional<ContactPair> perfect_;
  std::optional<PairCompliance> compliance_;
  std::optional<LoadedTurn> turn_;
  std::size_t next_ = 0;
  std::string json_;
  std::optional<LoadPicture> picture_;
};

}  // namespace gearwright::web
