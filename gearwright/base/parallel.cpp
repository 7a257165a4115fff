#include "gearwright/base/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <memory>

namespace gearwright {

namespace {

constexpr std::size_t kItemsPerThread = 4;

}  // namespace

int thread_count(int threads) {
  return threads > 0 ? threads : tbb::this_task_arena::max_concurrency();
}

void parallel_for(std::size_t n, const std::function<void(std::size_t)>& f, int threads) {
  if (threads == 0) {
    tbb::parallel_for(std::size_t{0}, n, f);
    return;
  }
  // The arena limits the threads of this call. The global control permits this number of
  // threads even if the machine has fewer cores.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, n, f); });
}

void in_order(const std::function<bool(std::string&)>& next,
              const std::function<std::function<void()>(const std::string&)>& work, int threads) {
  const auto count = static_cast<std::size_t>(thread_count(threads));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
  using Item = std::shared_ptr<std::string>;
  using Delivery = std::function<void()>;
  tbb::parallel_pipeline(
      count * kItemsPerThread,
      tbb::make_filter<void, Item>(tbb::filter_mode::serial_in_order,
                                   [&](tbb::flow_control& flow) -> Item {
                                     auto item = std::make_shared<std::string>();
                                     if (!next(*item)) flow.stop();
                                     return item;
                                   }) &
          tbb::make_filter<Item, Delivery>(tbb::filter_mode::parallel,
                                           [&](const Item& item) { return work(*item); }) &
          tbb::make_filter<Delivery, void>(tbb::filter_mode::serial_in_order,
                                           [](const Delivery& deliver) { deliver(); }));
}

}  // namespace gearwright
