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

// Convert between the power, the torque and the speed of a shaft, P = T ω and ω = 2π n/60, in kW,
// N m, rad/s and 1/min.

inline constexpr double kWattsPerKilowatt = 1e3;
inline constexpr double kSecondsPerMinute = 60.0;

constexpr double radians_per_second(double speed_rpm) {
  return speed_rpm * 2 * std::numbers::pi / kSecondsPerMinute;
}
constexpr double kilowatts(double torque_Nm, double speed_rpm) {
  return torque_Nm * speed_rpm * 2 * std::numbers::pi / kSecondsPerMinute / kWattsPerKilowatt;
}
constexpr double torque_of_power(double power_kW, double speed_rpm) {
  return power_kW * kWattsPerKilowatt / radians_per_second(speed_rpm);
}

}  // namespace gearwright
