// A search, or a study of the designs of a search, runs in numbered chunks. Several processes may
// share the chunks. A folder keeps the finished chunks, so that the work can be stopped, resumed
// and divided.
//
// A build without the store (store/) compiles campaign_without.cpp, which rejects any folder.
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

#include "gearwright/base/result.hpp"

namespace gearwright {

struct Campaign;   // store/chunk_store.hpp
class ChunkStore;  // the folder of finished chunks

struct CampaignOptions {
  std::filesystem::path out;  ///< folder of the files; empty if no files are written
  bool resume = false;
  int shard = 1, shards = 1;      ///< this process computes every `shards`-th chunk, beginning with
                                  ///< chunk shard − 1
  bool many = false;              ///< true if another shard or rank may have opened the folder
                                  ///< already
  bool together = false;          ///< true if this process is one of several ranks; the first rank
                                  ///< opens the folder for all of them
  std::string writer = "search";  ///< name of this process in the journal
  /// Returns the number of the next chunk in a queue that several processes share. If this function
  /// is not set, the process has its own queue. Only one thread at a time calls the function.
  std::function<std::int64_t()> next_chunk;
  /// Every rank calls this function once. On every rank, the function returns the value of `opened`
  /// that the first rank passed. The first rank passes true if it has opened the folder. If it
  /// passes false, the other ranks do not open the folder.
  std::function<bool(bool opened)> folder_is_open;
  /// Waits until all processes are done. Returns true if this process makes the files.
  std::function<bool()> finish_together;
};

/// The chunks of one process. The threads of the process take chunks from this queue.
class ChunkQueue {
 public:
  /// `todo` contains the numbers of the missing chunks in ascending order. `all` is the number of
  /// all chunks. `next_chunk` is described in CampaignOptions.
  ChunkQueue(std::vector<std::int64_t> todo, std::int64_t all,
             const std::function<std::int64_t()>& next_chunk)
      : todo_(std::move(todo)), all_(all), next_chunk_(next_chunk) {}

  const std::vector<std::int64_t>& todo() const { return todo_; }
  std::optional<std::int64_t> next() {
    const std::lock_guard lock(mutex_);
    if (next_chunk_) {
      // Chunks that were already finished when this process opened the folder are skipped.
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

/// Returns the reason why this build cannot keep finished chunks in a folder, or none if it can.
std::optional<Error> refuse_folder();

/// Opens the store in options.out. If the first rank could not open the folder, all other ranks get
/// no store. If `refused` is set, the folder is not opened, and the function returns `refused` as
/// the error.
///
/// Throws    IoError
/// Errors    `refused`; the errors of ChunkStore::open
Result<std::optional<ChunkStore>> open_campaign(const Campaign& campaign,
                                                const std::vector<std::string>& count_names,
                                                const CampaignOptions& options,
                                                const std::optional<Error>& refused);

/// Returns the missing chunks that this process may compute, in ascending order. If the processes
/// share a queue (next_chunk), these are all missing chunks.
std::vector<std::int64_t> own_chunks(const ChunkStore& store, const CampaignOptions& options);

}  // namespace gearwright
