#include "gearwright/base/testing/scratch_folder.hpp"

#include <stdlib.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace gearwright::testing {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  // mkdtemp fills in the six last characters.
  std::string name = (fs::temp_directory_path() / "gearwright_").string() + std::string(6, 'X');
  if (::mkdtemp(name.data()) == nullptr)
    throw fs::filesystem_error("no scratch folder", name, {errno, std::generic_category()});
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;  // a test may have removed the write permission
  fs::permissions(path_, fs::perms::owner_all, error);
  fs::remove_all(path_, error);
}

}  // namespace gearwright::testing
