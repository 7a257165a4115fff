// Long work in steps, so that a worker can handle messages between them: the pattern, a map over
// two errors, teeth under load.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "apps/web/engine/session.hpp"
#include "gearwright/job/load_answer.hpp"

namespace gearwright::web {

/// The progress of some work.
struct Steps {
  std::int64_t done, of;
  bool finished;
};

/// Work on a session's pair.
class Work {
 public:
  explicit Work(std::shared_ptr<Session> session) : session_(std::move(session)) {}
  virtual ~Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  Session& session() const { return *session_; }
  /// Works for about this duration.
  virtual Result<Steps> step(double milliseconds) = 0;
  /// The result so far; null if there is none yet.
  virtual Json result() const = 0;
  /// Figures of the result, for types of work that have some.
  virtual Result<Json> figures(int, double) const { return Json::array(); }

 private:
  std::shared_ptr<Session> session_;
};
using MadeWork = Result<std::shared_ptr<Work>>;

/// The pattern in rasters of increasing resolution. The first one is available immediately.
MadeWork pattern_work(std::shared_ptr<Session> session, int positions, const RasterSize& size);

/// An error axis, in the unit of its key.
struct ErrorAxis {
  std::string key;  ///< of [errors]
  double from = 0.0, to = 0.0;
  int n = 2;
};
/// Peak-to-peak transmission error over two errors, curve by curve.
MadeWork error_map_work(std::shared_ptr<Session> session, const std::array<ErrorAxis, 2>& axes,
                        int positions);

/// The compliance of the last gears under load. Torque, errors and modifications do not change it,
/// so a page that changes only these waits only for the positions.
class ToothTables {
 public:
  Result<std::shared_ptr<const ToothTable>> of(const std::array<const Gear*, 2>& gears, int which,
                                               const LoadRequest& request);

 private:
  struct Kept {
    int which;
    std::array<std::shared_ptr<const Gear>, 2> gears;
    LoadRequest request;
    std::shared_ptr<const ToothTable> table;
  };
  std::vector<Kept> kept_;
};

/// Teeth under load: a table for each gear, which takes longest, then position by position.
/// Errors    as load_task
MadeWork load_work(std::shared_ptr<Session> session, std::optional<ComplianceAccuracy> accuracy,
                   std::shared_ptr<ToothTables> tables);

}  // namespace gearwright::web
