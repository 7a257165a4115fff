// The version in reports, files and `--version`. The build compares it with the version in CMake.
#pragma once

namespace gearwright {

inline constexpr const char* kVersion = "0.1.0";

}  // namespace gearwright
