// Watches a long computation. Reports its progress on stderr, and ends the program if the user
// presses Ctrl-C or if the program receives SIGTERM.
#pragma once

#include <array>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "apps/common/output.hpp"
#include "gearwright/base/progress.hpp"

namespace gearwright::apps {

/// Texts of a verb. The watching thread calls these functions. An empty function adds no text.
struct WatchWords {
  std::function<std::string()> before_stage{};  ///< text in front of the stage, for example "3 of
                                                ///< 20 designs, "
  std::function<std::string()> stopped{};       ///< text that replaces "nothing was written"
};

/// While this object exists, Ctrl-C (SIGINT) and SIGTERM end the program within half a second, with
/// status 3. Nothing is printed or written before the computation is complete, except the finished
/// designs of a study in its folder, so no partial result remains. While files are being written, a
/// signal takes effect only after the files are complete. A StatusLine reports the progress.
class Watch {
 public:
  explicit Watch(std::string verb, WatchWords words = {});
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  Progress* progress() { return &progress_; }

 private:
  void wait();
  std::string text(double seconds) const;

  std::string verb_;
  WatchWords words_;
  Progress progress_;
  StatusLine line_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  int signal_ = 0;                         // a signal that takes effect when the files are complete
  std::array<void (*)(int), 2> before_{};  // previous handlers of SIGINT and SIGTERM
  std::thread thread_;
};

/// Runs a computation that may take long, with a line of progress.
template <class Work>
auto watched(const char* verb, const Work& work, const WatchWords& words = {}) {
  Watch watch(verb, words);
  return work(watch.progress());
}

}  // namespace gearwright::apps
