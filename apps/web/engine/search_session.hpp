// A search in steps, so that a worker hears messages meanwhile, and a pattern and a map the same way.
//
// The steps are pieces of the range of trials; what comes out at the end is what the program's
// search gives: same designs, same order, same text.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/web/engine/session.hpp"
#include "gearwright/job/search_job.hpp"

namespace gearwright::web {

class SearchSession {
 public:
  /// Errors    as read_spec and run_search; without [search]
  static Result<std::shared_ptr<SearchSession>> open(std::string text, int most);

  std::int64_t trials() const { return trials_; }
  std::int64_t tested() const { return counts_.tested; }
  std::int64_t feasible() const { return counts_.feasible; }
  Steps step(double milliseconds);
  bool finished() const { return stage_ == Stage::done; }
  /// Of a finished search; empty before.
  std::string json() const;
  std::string best(int most) const;
  Result<std::string> take(int design) const;
  Result<std::string> report() const;

 private:
  SearchSession(SpecText text, JobSpec spec, std::size_t most);
  void search_some();
  void close_some();

  enum class Stage { trials, regions, changes, done };
  SpecText text_;
  JobSpec spec_;
  Search search_;
  std::int64_t trials_, from_ = 0, size_;
  std::size_t region_ = 0;
  Stage stage_ = Stage::trials;
  SearchCounts counts_;
  BestDesigns best_;
  SearchRun run_;
};

/// The pattern in rasters that grow finer: the first is there at once.
class PatternWork {
 public:
  PatternWork(std::shared_ptr<Session> session, int positions, const RasterSize& size);
  Result<Steps> step();
  const std::optional<std::array<FlankRaster, 2>>& result() const { return result_; }

 private:
  std::shared_ptr<Session> session_;
  int positions_;
  RasterSize size_;
  int next_ = 0;
  std::optional<std::array<FlankRaster, 2>> result_;
};

/// Peak to peak over two errors, curve by curve.
class ErrorMapWork {
 public:
  static Result<std::shared_ptr<ErrorMapWork>> begin(std::shared_ptr<Session> session,
                                                     const ErrorAxis& x, const ErrorAxis& y,
                                                     int positions);
  Result<Steps> step(double milliseconds);
  const ErrorMapGrid& result() const { return grid_; }

 private:
  std::shared_ptr<Session> session_;
  std::array<std::size_t, 2> keys_{};
  int positions_ = 64;
  std::size_t next_ = 0;
  ErrorMapGrid grid_;
};

}  // namespace gearwright::web
