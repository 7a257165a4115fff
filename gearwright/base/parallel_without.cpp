// The version without oneTBB runs one item after the other.
#include "gearwright/base/parallel.hpp"

namespace gearwright {

int thread_count(int) { return 1; }

void parallel_for(std::size_t n, const std::function<void(std::size_t)>& f, int) {
  for (std::size_t i = 0; i < n; ++i) f(i);
}

void in_order(const std::function<bool(std::string&)>& next,
              const std::function<std::function<void()>(const std::string&)>& work, int) {
  for (std::string item; next(item); item.clear()) work(item)();
}

}  // namespace gearwright
