#include "gearwright/base/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "gearwright/base/printable.hpp"
#include "gearwright/base/system.hpp"

namespace gearwright {

namespace fs = std::filesystem;

namespace {

std::string message_of(std::string_view what, const fs::path& path, int code,
                       std::string_view reason, std::string_view advice) {
  const std::string why(reason.empty() ? std::string_view(std::strerror(code)) : reason);
  constexpr std::size_t kLongest = 4096;  // no system has longer paths
  return std::string(what) + " " + printable(native_text(path), kLongest) + ": " + why +
         std::string(advice);
}

[[noreturn]] void fail(const fs::path& path, int error) {
  throw IoError("cannot write", path, error);
}

fs::path beside(const fs::path& path) {
  // The temporary file is in the same folder, so renaming stays on one file system. The process id
  // gives each run its own file.
  return path.parent_path() /
         ("." + path.filename().string() + "." + std::to_string(process_id()) + ".part");
}

void rename_into_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    std::error_code ignored;
    fs::remove(from, ignored);
    throw IoError("cannot write", to, error.default_error_condition().value(), error.message());
  }
}

// The file that write_file() creates or replaces. If the given path is a link, this is the target
// of the link, so that the link is kept.
struct Target {
  fs::path path;
  bool straight;  // true if the path is a device or a pipe. It is then written directly, because
                  // renaming would replace it by a regular file.
};

Target target_of(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);  // status of the target of a link
  if (fs::is_directory(status)) fail(path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) return {path, true};
  return {fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path, false};
}

}  // namespace

IoError::IoError(std::string_view what, fs::path path, int code, std::string_view reason,
                 std::string_view advice)
    : std::runtime_error(message_of(what, path, code, reason, advice)),
      path_(std::move(path)),
      code_(code) {}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw IoError("cannot make the folder", folder, error.default_error_condition().value(),
                  error.message(), "; --out selects another folder");
}

void write_file(const fs::path& path, std::string_view content) {
  const Target target = target_of(path);
  const fs::path part = target.straight ? target.path : beside(target.path);
  FileHandle file = FileHandle::create(part);
  if (!file.is_open()) fail(path, file.error());
  int error = file.write(content);
  if (const int closing = file.close(); error == 0) error = closing;
  if (error != 0) {
    std::error_code ignored;
    if (!target.straight) fs::remove(part, ignored);
    fail(path, error);
  }
  if (!target.straight) rename_into_place(part, target.path);
}

void write_file_by(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const Target target = target_of(path);
  if (target.straight)
    throw IoError("cannot write " + native_text(path) + ": it is a device or a pipe");
  const fs::path part = beside(target.path);
  try {
    write(part);
  } catch (...) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw;
  }
  if (!fs::exists(part))
    throw IoError("cannot write " + native_text(path) + ": nothing was written");
  rename_into_place(part, target.path);
}

}  // namespace gearwright
