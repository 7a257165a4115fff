// Saves the results of a large search in a folder. The search is divided into numbered chunks, and
// each chunk is saved as soon as it is finished.
//
//   out/chunks/000123.chunk         a finished chunk: header with its counts, then its bytes
//   out/chunks/….part.HOST.PID      a chunk that is being written; it is renamed when complete
//   out/chunks/….chunk.damaged      a chunk that was found broken; it counts as missing
//   out/journal.sqlite              tables `campaign` and `chunks`
//
// The chunk files are authoritative, and no result depends on the journal. The journal is read by
// users and by the progress output, and it coordinates the processes. A file is renamed to its
// final name before its row is written to the journal. A process that is killed therefore loses
// only its current chunk. The next process that opens the folder writes the missing rows.
//
// Shards, ranks and nodes on one file system may work in one folder at the same time, because the
// locks that SQLite sets on the journal coordinate them. The file system must support these locks
// (Lustre must be mounted with flock).
//
// Nothing is synced to the disk. After a power failure, a chunk file may be too short, which its
// header and its checksum show. The journal may also be broken, but it can be moved away without
// loss.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/result.hpp"

namespace gearwright {

/// One search, divided into the chunks 0 … chunks − 1.
struct Campaign {
  /// All data that determine the result. They are the normalised spec, the version of the program
  /// and the size of a chunk, as lines "key = value". Two campaigns with the same text may share
  /// their chunks.
  std::string fingerprint;
  std::int64_t chunks = 0;
};

/// The numbers of tested, feasible and rejected candidates in a chunk.
struct ChunkCounts {
  std::int64_t tested = 0;
  std::int64_t feasible = 0;
  std::vector<std::int64_t> rejected;  ///< per constraint, in the order of `rejected_names` in
                                       ///< ChunkStore::open()

  friend bool operator==(const ChunkCounts&, const ChunkCounts&) = default;
};

enum class OpenAs {
  fresh,   ///< starts a campaign; rejected if the folder contains another campaign, or finished
           ///< chunks of this campaign
  resume,  ///< continues an existing campaign
  join     ///< starts or continues a campaign, for shards and ranks that start at the same moment
};

/// Every member may be called from several threads at once. A store must not be used after fork().
///
/// Throws    IoError from every member if a folder cannot be read or written, if the disk is full,
///           or if SQLite fails (with its message and the path of the journal)
class ChunkStore {
 public:
  /// Opens `folder` and checks every chunk file of the campaign against its checksum. A file that
  /// is broken or belongs to another campaign is renamed. It then counts as missing, and notes()
  /// reports it. A temporary file is removed if the process of this host that wrote it is dead, or
  /// if it is older than a day. `writer` is the name of this process in the rows of the journal.
  ///
  /// Errors    with the field "--out": the folder contains another search or a finished chunk, and
  ///           `as` is fresh; the folder contains no search, and `as` is resume; the fingerprint,
  ///           the number of chunks or the list of names differs (with the first lines that differ)
  static Result<ChunkStore> open(const std::filesystem::path& folder, const Campaign& campaign,
                                 const std::vector<std::string>& rejected_names, OpenAs as,
                                 std::string writer);

  /// True if the folder contains a journal.
  static bool is_in(const std::filesystem::path& folder);

  ChunkStore(ChunkStore&&) noexcept;
  ChunkStore& operator=(ChunkStore&&) noexcept;
  ~ChunkStore();

  bool done(std::int64_t chunk) const;
  /// Returns the unfinished chunks, ascending.
  std::vector<std::int64_t> missing() const;

  /// Saves a finished chunk, either whole or not at all. An existing chunk is overwritten with the
  /// same bytes, because the bytes of a chunk do not depend on the process that writes them.
  ///
  /// Throws    IoError. If the error names the journal, the chunk itself is saved, and the next
  ///           open() writes its row
  void put(std::int64_t chunk, std::string_view bytes, const ChunkCounts& counts);

  /// Returns the bytes of a finished chunk, checked against its checksum.
  ///
  /// Throws    IoError if the chunk is missing or broken. A broken chunk is renamed and counts as
  ///           missing
  std::string get(std::int64_t chunk) const;
  /// Returns the counts of a finished chunk. Its bytes are not checked.   Throws IoError like get()
  ChunkCounts counts(std::int64_t chunk) const;
  /// Returns the sum over all finished chunks of all processes.   Throws   IoError like get()
  ChunkCounts totals() const;

  /// Returns the repairs made by open(), one sentence each.
  const std::vector<std::string>& notes() const;

 private:
  struct Impl;
  explicit ChunkStore(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Returns the first three differences between the lines "key = value" of two campaigns and the
/// number of others, for example "search.contact_ratio_min was 1.2 and is now 1.3; search.m_max was
/// 5 and is not set now".
std::string campaign_differences(const std::string& was, const std::string& is);

}  // namespace gearwright
