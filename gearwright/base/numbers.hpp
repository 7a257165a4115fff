// Constants used in formulas.
#pragma once

#include <limits>
#include <numbers>

namespace gearwright {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kHalfPi = std::numbers::pi / 2;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace gearwright
