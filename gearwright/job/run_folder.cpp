// Writes the folder of `run`. The folder contains a list of the files of a run with their sizes and
// checksums. The next run removes the files of this list that it does not write itself. If the user
// has changed or replaced a file, the file is kept.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/packing.hpp"
#include "gearwright/base/system.hpp"
#include "gearwright/job/files.hpp"

namespace gearwright {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRunList = ".gearwright_files";
constexpr const char* kHeading =
    "Files written by the last run of gearwright, with checksum, number of bytes and name. The "
    "next run\nremoves each file of this list that it does not write again, unless the file was "
    "changed.\n";

struct Listed {
  unsigned long checksum = 0;
  std::size_t bytes = 0;
  std::string name;
};

std::vector<Listed> read_list(const fs::path& folder) {
  std::vector<Listed> list;
  std::ifstream file(folder / kRunList);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    Listed l;
    words >> std::hex >> l.checksum >> std::dec >> l.bytes;
    if (!words || !std::getline(words >> std::ws, l.name)) continue;
    // A name with a path is ignored, so that no file outside the folder is removed.
    if (fs::path(l.name).filename() == l.name && l.name != "." && l.name != "..") list.push_back(l);
  }
  return list;
}

bool as_written(const fs::path& path, const Listed& was) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(path, error)) ||
      fs::file_size(path, error) != was.bytes)
    return false;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return file && crc32_of(bytes.str()) == was.checksum;
}

}  // namespace

void write_run_into(const fs::path& folder, const std::vector<JobFile>& files,
                    const FileOptions& options) {
  if (options.progress) options.progress->begin_writing();
  make_folder(folder);
  const std::vector<Listed> former = read_list(folder);
  std::string list = kHeading;
  for (const JobFile& f : files) {
    list += fmt::format("{:08x} {} {}\n", crc32_of(f.bytes), f.bytes.size(),
                        f.path.filename().string());
  }
  write_files(files);
  // The old list stays valid until the new list is written. If the program stops before that, the
  // next run removes the files of the old list.
  for (const Listed& was : former) {
    const bool again = std::any_of(files.begin(), files.end(),
                                   [&](const JobFile& f) { return f.path.filename() == was.name; });
    std::error_code error;
    if (!again && as_written(folder / was.name, was)) fs::remove(folder / was.name, error);
    if (error)
      throw IoError("cannot remove " + native_text(folder / was.name) + ": " + error.message());
  }
  write_file(folder / kRunList, list);
}

}  // namespace gearwright
