// Long computations in steps. Between the steps, a worker can handle messages. The computations are
// the contact pattern, the map of the transmission error as a function of two errors, and teeth
// under load.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "apps/web/engine/session.hpp"
#include "gearwright/job/load_answer.hpp"

namespace gearwright::web {

/// The progress of a computation, in which `done` of `of` steps are complete.
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
  /// Works for about this number of milliseconds.
  virtual Result<Steps> step(double milliseconds) = 0;
  /// Returns the result so far, or null if there is none yet.
  virtual Json result() const = 0;
  /// Returns figures of the result. Some types of work have none.
  virtual Result<Json> figures(int, double) const { return Json::array(); }
  /// Returns the rows of the tables of the result, a list for each torque. Most types of work have
  /// none.
  virtual Result<Json> rows() const { return Json::array(); }

 private:
  std::shared_ptr<Session> session_;
};
using MadeWork = Result<std::shared_ptr<Work>>;

/// Returns the contact pattern, in rasters of increasing resolution. The first raster is available
/// almost immediately.
MadeWork pattern_work(std::shared_ptr<Session> session, int positions, const RasterSize& size);

/// The range of an error on one axis of a map, in the unit of its key.
struct ErrorAxis {
  std::string key;  ///< key of [errors]
  double from = 0.0, to = 0.0;
  int n = 2;
};
/// Returns the peak-to-peak transmission error as a function of two errors. For each point of the
/// map, the transmission error over one pitch is computed.
MadeWork error_map_work(std::shared_ptr<Session> session, const std::array<ErrorAxis, 2>& axes,
                        int positions);

/// The compliance tables of the gears that were last computed under load. The tables are
/// independent of the torque, the errors and the modifications. If only these inputs change, only
/// the positions are computed again.
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

/// Computes teeth under load. Each of the first two steps makes the compliance table of one gear,
/// and these steps take longest. The following steps compute the positions.
/// Errors    the errors of load_task
MadeWork load_work(std::shared_ptr<Session> session, std::optional<ComplianceAccuracy> accuracy,
                   std::shared_ptr<ToothTables> tables);

}  // namespace gearwright::web
