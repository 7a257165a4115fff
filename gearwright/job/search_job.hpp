// The verb search: runs a search in memory, or as a campaign whose finished chunks stay on disk.
//
//   trials   0 … N − 1, cut into chunks of one size      campaign   many chunks and a folder
//
// Whoever works on chunks, threads, shards or ranks, the result is that of one process: chunks do
// not depend on each other, and what is made of them goes through them in order.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/design/nearest_change.hpp"
#include "gearwright/design/search.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

struct SearchProgress {
  enum class Stage {
    trials,   ///< the search itself
    changes,  ///< nothing is feasible: what would help; `done` questions to trials
    regions   ///< of the designs that are listed; `done` of `of`
  };
  Stage stage = Stage::trials;
  std::int64_t done = 0, of = 0;
  std::int64_t trials = 0;  ///< done by this process
  std::int64_t chunks = 0;  ///< done by all, as far as this process knows
  std::int64_t of_chunks = 0;
  std::int64_t left = 0;  ///< trials that this process may still get
};

struct SearchOptions {
  std::filesystem::path out;  ///< folder of the files; empty: none
  bool resume = false;
  int shard = 1, shards = 1;  ///< this process does the chunks shard − 1, + shards, …
  bool many = false;          ///< others may have opened the folder before: shards, ranks
  bool together = false;      ///< ranks: a campaign however small, opened by the first
  bool yes_large = false;
  std::optional<std::size_t> top;      ///< designs to keep; absent: kDefaultDesigns
  std::optional<std::int64_t> chunk;   ///< trials of a chunk; absent: by the size of the search
  std::optional<std::size_t> regions;  ///< listed designs whose regions are wanted; absent: all
  int threads = 0;                     ///< 0: as many as the machine has
  std::string writer = "search";       ///< who, in the journal
  /// Draws the number of a chunk from a queue that others draw from too; empty: a queue of this
  /// process's own. Called by one thread at a time.
  std::function<std::int64_t()> next_chunk;
  /// Told whether the folder could be opened, and says whether to go on; called by ranks that join
  /// before they open it.
  std::function<bool(bool opened)> folder_is_open;
  /// Waits until all processes are done, and says whether this one makes the files.
  std::function<bool()> finish_together;
  /// Told many times a second, by one thread at a time; it chooses what it says.
  std::function<void(const SearchProgress&)> progress;
  const std::atomic<bool>* stop = nullptr;  ///< set: end at once, without the chunks in work
};

/// Designs that an answer holds if nothing else is said: every one of all but huge searches.
inline constexpr std::size_t kDefaultDesigns = 100'000;
/// More trials than this only with yes_large.
inline constexpr double kLargeSearch = 2e10;
/// More points of a grid of shifts than this only with yes_large.
inline constexpr double kManyPoints = 1e8;

struct SearchRun {
  SearchAnswer answer;    ///< of a finished search
  bool finished = false;  ///< all chunks are done and this process made the files
  bool stopped = false;   ///< by SearchOptions::stop
  std::int64_t chunks_done = 0, chunks = 0;
  std::vector<NearestChange> changes;  ///< when nothing is feasible
  std::optional<DesignRow> safest;     ///< the same, of rated designs
  std::string changes_left_out;        ///< why they, or the smallest of them, were not looked for
  std::vector<std::string> notes;      ///< what was mended in the folder
  bool pair_not_read = false;          ///< the spec has a [pair], which says nothing to a search
  bool rating_not_read = false;        ///< it has a [rating] that this search does not ask for
  std::vector<std::filesystem::path> files;
};

/// A run that has done nothing yet: it knows what of the spec this search does not read.
SearchRun begun(const JobSpec& spec, const Search& search);

/// Chunks that a folder, and the list of them, can hold: no search has more.
inline constexpr std::int64_t kMaxChunks = 1'000'000;

/// Runs the search of the spec.
///
/// Throws    IoError
/// Errors    --yes-large for a large search or grid, with how long or how many; no tooth numbers in
///           the ratio; more chunks than kMaxChunks; --out of a campaign that is there already, or of
///           a finished search of another spec; --resume of none or of another spec; --shard or
///           --resume without --out
Result<SearchRun> run_search(const JobSpec& spec, const Search& search,
                             const SearchOptions& options);

/// Trials per chunk of a search of this size.
std::int64_t chunk_size(const SearchProblem& problem, std::int64_t trials);

/// What decides the result, as lines "key = value".
std::string search_fingerprint(const JobSpec& spec, std::int64_t chunk);

}  // namespace gearwright
