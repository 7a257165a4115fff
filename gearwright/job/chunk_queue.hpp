// Work in numbered chunks that several processes may share: how they share it, and the queue of one
// process.
//
// The folder of finished chunks is that of job/search_files.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gearwright {

struct CampaignOptions {
  std::filesystem::path out;  ///< folder of the files; empty if there are none
  bool resume = false;
  int shard = 1, shards = 1;      ///< this process computes the chunks shard − 1, + shards, …
  bool many = false;              ///< others may have opened the folder before (shards, ranks)
  bool together = false;          ///< for ranks: always a campaign, opened by the first rank
  std::string writer = "search";  ///< name in the journal
  /// Draws the number of a chunk from a shared queue; if empty, from a queue of this process.
  /// Called by one thread at a time.
  std::function<std::int64_t()> next_chunk;
  /// The argument is true if the folder could be opened. Returns true to continue. Ranks that join
  /// call it before they open the folder.
  std::function<bool(bool opened)> folder_is_open;
  /// Waits until all processes are done, and returns true if this one makes the files.
  std::function<bool()> finish_together;
};

/// The chunks of one process, drawn by its threads.
class ChunkQueue {
 public:
  /// `todo`: ascending numbers of missing chunks, of `all`. `next_chunk` as in CampaignOptions.
  ChunkQueue(std::vector<std::int64_t> todo, std::int64_t all,
             const std::function<std::int64_t()>& next_chunk)
      : todo_(std::move(todo)), all_(all), next_chunk_(next_chunk) {}

  const std::vector<std::int64_t>& todo() const { return todo_; }
  std::optional<std::int64_t> next() {
    const std::lock_guard lock(mutex_);
    if (next_chunk_) {
      // The missing chunks when this process opened the folder.
      std::int64_t c = next_chunk_();
      while (c < all_ && !std::binary_search(todo_.begin(), todo_.end(), c)) c = next_chunk_();
      return c < all_ ? std::optional(c) : std::nullopt;
    }
    if (place_ == todo_.size()) return std::nullopt;
    return todo_[place_++];
  }

 private:
  std::vector<std::int64_t> todo_;
  std::int64_t all_;
  const std::function<std::int64_t()>& next_chunk_;
  std::size_t place_ = 0;
  std::mutex mutex_;
};

}  // namespace gearwright
