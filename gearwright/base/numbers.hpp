// Constants used in formulas, and the sign of a number of teeth.
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

/// The sign σ of z, +1 for external and −1 for internal teeth. The product of σ and the radius
/// increases from root to tip.
template <class T = double>
constexpr T side_of(int teeth) {
  return teeth < 0 ? T(-1) : T(1);
}

}  // namespace gearwright
