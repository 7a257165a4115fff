// The version that reports, files and `--version` name; the build checks it against CMake's.
#pragma once

namespace gearwright {

inline constexpr const char* kVersion = "0.1.0";

}  // namespace gearwright
