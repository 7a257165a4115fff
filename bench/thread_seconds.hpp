// Processor time of the calling thread. A busy machine slows two compared computations unequally,
// so wall time is not used for ratios.
#pragma once

#include <ctime>

inline double thread_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
