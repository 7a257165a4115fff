#include "gearwright/store/chunk_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/little_endian.hpp"
#include "gearwright/base/output_file.hpp"

namespace gearwright {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kChunkMagic = "GWCHUNK1";
constexpr std::string_view kEnding = ".chunk";
constexpr std::string_view kPart = ".part.";
constexpr std::size_t kHeader = 56;  // without the counts by constraint
constexpr std::size_t kMaxHeader = kHeader + 8 * kMaxConstraints;
constexpr auto kStaleAfter = std::chrono::hours(24);

[[noreturn]] void fail(const char* what, const fs::path& path, int error) {
  throw IoError(fmt::format("cannot {} {}: {}", what, path.string(), std::strerror(error)));
}

void append_i64(std::string& out, std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  append_u32(out, static_cast<std::uint32_t>(bits & 0xffffffffU));
  append_u32(out, static_cast<std::uint32_t>(bits >> 32U));
}

std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) {
    value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
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
  append_u32(out, checksum(payload));
  append_u32(out, checksum(out));
  return out;
}

ChunkRead broken(std::string damage) {
  return {ChunkRead::State::damaged, std::move(damage), {}, 0, {}};
}

// An open file, closed at the end.
class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  int descriptor() const { return descriptor_; }
  // 0, or the system's error number. Some file systems report a full disk only here.
  int close() { return ::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno; }

 private:
  int descriptor_;
};

// 0, or the system's error number.
int write_all(const File& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.descriptor(), bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

// The next `most` bytes, fewer at the end of the file.
std::string read_some(const File& file, std::size_t most, const fs::path& path) {
  std::string bytes(most, '\0');
  std::size_t have = 0;
  while (have < most) {
    const ssize_t got = ::read(file.descriptor(), bytes.data() + have, most - have);
    if (got == 0) break;
    if (got > 0) {
      have += static_cast<std::size_t>(got);
    } else if (errno != EINTR) {
      fail("read", path, errno);
    }
  }
  bytes.resize(have);
  return bytes;
}

std::string name_of(std::int64_t chunk) { return fmt::format("{:06d}{}", chunk, kEnding); }

// The value of `text`, if the whole text is a number.
std::optional<std::int64_t> number(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
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
  if (error) fail("read", folder, error.value());
  return found;
}

std::string host_name() {
  char name[256] = {};
  if (::gethostname(name, sizeof name - 1) != 0) return "unnamed";
  std::string host(name);
  std::replace(host.begin(), host.end(), '/', '_');
  return host;
}

// `owner` is HOST.PID; a process of another host may be alive, which cannot be checked here.
bool owner_is_dead(std::string_view owner, std::string_view host) {
  const std::size_t dot = owner.rfind('.');
  if (dot == std::string_view::npos || owner.substr(0, dot) != host) return false;
  const auto process = number(owner.substr(dot + 1));
  return process && *process > 0 && ::kill(static_cast<pid_t>(*process), 0) != 0 && errno == ESRCH;
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
  if (error && error != std::errc::not_a_directory) fail("read", path, error.value());
  return found;
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

ChunkFolder::ChunkFolder(fs::path folder, std::uint32_t stamp)
    : folder_(std::move(folder)), stamp_(stamp), host_(host_name()) {}

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
  const File file(::open(place.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.descriptor() < 0) {
    if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
    fail("read", place, errno);
  }
  struct stat status {};
  if (::fstat(file.descriptor(), &status) != 0) fail("read", place, errno);
  const auto length = static_cast<std::size_t>(status.st_size);
  std::string bytes =
      read_some(file, depth == Depth::payload ? length : std::min(length, kMaxHeader), place);

  if (bytes.size() < kHeader) return broken(fmt::format("is only {} bytes long", length));
  if (bytes.compare(0, kChunkMagic.size(), kChunkMagic) != 0) return broken("is not a chunk");
  const std::size_t constraints = u32_at(bytes, 36);
  if (constraints > kMaxConstraints) return broken("has a wrong checksum in its header");
  const std::size_t start = kHeader + 8 * constraints;
  if (bytes.size() < start) return broken(fmt::format("is only {} bytes long", length));
  if (checksum(std::string_view(bytes).substr(0, start - 4)) != u32_at(bytes, start - 4)) {
    return broken("has a wrong checksum in its header");
  }
  const std::int64_t size = i64_at(bytes, start - 16);
  const auto due = start + static_cast<std::size_t>(size);
  if (length != due) return broken(fmt::format("is {} bytes long, not {}", length, due));
  if (u32_at(bytes, 8) != stamp_) {
    return ChunkRead{ChunkRead::State::foreign, "is of another search", {}, 0, {}};
  }
  if (i64_at(bytes, 12) != chunk) return broken(fmt::format("is chunk {}", i64_at(bytes, 12)));

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
  if (bytes.size() != static_cast<std::size_t>(size) || checksum(bytes) != sum) {
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
  // Another thread may write the same chunk, and a dead process may have had the same process id,
  // so the first free name is used.
  std::string part;
  int descriptor = -1;
  for (int n = 0; descriptor < 0; ++n) {
    part = fmt::format("{}.{}{}{}.{}", place.string(), n, kPart, host_, ::getpid());
    descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST) fail("write", place, errno);
  }
  File file(descriptor);
  int error = write_all(file, head);
  if (error == 0) error = write_all(file, payload);
  // The file is closed first, because only then does a network file system show its bytes to other
  // hosts.
  if (const int closing = file.close(); error == 0) error = closing;
  if (error == 0 && ::rename(part.c_str(), place.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(part.c_str());
    fail("write", place, error);
  }
}

void ChunkFolder::set_aside(std::int64_t chunk) const {
  const fs::path place = path(chunk);
  if (::rename(place.c_str(), (place.string() + ".damaged").c_str()) != 0) {
    fail("rename", place, errno);
  }
}

void ChunkFolder::remove_stale_parts() const {
  for (const fs::path& entry : entries(folder_)) {
    const std::string name = entry.filename().string();
    const std::size_t part = name.find(kPart);
    if (part == std::string::npos || name.find(kEnding) > part) continue;
    const std::string_view owner = std::string_view(name).substr(part + kPart.size());
    // A file that cannot be removed only occupies space.
    if (owner_is_dead(owner, host_) || is_old(entry)) ::unlink(entry.c_str());
  }
}

}  // namespace gearwright
