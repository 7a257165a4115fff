// Constants of the oracles, independent of those of the engine.
#pragma once

#include <limits>
#include <numbers>

namespace gearwright::oracle {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180;  ///< rad
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline constexpr long double kLongPi = std::numbers::pi_v<long double>;
inline constexpr long double kLongDegree = kLongPi / 180;  ///< rad

}  // namespace gearwright::oracle
