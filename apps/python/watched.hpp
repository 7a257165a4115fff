// Runs a long computation on another thread. Meanwhile, the main thread of Python checks for
// Ctrl-C and reports the progress.
//
// Python handles a signal only between two of its own instructions, and therefore not during a call
// that takes several seconds. Here, the calling thread waits without the GIL. At intervals of
// kLook, it acquires the GIL and checks for signals.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <optional>

#include "apps/python/values.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/base/progress.hpp"
#include "gearwright/catalogue/spelling.hpp"

namespace gearwright::python {

constexpr std::chrono::milliseconds kLook{50};

/// A computation that reports its progress or checks `stop`. end() requests the end of the
/// computation at its next step.
struct Watched {
  std::atomic<bool> stop{false};
  Progress progress;

  void end() {
    stop = true;
    progress.stop();
  }
};

/// Runs the computation until it ends, and rethrows its exceptions. If `look` throws an exception,
/// the function stops the computation, waits for its end, and then throws this exception. If the
/// user presses Ctrl-C, it does the same and throws KeyboardInterrupt.
inline void watch(Watched& watched, const std::function<void()>& work,
                  const std::function<void()>& look = {}) {
  std::exception_ptr raised;
  std::future<void> ended;
  {
    const py::gil_scoped_release free;
    ended = std::async(std::launch::async, work);
    while (ended.wait_for(kLook) != std::future_status::ready) {
      if (raised) continue;
      const py::gil_scoped_acquire hold;
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (look) look();
      } catch (...) {
        raised = std::current_exception();
        watched.end();
      }
    }
  }
  if (raised) std::rethrow_exception(raised);
  ended.get();
}

/// Returns the result of work(progress).   Throws  SpecError with the keys as the caller has given
/// them
template <class Work>
auto watched_result(const GivenKeys& given, const Work& work) {
  std::optional<decltype(work(static_cast<Progress*>(nullptr)))> found;
  Watched watched;
  watch(watched, [&] { found = work(&watched.progress); });
  if (!*found) raise(spelled(found->error(), given));
  return std::move(*found).take();
}

/// Calls row(0) to row(n − 1) from this number of threads. 0 stands for all cores of the machine.
template <class Row>
void watched_rows(std::size_t n, int threads, const Row& row) {
  Watched watched;
  watch(watched, [&] {
    const auto unless_stopped = [&](std::size_t r) {
      if (!watched.stop) row(r);
    };
    parallel_for(n, unless_stopped, threads);
  });
}

}  // namespace gearwright::python
