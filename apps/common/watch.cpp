#include "apps/common/watch.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "gearwright/base/system.hpp"

namespace gearwright::apps {

namespace {

constexpr double kFirst = 2.0;                        // s, time before the first line is printed
constexpr double kTerminal = 0.5, kElsewhere = 10.0;  // s between two lines
constexpr std::chrono::milliseconds kNap(100);        // between checks of the work and of signals
constexpr int kStopped = 3;

constexpr std::array kStops{SIGINT, SIGTERM};

std::atomic<int> received{0};

extern "C" void on_stop(int signal) {
  received = signal;
  std::signal(signal, on_stop);  // on some systems, the default handler is restored after the first
                                 // signal
}

}  // namespace

Watch::Watch(std::string verb, WatchWords words)
    : verb_(std::move(verb)), words_(std::move(words)), terminal_(is_terminal(stderr)) {
  received = 0;
  for (std::size_t i = 0; i < kStops.size(); ++i) {
    before_[i] = std::signal(kStops[i], on_stop);
    if (before_[i] == SIG_IGN) std::signal(kStops[i], SIG_IGN);
  }
  thread_ = std::thread([this] { wait(); });
}

Watch::~Watch() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_one();
  thread_.join();
  if (terminal_ && shown_) std::fprintf(stderr, "\r\033[K");
  if (signal_ != 0)
    std::fprintf(stderr, "gearwright: stopped by a signal after all files had been written\n");
  for (std::size_t i = 0; i < kStops.size(); ++i) std::signal(kStops[i], before_[i]);
  if (const int signal = received.exchange(0))
    std::raise(signal);  // the signal arrived after the
                         // last check
}

void Watch::wait() {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, kNap, [this] { return end_; })) {
    const int signal = received.exchange(0);
    if (signal > 0 && progress_.writing()) {
      signal_ = signal;
    } else if (signal > 0) {
      std::fprintf(stderr, "%sgearwright: %s stopped; %s\n", terminal_ && shown_ ? "\n" : "",
                   verb_.c_str(),
                   words_.stopped ? words_.stopped().c_str() : "nothing was written");
      std::_Exit(kStopped);
    }
    say(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
}

void Watch::say(double seconds) {
  const double pause = terminal_ ? kTerminal : kElsewhere;
  if (seconds < kFirst || (shown_ && seconds - said_ < pause)) return;
  const Progress::State s = progress_.state();
  const char* stage = s.stage ? s.stage : "reading";
  const std::string before = words_.before_stage ? words_.before_stage() : "";
  std::fprintf(stderr, "%sgearwright: %s, %.0f s: %s%s", terminal_ ? "\r" : "", verb_.c_str(),
               seconds, before.c_str(), stage);
  // The number of steps is only an estimate. If it is exceeded, the work is nearly complete.
  if (s.of > 0)
    std::fprintf(stderr, " %.0f %%",
                 100 * std::min(0.99, static_cast<double>(s.done) / static_cast<double>(s.of)));
  std::fprintf(stderr, "%s", terminal_ ? "   " : "\n");
  std::fflush(stderr);
  shown_ = true;
  said_ = seconds;
}

}  // namespace gearwright::apps
