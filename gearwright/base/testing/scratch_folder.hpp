// A temporary folder of one test, removed when the test ends. Each test has its own folder, so two
// builds can be tested at the same time.
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
