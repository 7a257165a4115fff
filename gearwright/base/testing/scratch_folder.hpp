// A folder of a test's own, gone with it: two builds may be tested at once.
#pragma once

#include <filesystem>

namespace gearwright::testing {

class ScratchFolder {
 public:
  /// Throws  std::filesystem::filesystem_error
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace gearwright::testing
