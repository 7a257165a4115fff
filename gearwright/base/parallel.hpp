// Work on many items at once: the one place that knows threads.
//
// No result depends on how many threads there are: items do not look at each other, and what must
// come in order is handed on in order. A build without oneTBB (the browser's) runs the same items
// one after the other: parallel_without.cpp.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace gearwright {

/// Threads that `threads` stands for; 0: as many as the machine has.
int thread_count(int threads);

/// f(0) … f(n − 1), each once, in any order and from several threads. What one throws is thrown
/// here, after the others have ended.
void parallel_for(std::size_t n, const std::function<void(std::size_t)>& f, int threads = 0);

/// Work on many items at once, each handed on in the order in which it came. At most a few items a
/// thread are held.
///
///   next   gives the next item, false at the end     work   is called from many threads at once
void in_order(const std::function<bool(std::string&)>& next,
              const std::function<std::string(const std::string&)>& work,
              const std::function<void(const std::string&)>& take, int threads = 0);

}  // namespace gearwright
