#include "gearwright/cad/zip.hpp"

#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/little_endian.hpp"
#include "gearwright/base/packing.hpp"

namespace gearwright {

namespace {

constexpr std::uint16_t kZipVersion = 20;  // 2.0, the first version that supports deflate
constexpr std::uint16_t kDeflate = 8;
constexpr std::uint16_t kMidnight = 0;
constexpr std::uint16_t kNewYear1980 = (1U << 5U) | 1U;  // year 0 since 1980, month 1, day 1
constexpr std::size_t kSizeMax = 0xfffffffeU;            // 0xffffffff would indicate ZIP64

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
  append_u32(bytes_, 0x04034b50U);
  append_common(entry);
  bytes_ += entry.name;
  bytes_ += packed;
  entries_.push_back(entry);
}

std::string ZipWriter::finish() && {
  const std::size_t directory = bytes_.size();
  for (const Entry& entry : entries_) {
    append_u32(bytes_, 0x02014b50U);
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
  append_u32(bytes_, 0x06054b50U);
  append_u16(bytes_, 0);  // number of this disk
  append_u16(bytes_, 0);  // number of the disk with the directory
  append_u16(bytes_, static_cast<std::uint16_t>(entries_.size()));
  append_u16(bytes_, static_cast<std::uint16_t>(entries_.size()));
  append_u32(bytes_, static_cast<std::uint32_t>(size));
  append_u32(bytes_, static_cast<std::uint32_t>(directory));
  append_u16(bytes_, 0);  // length of the comment
  return std::move(bytes_);
}

}  // namespace gearwright
