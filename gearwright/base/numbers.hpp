// Constants used in formulas.
#pragma once

#include <limits>
#include <numbers>

namespace gearwright {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kHalfPi = std::numbers::pi / 2;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// NaN. In samples, series and inner loops, it is the value of a quantity that was not
/// computed. Elsewhere, such a quantity is an empty std::optional.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace gearwright
