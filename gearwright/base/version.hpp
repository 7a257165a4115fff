// The version in reports, files and `--version`; the build compares it with that of CMake.
#pragma once

namespace gearwright {

inline constexpr const char* kVersion = "0.1.0";

}  // namespace gearwright
