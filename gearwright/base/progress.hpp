// How far a long work is: counted by whoever does it, read by whoever waits, from any thread.
//
// Work that can be watched takes a `Progress*`; null means that nobody waits. Counting changes no
// result and needs no lock. Who waits may stop the work: its next step throws `WorkStopped`, which
// passes through everything that works and reaches who called it.
#pragma once

#include <atomic>
#include <cstdint>

namespace gearwright {

/// Out of a step after `Progress::stop`. No fault of the work and no answer to it.
struct WorkStopped {};

class Progress {
 public:
  struct State {
    const char* stage;  ///< "map of two errors"; null: nothing has begun
    std::int64_t done, of;
  };

  /// A stage of about so many steps. The words live as long as the program.
  void begin(const char* stage, std::int64_t steps) {
    done_ = 0;
    of_ = steps;
    stage_ = stage;
  }
  /// Throws WorkStopped once it has been stopped.
  void step() {
    if (stopped_.load(std::memory_order_relaxed)) throw WorkStopped();
    done_.fetch_add(1, std::memory_order_relaxed);
  }
  /// From any thread.
  void stop() { stopped_ = true; }
  State state() const { return {stage_, done_, of_}; }

  /// From here on files are written: who wants to stop waits until they are whole.
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
