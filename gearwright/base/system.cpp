#include "gearwright/base/system.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gearwright {

namespace {

int open_file(const std::filesystem::path& path, int flags) {
  return ::open(path.c_str(), flags | O_CLOEXEC, 0666);
}

// Makes the allocator keep freed memory. By default, glibc returns large blocks to the system
// at once. The system must then provide their pages again, which took a third of the time of
// loaded contact.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMegabyte = 1 << 20;
  ::mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);  // the greatest value that glibc accepts
  ::mallopt(M_TRIM_THRESHOLD, 1024 * kMegabyte);
  ::mallopt(M_TOP_PAD, 16 * kMegabyte);
#endif
}

}  // namespace

FileHandle FileHandle::create(const std::filesystem::path& path) {
  const int file = open_file(path, O_WRONLY | O_CREAT | O_TRUNC);
  return {file, file < 0 ? errno : 0};
}

FileHandle FileHandle::create_new(const std::filesystem::path& path) {
  const int file = open_file(path, O_WRONLY | O_CREAT | O_EXCL);
  return {file, file < 0 ? errno : 0};
}

FileHandle FileHandle::open_to_read(const std::filesystem::path& path) {
  const int file = open_file(path, O_RDONLY);
  return {file, file < 0 ? errno : 0};
}

int FileHandle::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

int FileHandle::read(std::size_t most, std::string& bytes) {
  bytes.assign(most, '\0');
  std::size_t have = 0;
  while (have < most) {
    const ssize_t got = ::read(descriptor_, bytes.data() + have, most - have);
    if (got == 0) break;
    if (got > 0) {
      have += static_cast<std::size_t>(got);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  bytes.resize(have);
  return 0;
}

int FileHandle::size(std::uint64_t& bytes) const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) return errno;
  bytes = static_cast<std::uint64_t>(status.st_size);
  return 0;
}

int FileHandle::close() {
  if (descriptor_ < 0) return 0;
  return ::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno;
}

long process_id() { return ::getpid(); }

bool process_has_ended(long id) { return ::kill(static_cast<pid_t>(id), 0) != 0 && errno == ESRCH; }

std::string host_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "unnamed";
}

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) != 0; }

std::string native_text(std::filesystem::path path) { return path.make_preferred().string(); }

std::vector<std::string> start_program(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);
  keep_freed_memory();
  return {argv + 1, argv + argc};
}

}  // namespace gearwright
