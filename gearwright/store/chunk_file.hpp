// Reads and writes the files of the finished chunks of a campaign. A campaign is a search that is
// divided into chunks, and each file has a header that describes its chunk.
//
//   offset   bytes
//   0        8      "GWCHUNK1"
//   8        4      stamp of the campaign: CRC-32 of its properties
//   12       8      number of the chunk
//   20       8 + 8  tested, feasible
//   36       4      k, the number of constraints
//   40       8 k    rejected, by constraint
//   40 + 8k  8      length of the payload
//   48 + 8k  4      CRC-32 of the payload
//   52 + 8k  4      CRC-32 of the header up to here
//   56 + 8k         the payload
//
// All numbers have the least significant byte first. The header names neither the writer nor the
// time, so two runs of one campaign write the same bytes.
//
// Internal to store/, used through chunk_store.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/store/chunk_store.hpp"

namespace gearwright {

constexpr std::size_t kMaxConstraints = 500;  ///< with this limit, a header fits into 4096 bytes

/// The content of a chunk file and its state.
struct ChunkRead {
  /// `foreign`: a chunk of another campaign, whose payload is not checked.
  enum class State { whole, damaged, foreign };
  State state = State::whole;
  std::string damage;     ///< for example "is 12 bytes long instead of 96 bytes"; empty if whole
  ChunkCounts counts;     ///< set if whole
  std::int64_t size = 0;  ///< length of the payload; set if whole
  std::string payload;    ///< set if whole and if the payload was requested
};

class ChunkFolder {
 public:
  /// The part of a file that is read and checked: only the header, or also the payload.
  enum class Depth { header, payload };

  /// `stamp` distinguishes the chunks of different campaigns.
  ChunkFolder(std::filesystem::path folder, std::uint32_t stamp);

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path path(std::int64_t chunk) const;
  bool there(std::int64_t chunk) const;
  /// Returns the numbers of all chunk files, ascending. The list is empty if there is no folder.
  std::vector<std::int64_t> list() const;

  /// Returns the chunk, or nothing if its file does not exist.
  std::optional<ChunkRead> read(std::int64_t chunk, Depth depth) const;
  /// Writes the whole file or nothing.
  void write(std::int64_t chunk, std::string_view payload, const ChunkCounts& counts) const;
  /// Renames the file so that it no longer counts as a chunk.
  void set_aside(std::int64_t chunk) const;
  /// Removes the temporary files of dead processes of this host, and all temporary files that are
  /// older than a day.
  void remove_stale_parts() const;

 private:
  std::filesystem::path folder_;
  std::uint32_t stamp_;
  std::string host_;
};

/// True if `path` exists.   Throws  IoError if the system cannot determine whether `path` exists
bool path_exists(const std::filesystem::path& path);

}  // namespace gearwright
