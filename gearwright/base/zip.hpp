// A ZIP archive in memory, the container of 3MF and of compressed REXS files.
//
// Written entries are compressed by deflate (base/packing.hpp) and dated 1 January 1980, the oldest
// date that ZIP permits. The same input therefore gives the same bytes with the same zlib release.
// Format: PKWARE APPNOTE 6.3.3, without ZIP64.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/result.hpp"

namespace gearwright {

class ZipWriter {
 public:
  /// Domain    entries and archive below 2³² bytes, fewer than 65535 entries (contract)
  void add(std::string_view name, std::string_view content);

  /// Returns the archive with its directory. The writer must not be used afterwards.
  std::string finish() &&;

 private:
  struct Entry {
    std::string name;
    std::uint32_t crc;
    std::uint32_t packed;
    std::uint32_t size;
    std::uint32_t offset;
  };

  void append_common(const Entry& entry);

  std::string bytes_;
  std::vector<Entry> entries_;
};

/// The names of the files in an archive, in the order of its directory.
///
/// Errors    bytes that are not an archive or that end too early; ZIP64
Result<std::vector<std::string>> zipped_names(std::string_view archive);

/// The content of the file `name` in an archive.
///
/// Domain    a name of zipped_names() (contract)
/// Errors    as zipped_names(); a file that is encrypted, has more than `most` bytes, is compressed
///           by another method than deflate, or does not have its checksum
Result<std::string> unzipped(std::string_view archive, std::string_view name, std::size_t most);

}  // namespace gearwright
