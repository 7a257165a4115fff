// Output files appear whole or not at all: written beside their place, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gearwright {

/// The outside world failed: disk full, no permission. Exit status 3 in the program.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes `content` to `path`, whole or not at all.
/// Throws    IoError naming the path and the system's reason; nothing is left behind then
void write_file(const std::filesystem::path& path, std::string_view content);

/// For writers that want a path of their own (Parquet): calls `write` with a temporary path in the
/// same folder, then renames. Whatever `write` throws passes through after the temporary is
/// removed.
void write_file_by(const std::filesystem::path& path,
                   const std::function<void(const std::filesystem::path&)>& write);

}  // namespace gearwright
