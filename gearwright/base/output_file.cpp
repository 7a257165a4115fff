#include "gearwright/base/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace gearwright {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, int error) {
  throw IoError("cannot write " + path.string() + ": " + std::strerror(error));
}

fs::path beside(const fs::path& path) {
  // Same folder, so that the rename stays on one file system; the process id keeps two runs apart.
  return path.parent_path() / ("." + path.filename().string() + "." + std::to_string(::getpid()) + ".part");
}

void rename_into_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    std::error_code ignored;
    fs::remove(from, ignored);
    throw IoError("cannot write " + to.string() + ": " + error.message());
  }
}

}  // namespace

void write_file(const fs::path& path, std::string_view content) {
  const fs::path part = beside(path);
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail(path, errno);
  int error = 0;
  while (!content.empty() && error == 0) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0) {
      if (errno != EINTR) error = errno;
    } else {
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  if (::close(file) != 0 && error == 0) error = errno;
  if (error != 0) {
    ::unlink(part.c_str());
    fail(path, error);
  }
  rename_into_place(part, path);
}

void write_file_by(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const fs::path part = beside(path);
  try {
    write(part);
  } catch (...) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw;
  }
  if (!fs::exists(part)) throw IoError("cannot write " + path.string() + ": nothing was written");
  rename_into_place(part, path);
}

}  // namespace gearwright
