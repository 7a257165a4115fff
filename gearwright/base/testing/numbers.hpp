// Constants used by the tests of many rooms.
#pragma once

#include <limits>

#include "gearwright/base/numbers.hpp"

namespace gearwright::testing {

inline constexpr double kDegree = kPi / 180;  ///< rad
inline constexpr double kEps = std::numeric_limits<double>::epsilon();

/// The constant is written in digits, because pi_v<long double> of libc++ 14 has only the precision
/// of a double.
inline constexpr long double kLongPi = 3.14159265358979323846264338327950288L;

}  // namespace gearwright::testing
