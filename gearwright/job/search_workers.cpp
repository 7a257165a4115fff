#include "gearwright/job/search_workers.hpp"

#include <algorithm>
#include <utility>

#include "gearwright/base/parallel.hpp"
#include "gearwright/job/search_refusal.hpp"

namespace gearwright {

SearchWorkers::SearchWorkers(const Search& search, std::int64_t chunk,
                             std::vector<std::int64_t> todo, const SearchOptions& options)
    : search_(search),
      chunk_(chunk),
      options_(options),
      queue_(std::move(todo), (*search.space().size() + chunk - 1) / chunk, options.next_chunk) {
  progress_.of_chunks = (*search.space().size() + chunk - 1) / chunk;
  progress_.chunks = progress_.of_chunks - static_cast<std::int64_t>(queue_.todo().size());
  for (const std::int64_t c : queue_.todo()) progress_.left += trials_of(c);
}

void SearchWorkers::run(const Done& done) {
  const int threads = thread_count(options_.threads);
  parallel_for(
      static_cast<std::size_t>(threads), [&](std::size_t) { work(done); }, threads);
}

void SearchWorkers::work(const Done& done) {
  unsigned asked = 0;
  const SearchWatch watch = [&](std::int64_t trials) {
    trials_done_ += trials;
    if (stopped()) return false;
    constexpr unsigned kSeldom = 16;  // number of graphs between checks of the clock, so that
                                      // checks take no time
    if (trials > 0 || asked++ % kSeldom == 0) tell();
    return true;
  };
  while (!stopped()) {
    const auto c = queue_.next();
    if (!c) return;
    ChunkFinds finds;
    const std::int64_t from = *c * chunk_;
    // Only files contain the points. Every result contains their counts.
    const SearchCounts counts =
        search_.range(from, from + trials_of(*c), finds.designs,
                      {.detail = detail_of(search_.problem(), !options_.out.empty()),
                       .points = &finds.points,
                       .watch = watch});
    if (stopped()) return;  // a chunk is saved completely or not at all
    done(*c, std::move(finds), counts);
    ++chunks_done_;
    tell();
  }
}

void SearchWorkers::tell() {
  if (!options_.progress) return;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return;
  SearchProgress now = progress_;
  now.chunks += chunks_done_;
  now.trials = trials_done_;
  now.left -= std::min(now.left, now.trials);
  options_.progress(now);
}

std::int64_t SearchWorkers::trials_of(std::int64_t c) const {
  return std::min(chunk_, *search_.space().size() - c * chunk_);
}

}  // namespace gearwright
