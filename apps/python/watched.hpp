// A long work on a thread of its own, while Python's main thread looks for Ctrl-C and says how far it is.
//
// Python hears a signal only between two of its own instructions, so that a call of seconds would not. The thread that
// called waits here, without the GIL but for a look every kLook.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

#include "gearwright/base/progress.hpp"

namespace gearwright::python {

namespace py = pybind11;

constexpr std::chrono::milliseconds kLook{50};

/// Told to stop, a work that counts its steps, or looks at `stop`, ends at the next one.
struct Watched {
  std::atomic<bool> stop{false};
  Progress progress;

  void end() {
    stop = true;
    progress.stop();
  }
};

/// Runs it to its end and hands on what it throws. On Ctrl-C, and when `look` raises, it is told to stop, and the
/// exception is raised once it has.
inline void watch(Watched& watched, const std::function<void()>& work,
                  const std::function<void()>& look = {}) {
  std::exception_ptr failed, raised;
  std::mutex mutex;
  std::condition_variable ended;
  bool done = false;
  {
    const py::gil_scoped_release free;
    std::thread thread([&] {
      try {
        work();
      } catch (...) {
        failed = std::current_exception();
      }
      const std::lock_guard lock(mutex);
      done = true;
      ended.notify_one();
    });
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, kLook, [&] { return done; })) {
      if (raised) continue;
      lock.unlock();
      {
        const py::gil_scoped_acquire hold;
        try {
          if (PyErr_CheckSignals() != 0) throw py::error_already_set();
          if (look) look();
        } catch (...) {
          raised = std::current_exception();
          watched.end();
        }
      }
      lock.lock();
    }
    lock.unlock();
    thread.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (failed) std::rethrow_exception(failed);
}

}  // namespace gearwright::python
