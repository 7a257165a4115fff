// Waits beside a long work: says on stderr how far it is, and ends the program when it is told to.
#pragma once

#include <array>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "gearwright/base/progress.hpp"

namespace gearwright::apps {

/// From its making to its end Ctrl-C (SIGINT) and SIGTERM end the program within half a second,
/// with status 3: nothing is printed or written before the work is done, so that nothing is left
/// half. While files are written they wait until those are whole. After two seconds a line says how
/// far the work is: written over in a terminal, every ten seconds elsewhere.
class Watch {
 public:
  explicit Watch(std::string verb);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  Progress* progress() { return &progress_; }

 private:
  void wait();
  void say(double seconds);

  std::string verb_;
  Progress progress_;
  bool terminal_, shown_ = false;
  double said_ = 0.0;  // s
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  int signal_ = 0;  // one that waits for files
  std::array<void (*)(int), 2> before_{};  // handlers of SIGINT and SIGTERM
  std::thread thread_;
};

/// A work that may take long, with a line of how far it is.
template <class Work>
auto watched(const char* verb, const Work& work) {
  Watch watch(verb);
  return work(watch.progress());
}

}  // namespace gearwright::apps
