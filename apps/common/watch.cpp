#include "apps/common/watch.hpp"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>

namespace gearwright::apps {

namespace {

constexpr double kFirst = 2.0;                        // s until the first line
constexpr double kTerminal = 0.5, kElsewhere = 10.0;  // s between lines
constexpr timespec kNap{0, 100'000'000};              // between checks of the work and of signals
constexpr int kStopped = 3;

sigset_t stops() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

Watch::Watch(std::string verb) : verb_(std::move(verb)), terminal_(isatty(2) != 0) {
  // Blocked in this thread and in all threads that it starts. The waiting thread receives them.
  const sigset_t set = stops();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  thread_ = std::thread([this] { wait(); });
}

Watch::~Watch() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  thread_.join();
  if (terminal_ && shown_) std::fprintf(stderr, "\r\033[K");
  if (signal_ != 0)
    std::fprintf(stderr, "gearwright: stopped by a signal after all files had been written\n");
  const sigset_t set = stops();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void Watch::wait() {
  const auto start = std::chrono::steady_clock::now();
  const sigset_t set = stops();
  for (;;) {
    const int signal = sigtimedwait(&set, nullptr, &kNap);
    const std::lock_guard lock(mutex_);
    if (end_) return;
    if (signal > 0 && progress_.writing()) {
      signal_ = signal;
    } else if (signal > 0) {
      std::fprintf(stderr, "%sgearwright: %s stopped; nothing was written\n",
                   terminal_ && shown_ ? "\n" : "", verb_.c_str());
      _exit(kStopped);
    }
    say(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
}

void Watch::say(double seconds) {
  const double pause = terminal_ ? kTerminal : kElsewhere;
  if (seconds < kFirst || (shown_ && seconds - said_ < pause)) return;
  const Progress::State s = progress_.state();
  const char* stage = s.stage ? s.stage : "reading";
  std::fprintf(stderr, "%sgearwright: %s, %.0f s: %s", terminal_ ? "\r" : "", verb_.c_str(),
               seconds, stage);
  // Steps are an estimate of the work, so work beyond it is nearly done.
  if (s.of > 0)
    std::fprintf(stderr, " %.0f %%",
                 100 * std::min(0.99, static_cast<double>(s.done) / static_cast<double>(s.of)));
  std::fprintf(stderr, "%s", terminal_ ? "   " : "\n");
  std::fflush(stderr);
  shown_ = true;
  said_ = seconds;
}

}  // namespace gearwright::apps
