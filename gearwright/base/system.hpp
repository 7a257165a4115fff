// The functions that differ among operating systems: open files, processes, the console.
//
// No other file includes a header of an operating system. Internal to base/, store/, job/ and the
// programs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gearwright {

/// An open file, which the destructor closes. Failures are returned as error numbers (errno); 0
/// means success.
class FileHandle {
 public:
  /// Creates a file for writing. An existing file is emptied.
  static FileHandle create(const std::filesystem::path& path);
  /// Creates a file for writing. The call fails with EEXIST if the file exists.
  static FileHandle create_new(const std::filesystem::path& path);
  static FileHandle open_to_read(const std::filesystem::path& path);

  FileHandle() = default;
  FileHandle(FileHandle&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)), error_(other.error_) {}
  FileHandle& operator=(FileHandle&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    std::swap(error_, other.error_);
    return *this;
  }
  ~FileHandle() { close(); }

  bool is_open() const { return descriptor_ >= 0; }
  /// The error number if opening failed, otherwise 0.
  int error() const { return error_; }

  int write(std::string_view bytes);
  /// Reads `most` bytes, or fewer at the end of the file.
  int read(std::size_t most, std::string& bytes);
  int size(std::uint64_t& bytes) const;
  /// Closes the file. Some file systems report a full disk only here. A second call does nothing.
  int close();

 private:
  FileHandle(int descriptor, int error) : descriptor_(descriptor), error_(error) {}

  int descriptor_ = -1;
  int error_ = 0;
};

long process_id();
/// True if process `id` of this host has ended, false if it runs or its state cannot be determined.
bool process_has_ended(long id);
/// The name of this host, or "unnamed" if the system has none.
std::string host_name();

bool is_terminal(std::FILE* stream);

/// A path with the separators of this system, in UTF-8.
std::string native_text(std::filesystem::path path);

/// Prepares the process and returns the arguments of the program in UTF-8, without the program
/// name. After the call, output is also in UTF-8, and writing beyond the file size limit returns an
/// error instead of ending the program.
std::vector<std::string> start_program(int argc, char** argv);

}  // namespace gearwright
