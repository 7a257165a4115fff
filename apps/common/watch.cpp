#include "apps/common/watch.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>

#include <fmt/format.h>

namespace gearwright::apps {

namespace {

constexpr std::chrono::milliseconds kNap(100);  // time between two checks of the work and of
                                                // signals
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
    : verb_(std::move(verb)), words_(std::move(words)) {
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
  if (signal_ != 0)
    std::fprintf(stderr, "gearwright: stopped by a signal after all files had been written\n");
  for (std::size_t i = 0; i < kStops.size(); ++i) std::signal(kStops[i], before_[i]);
  if (const int signal = received.exchange(0))
    std::raise(signal);  // the signal arrived after the
                         // last check
}

void Watch::wait() {
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, kNap, [this] { return end_; })) {
    const int signal = received.exchange(0);
    if (signal > 0 && progress_.writing()) {
      signal_ = signal;
    } else if (signal > 0) {
      line_.clear();
      std::fprintf(stderr, "gearwright: %s stopped; %s\n", verb_.c_str(),
                   words_.stopped ? words_.stopped().c_str() : "nothing was written");
      std::_Exit(kStopped);
    }
    line_.show([this](double seconds) { return text(seconds); });
  }
}

std::string Watch::text(double seconds) const {
  const Progress::State s = progress_.state();
  const std::string text = fmt::format("{}, {:.0f} s: {}{}", verb_, seconds,
                                       words_.before_stage ? words_.before_stage() : "",
                                       s.stage ? s.stage : "reading the spec");
  if (s.of <= 0) return text;
  // The total number of steps is only an estimate, which the number of steps done may exceed.
  if (s.done >= s.of) return text + ", last steps";
  return fmt::format("{}, {} % done", text, 100 * s.done / s.of);
}

}  // namespace gearwright::apps
