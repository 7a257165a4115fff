// The progress of a long computation, which counts its steps. Any thread may read the count.
//
// A computation with progress takes a `Progress*`, which may be null. Counting changes no
// result and needs no lock. If a caller stops the computation, the next step throws
// `WorkStopped`, which ends the computation and reaches the caller.
#pragma once

#include <atomic>
#include <cstdint>

namespace gearwright {

/// Thrown by a step after `Progress::stop`. It is neither an error nor a result.
struct WorkStopped {};

class Progress {
 public:
  struct State {
    const char*
        stage;  ///< for example "computing the map of two errors"; null before the first stage
    std::int64_t done, of;
  };

  /// Starts a stage of about `steps` steps. The text must have static lifetime.
  void begin(const char* stage, std::int64_t steps) {
    done_ = 0;
    of_ = steps;
    stage_ = stage;
  }
  /// Throws WorkStopped after `stop` was called.
  void step() {
    if (stopped_.load(std::memory_order_relaxed)) throw WorkStopped();
    done_.fetch_add(1, std::memory_order_relaxed);
  }
  /// Requests a stop, from any thread.
  void stop() { stopped_ = true; }
  State state() const { return {stage_, done_, of_}; }

  /// Marks the start of writing files. A signal then ends the program only after the files are
  /// complete (apps/common/watch.hpp).
  void begin_writing() { writing_ = true; }
  bool writing() const { return writing_; }

 private:
  std::atomic<const char*> stage_{nullptr};
  std::atomic<std::int64_t> done_{0}, of_{0};
  std::atomic<bool> writing_{false}, stopped_{false};
};

inline void begin_stage(Progress* progress, const char* stage, std::int64_t steps) {
  if (progress) progress->begin(stage, steps);
}
inline void count_step(Progress* progress) {
  if (progress) progress->step();
}

}  // namespace gearwright
