// Output files appear completely or not at all, because a temporary file is written first and then
// renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string_view>

namespace gearwright {

/// A failure of the system, such as a full disk or a missing permission. The program then exits
/// with status 3.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// The error `code` of the system for a file. The message is `what`, the path, `reason` and
  /// `advice`. Without a reason, it is the text of the system for `code`.
  IoError(std::string_view what, std::filesystem::path path, int code, std::string_view reason = {},
          std::string_view advice = {});

  int code() const { return code_; }  ///< errno; 0 if the system gave none
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_{};
  int code_ = 0;
};

/// Makes a folder for output files, with its parents, unless it exists.
/// Throws    IoError naming the folder and the system's reason
void make_folder(const std::filesystem::path& folder);

/// Writes `content` to `path`, completely or not at all. A device or a pipe is written directly.
/// Throws    IoError naming the path and the system's reason; the temporary file is then removed
void write_file(const std::filesystem::path& path, std::string_view content);

/// Like write_file(), for writers that need a path (Parquet). The function calls `write` with a
/// temporary path in the same folder and then renames the file. If `write` throws an exception, the
/// temporary file is removed and the caller receives the exception.
/// Throws    IoError also if `path` is a device or a pipe, or if `write` makes no file
void write_file_by(const std::filesystem::path& path,
                   const std::function<void(const std::filesystem::path&)>& write);

}  // namespace gearwright
