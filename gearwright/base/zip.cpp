#include "gearwright/base/zip.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/little_endian.hpp"
#include "gearwright/base/packing.hpp"
#include "gearwright/base/printable.hpp"

namespace gearwright {

namespace {

constexpr std::uint16_t kZipVersion = 20;  // 2.0, the first version that supports deflate
constexpr std::uint16_t kDeflate = 8;
constexpr std::uint16_t kMidnight = 0;
constexpr std::uint16_t kNewYear1980 = (1U << 5U) | 1U;  // year 0 since 1980, month 1, day 1
constexpr std::size_t kSizeMax = 0xfffffffeU;            // 0xffffffff would indicate ZIP64
constexpr std::uint32_t kLocalHeader = 0x04034b50U;
constexpr std::uint32_t kDirectoryHeader = 0x02014b50U;
constexpr std::uint32_t kEndOfDirectory = 0x06054b50U;
// Lengths in bytes without names, extra fields and comments.
constexpr std::size_t kLocalLength = 30, kDirectoryLength = 46, kEndLength = 22;

Error no_zip(std::string rule) { return {"", "", std::move(rule)}; }

// A file in the directory of an archive.
struct Listed {
  std::string name;
  std::uint16_t flags, method;
  std::uint32_t crc, packed, size, offset;
};

Result<std::vector<Listed>> directory_of(std::string_view bytes) {
  const Error cut = no_zip("the archive ends too early or is damaged; copy the file again");
  std::size_t end = bytes.size() < kEndLength ? 0 : bytes.size() - kEndLength;
  const std::size_t first = end > 0xffffU ? end - 0xffffU : 0;  // a comment may follow the end
  while (end > first && u32_at(bytes, end) != kEndOfDirectory) --end;
  if (bytes.size() < kEndLength || u32_at(bytes, end) != kEndOfDirectory)
    return bytes.starts_with("PK") ? cut : no_zip("the file is not a ZIP archive");
  const std::size_t count = u16_at(bytes, end + 10);
  std::size_t at = u32_at(bytes, end + 16);
  if (at > kSizeMax || count == 0xffffU)
    return no_zip("the archive has the format ZIP64, which is not supported; compress it as ZIP");
  std::vector<Listed> list;
  for (std::size_t i = 0; i < count; ++i) {
    if (at + kDirectoryLength > bytes.size() || u32_at(bytes, at) != kDirectoryHeader) return cut;
    const std::size_t name = u16_at(bytes, at + 28);
    list.push_back({std::string(bytes.substr(at + kDirectoryLength, name)), u16_at(bytes, at + 8),
                    u16_at(bytes, at + 10), u32_at(bytes, at + 16), u32_at(bytes, at + 20),
                    u32_at(bytes, at + 24), u32_at(bytes, at + 42)});
    at += kDirectoryLength + name + u16_at(bytes, at + 30) + u16_at(bytes, at + 32);
  }
  return list;
}

}  // namespace

// Appends the fields that the local header and the directory have in common, from the version to
// the length of the extra field.
void ZipWriter::append_common(const Entry& entry) {
  append_u16(bytes_, kZipVersion);
  append_u16(bytes_, 0);  // flags
  append_u16(bytes_, kDeflate);
  append_u16(bytes_, kMidnight);
  append_u16(bytes_, kNewYear1980);
  append_u32(bytes_, entry.crc);
  append_u32(bytes_, entry.packed);
  append_u32(bytes_, entry.size);
  append_u16(bytes_, static_cast<std::uint16_t>(entry.name.size()));
  append_u16(bytes_, 0);  // length of the extra field
}

void ZipWriter::add(std::string_view name, std::string_view content) {
  GW_EXPECTS(content.size() <= kSizeMax && name.size() <= 0xffffU && entries_.size() < 0xfffeU);
  const std::string packed = deflated(content);
  GW_EXPECTS(bytes_.size() + packed.size() <= kSizeMax);
  const Entry entry{std::string(name), crc32_of(content), static_cast<std::uint32_t>(packed.size()),
                    static_cast<std::uint32_t>(content.size()),
                    static_cast<std::uint32_t>(bytes_.size())};
  append_u32(bytes_, kLocalHeader);
  append_common(entry);
  bytes_ += entry.name;
  bytes_ += packed;
  entries_.push_back(entry);
}

std::string ZipWriter::finish() && {
  const std::size_t directory = bytes_.size();
  for (const Entry& entry : entries_) {
    append_u32(bytes_, kDirectoryHeader);
    append_u16(bytes_, kZipVersion);  // version that made the entry
    append_common(entry);
    append_u16(bytes_, 0);  // length of the comment
    append_u16(bytes_, 0);  // number of the disk with the entry
    append_u16(bytes_, 0);  // internal attributes
    append_u32(bytes_, 0);  // external attributes
    append_u32(bytes_, entry.offset);
    bytes_ += entry.name;
  }
  const std::size_t size = bytes_.size() - directory;
  GW_EXPECTS(bytes_.size() <= kSizeMax);
  append_u32(bytes_, kEndOfDirectory);
  append_u16(bytes_, 0);  // number of this disk
  append_u16(bytes_, 0);  // number of the disk with the directory
  append_u16(bytes_, static_cast<std::uint16_t>(entries_.size()));
  append_u16(bytes_, static_cast<std::uint16_t>(entries_.size()));
  append_u32(bytes_, static_cast<std::uint32_t>(size));
  append_u32(bytes_, static_cast<std::uint32_t>(directory));
  append_u16(bytes_, 0);  // length of the comment
  return std::move(bytes_);
}

Result<std::vector<std::string>> zipped_names(std::string_view archive) {
  const auto list = directory_of(archive);
  if (!list) return list.error();
  std::vector<std::string> names;
  for (const Listed& file : *list) names.push_back(file.name);
  return names;
}

Result<std::string> unzipped(std::string_view archive, std::string_view name, std::size_t most) {
  const auto list = directory_of(archive);
  if (!list) return list.error();
  const auto file = std::find_if(list->begin(), list->end(),
                                 [&](const Listed& listed) { return listed.name == name; });
  GW_EXPECTS(file != list->end());
  const auto no_file = [&](std::string_view why) {
    return no_zip(fmt::format("the file {} in the archive {}", printable(file->name, 60), why));
  };
  if ((file->flags & 1U) != 0) return no_file("is encrypted; compress it without a password");
  if (file->size > most) return no_file(fmt::format("has more than {} bytes, the limit", most));
  if (file->method != 0 && file->method != kDeflate)
    return no_file("is compressed by another method than deflate; compress it as ZIP");
  const Error damaged = no_file("is damaged; copy the archive again");
  const std::size_t at = file->offset;
  if (at + kLocalLength > archive.size() || u32_at(archive, at) != kLocalHeader) return damaged;
  const std::size_t begin = at + kLocalLength + u16_at(archive, at + 26) + u16_at(archive, at + 28);
  if (begin + file->packed > archive.size()) return damaged;
  const std::string_view packed = archive.substr(begin, file->packed);
  std::string content =
      file->method == kDeflate ? inflated(packed, file->size) : std::string(packed);
  if (content.size() != file->size || crc32_of(content) != file->crc) return damaged;
  return content;
}

}  // namespace gearwright
