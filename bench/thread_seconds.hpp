// Processor time of the calling thread. A busy machine slows two compared computations unequally,
// so wall time is not used for ratios.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

inline double thread_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The processor time of a call of f.
template <class F>
double thread_seconds_of(const F& f) {
  const double start = thread_seconds();
  f();
  return thread_seconds() - start;
}

/// The median of the ratios of several rounds. It must have at least one value.
inline double median(std::vector<double> v) {
  const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}
