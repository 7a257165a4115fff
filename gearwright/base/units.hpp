// Conversions between the internal units (mm, rad) and the units of drawings, files and users.
//
// The name of a constant has the form target unit per source unit: x rad are x * kDegPerRad
// degrees, and c µm are c * kMmPerUm mm. Because 1/1000 is not exact in double, x * kMmPerUm and
// x / kUmPerMm may differ in the last bit, so both constants exist.
#pragma once

#include <numbers>

namespace gearwright {

inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;
inline constexpr double kDegPerRad = 180.0 / std::numbers::pi;
inline constexpr double kArcsecPerDeg = 3600.0;
inline constexpr double kRadPerArcsec = kRadPerDeg / kArcsecPerDeg;  // 4.8e-6
inline constexpr double kArcsecPerRad = kArcsecPerDeg * kDegPerRad;  // 206265

inline constexpr double kMmPerInch = 25.4;
inline constexpr double kUmPerMm = 1e3;
inline constexpr double kMmPerM = 1e3;
inline constexpr double kMmPerUm = 1e-3;
inline constexpr double kMetresPerMm = 1e-3;

// Convert torques between N m, the unit of users and files, and N mm, the internal unit.

constexpr double newton_metres(double torque) { return torque / kMmPerM; }
constexpr double from_newton_metres(double torque_Nm) { return torque_Nm * kMmPerM; }

}  // namespace gearwright
