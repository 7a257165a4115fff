#include "gearwright/store/chunk_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/little_endian.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/packing.hpp"
#include "gearwright/base/system.hpp"

namespace gearwright {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kChunkMagic = "GWCHUNK1";
constexpr std::string_view kEnding = ".chunk";
constexpr std::string_view kPart = ".part.";
constexpr std::size_t kHeader = 56;  // length of the header in bytes, without the counts by
                                     // constraint
constexpr std::size_t kMaxHeader = kHeader + 8 * kMaxConstraints;
constexpr auto kStaleAfter = std::chrono::hours(24);

[[noreturn]] void fail(const char* what, const fs::path& path, const std::string& why) {
  throw IoError(fmt::format("cannot {} {}: {}", what, native_text(path), why));
}

[[noreturn]] void fail(const char* what, const fs::path& path, int error) {
  fail(what, path, std::string(std::strerror(error)));
}

void append_i64(std::string& out, std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  append_u32(out, static_cast<std::uint32_t>(bits & 0xffffffffU));
  append_u32(out, static_cast<std::uint32_t>(bits >> 32U));
}

std::int64_t i64_at(std::string_view bytes, std::size_t at) {
  const std::uint64_t high = u32_at(bytes, at + 4);
  return static_cast<std::int64_t>((high << 32U) | u32_at(bytes, at));
}

std::string header(std::uint32_t stamp, std::int64_t chunk, std::string_view payload,
                   const ChunkCounts& counts) {
  std::string out(kChunkMagic);
  append_u32(out, stamp);
  append_i64(out, chunk);
  append_i64(out, counts.tested);
  append_i64(out, counts.feasible);
  append_u32(out, static_cast<std::uint32_t>(counts.rejected.size()));
  for (const std::int64_t n : counts.rejected) append_i64(out, n);
  append_i64(out, static_cast<std::int64_t>(payload.size()));
  append_u32(out, crc32_of(payload));
  append_u32(out, crc32_of(out));
  return out;
}

ChunkRead broken(std::string damage) {
  return {ChunkRead::State::damaged, std::move(damage), {}, 0, {}};
}

std::string name_of(std::int64_t chunk) { return fmt::format("{:06d}{}", chunk, kEnding); }

std::optional<std::int64_t> number(std::string_view text) {
  const auto value = whole_number(text);
  return value && *value >= 0 ? value : std::nullopt;
}

std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  if (error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory) {
    return found;
  }
  while (!error && entry != fs::directory_iterator()) {
    found.push_back(entry->path());
    entry.increment(error);
  }
  if (error) fail("read", folder, error.message());
  return found;
}

// Returns the name of this host with _ in place of /, which file names do not allow.
std::string host_in_names() {
  std::string host = host_name();
  std::replace(host.begin(), host.end(), '/', '_');
  return host;
}

// True if the process that wrote a file has ended. `owner` is HOST.PID. The result is false for a
// process of another host, because its state cannot be determined.
bool owner_is_dead(std::string_view owner, std::string_view host) {
  const std::size_t dot = owner.rfind('.');
  if (dot == std::string_view::npos || owner.substr(0, dot) != host) return false;
  const auto process = number(owner.substr(dot + 1));
  return process && *process > 0 && process_has_ended(static_cast<long>(*process));
}

bool is_old(const fs::path& path) {
  std::error_code error;
  const auto written = fs::last_write_time(path, error);
  return !error && fs::file_time_type::clock::now() - written > kStaleAfter;
}

}  // namespace

bool path_exists(const fs::path& path) {
  std::error_code error;
  const bool found = fs::exists(path, error);
  if (error && error != std::errc::not_a_directory) fail("read", path, error.message());
  return found;
}

ChunkFolder::ChunkFolder(fs::path folder, std::uint32_t stamp)
    : folder_(std::move(folder)), stamp_(stamp), host_(host_in_names()) {}

fs::path ChunkFolder::path(std::int64_t chunk) const { return folder_ / name_of(chunk); }

bool ChunkFolder::there(std::int64_t chunk) const { return path_exists(path(chunk)); }

std::vector<std::int64_t> ChunkFolder::list() const {
  std::vector<std::int64_t> chunks;
  for (const fs::path& entry : entries(folder_)) {
    const std::string name = entry.filename().string();
    const auto chunk = number(std::string_view(name).substr(0, name.find('.')));
    if (chunk && name == name_of(*chunk)) chunks.push_back(*chunk);
  }
  std::sort(chunks.begin(), chunks.end());
  // If files are renamed into a folder while it is read, a name may appear twice.
  chunks.erase(std::unique(chunks.begin(), chunks.end()), chunks.end());
  return chunks;
}

std::optional<ChunkRead> ChunkFolder::read(std::int64_t chunk, Depth depth) const {
  const fs::path place = path(chunk);
  FileHandle file = FileHandle::open_to_read(place);
  if (!file.is_open()) {
    if (file.error() == ENOENT || file.error() == ENOTDIR) return std::nullopt;
    fail("read", place, file.error());
  }
  std::uint64_t length = 0;
  std::string bytes;
  int error = file.size(length);
  if (error == 0)
    error = file.read(
        depth == Depth::payload ? length : std::min<std::uint64_t>(length, kMaxHeader), bytes);
  if (error != 0) fail("read", place, error);

  if (bytes.size() < kHeader) return broken(fmt::format("is only {} bytes long", length));
  if (bytes.compare(0, kChunkMagic.size(), kChunkMagic) != 0) return broken("is not a chunk file");
  const std::size_t constraints = u32_at(bytes, 36);
  if (constraints > kMaxConstraints) return broken("has a wrong checksum in its header");
  const std::size_t start = kHeader + 8 * constraints;
  if (bytes.size() < start) return broken(fmt::format("is only {} bytes long", length));
  if (crc32_of(std::string_view(bytes).substr(0, start - 4)) != u32_at(bytes, start - 4)) {
    return broken("has a wrong checksum in its header");
  }
  const std::int64_t size = i64_at(bytes, start - 16);
  const auto due = start + static_cast<std::size_t>(size);
  if (length != due)
    return broken(fmt::format("is {} bytes long instead of {} bytes", length, due));
  if (u32_at(bytes, 8) != stamp_) {
    return ChunkRead{ChunkRead::State::foreign, "belongs to another search", {}, 0, {}};
  }
  if (i64_at(bytes, 12) != chunk)
    return broken(fmt::format("contains chunk {}, which does not match the name of the file",
                              i64_at(bytes, 12)));

  ChunkRead found;
  found.counts.tested = i64_at(bytes, 20);
  found.counts.feasible = i64_at(bytes, 28);
  for (std::size_t i = 0; i < constraints; ++i) {
    found.counts.rejected.push_back(i64_at(bytes, 40 + 8 * i));
  }
  found.size = size;
  if (depth == Depth::header) return found;
  const std::uint32_t sum = u32_at(bytes, start - 8);
  bytes.erase(0, start);
  if (bytes.size() != static_cast<std::size_t>(size) || crc32_of(bytes) != sum) {
    return broken("has a wrong checksum");
  }
  found.payload = std::move(bytes);
  return found;
}

void ChunkFolder::write(std::int64_t chunk, std::string_view payload,
                        const ChunkCounts& counts) const {
  GW_EXPECTS(counts.rejected.size() <= kMaxConstraints);
  const fs::path place = path(chunk);
  const std::string head = header(stamp_, chunk, payload, counts);
  // The first free name is used, because another thread may be writing the same chunk, and a dead
  // process may have had the same process id.
  std::string part;
  FileHandle file;
  for (int n = 0; !file.is_open(); ++n) {
    part = fmt::format("{}.{}{}{}.{}", place.string(), n, kPart, host_, process_id());
    file = FileHandle::create_new(part);
    if (!file.is_open() && file.error() != EEXIST) fail("write", place, file.error());
  }
  int error = file.write(head);
  if (error == 0) error = file.write(payload);
  // The file is closed before it is renamed, because a network file system shows the bytes of a
  // file to other hosts only after the file is closed.
  if (const int closing = file.close(); error == 0) error = closing;
  std::error_code renaming, ignored;
  if (error == 0) fs::rename(part, place, renaming);
  if (error == 0 && !renaming) return;
  fs::remove(part, ignored);
  if (error != 0) fail("write", place, error);
  fail("write", place, renaming.message());
}

void ChunkFolder::set_aside(std::int64_t chunk) const {
  const fs::path place = path(chunk);
  std::error_code error;
  fs::rename(place, place.string() + ".damaged", error);
  if (error) fail("rename", place, error.message());
}

void ChunkFolder::remove_stale_parts() const {
  for (const fs::path& entry : entries(folder_)) {
    const std::string name = entry.filename().string();
    const std::size_t part = name.find(kPart);
    if (part == std::string::npos || name.find(kEnding) > part) continue;
    const std::string_view owner = std::string_view(name).substr(part + kPart.size());
    // An error is ignored, because a file that cannot be removed only occupies space.
    std::error_code ignored;
    if (owner_is_dead(owner, host_) || is_old(entry)) fs::remove(entry, ignored);
  }
}

}  // namespace gearwright
