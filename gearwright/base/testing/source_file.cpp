#include "gearwright/base/testing/source_file.hpp"

namespace gearwright::testing {

std::string source_file(const std::string& path) { return GW_SOURCE_DIR "/" + path; }

}  // namespace gearwright::testing
