// Computes chunks of a search with all threads of this process. Each chunk is passed to the caller
// as soon as it is finished. Internal to job/ and the programs.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <vector>

#include "gearwright/job/search_files.hpp"
#include "gearwright/job/search_job.hpp"

namespace gearwright {

class SearchWorkers {
 public:
  /// Receives the number of a chunk, its designs and its counts. Several threads may call it at the
  /// same time.
  using Done = std::function<void(std::int64_t, ChunkFinds, const SearchCounts&)>;

  /// `todo` contains the numbers of the chunks in ascending order. Each chunk has `chunk`
  /// trials; the last one may have fewer. `search` and `options` must outlive this object.
  SearchWorkers(const Search& search, std::int64_t chunk, std::vector<std::int64_t> todo,
                const SearchOptions& options);

  void run(const Done& done);
  bool stopped() const { return options_.stop && *options_.stop; }

 private:
  void work(const Done& done);
  void report_progress();
  std::int64_t trials_of(std::int64_t c) const;

  const Search& search_;
  std::int64_t chunk_;
  const SearchOptions& options_;
  ChunkQueue queue_;
  std::mutex mutex_;
  SearchProgress progress_;  // progress before this process computes its first chunk
  std::atomic<std::int64_t> trials_done_{0}, chunks_done_{0};
};

// The work after all trials of a search. It finds changes that would give a design if nothing is
// feasible, and computes the regions of the listed designs.

/// If no design is feasible, computes changes that make designs feasible. Returns false if the
/// search was stopped.
bool look_for_changes(const Search& search, const SearchOptions& options, SearchRun& run);

/// Computes the missing regions of the listed designs. Returns false if the search was stopped.
bool complete_regions(const Search& search, const SearchOptions& options, SearchRun& run);

}  // namespace gearwright
