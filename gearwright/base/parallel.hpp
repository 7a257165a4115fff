// Processes many items in parallel.
//
// No result depends on the number of threads, because items are independent and ordered results are
// delivered in order. A build without oneTBB (the browser's) runs the items one after the other
// (parallel_without.cpp).
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace gearwright {

/// The number of threads that are used: `threads`, or one for each core if `threads` is 0. It is 1
/// in a build without oneTBB.
int thread_count(int threads);

/// Calls f(0) … f(n − 1) once each, in any order and from several threads. If a call throws, calls
/// that have not begun may be omitted. The exception is thrown again after the other calls have
/// ended.
void parallel_for(std::size_t n, const std::function<void(std::size_t)>& f, int threads = 0);

/// Processes many items at once and delivers the results in the order of the items. Only a few
/// items per thread are in memory at a time.
///
///   next   writes the next item into its argument and returns true, or returns false if there
///          are no more items
///   work   computes the result of an item and returns the function that delivers it; `work` is
///          called from many threads at once, and the functions that it returns are called in
///          order
void in_order(const std::function<bool(std::string&)>& next,
              const std::function<std::function<void()>(const std::string&)>& work,
              int threads = 0);

}  // namespace gearwright
