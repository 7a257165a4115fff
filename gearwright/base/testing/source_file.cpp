#include "gearwright/base/testing/source_file.hpp"

namespace gearwright::testing {

std::string source_file(const std::string& path) {
  return std::string(GW_SOURCE_DIR "/").append(path);
}

}  // namespace gearwright::testing
