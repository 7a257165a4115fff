// Angle: a strong type for radians. Public interfaces take an Angle, and formulas inside use rad().
#pragma once

#include <cmath>

#include "gearwright/base/units.hpp"

namespace gearwright {

class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle radians(double value) { return Angle(value); }
  static constexpr Angle degrees(double value) { return Angle(value * kRadPerDeg); }
  static constexpr Angle arcseconds(double value) { return Angle(value * kRadPerArcsec); }
  constexpr double rad() const { return rad_; }
  /// The angle in degrees. A value given with at most ten decimals is returned as given: 60°,
  /// not 59.99999999999999°. This is possible below 1e5°, where the number of units of 1e-10°
  /// is at most 1e15 and a double holds it exactly. Angles of 1e5° and more are not rounded.
  constexpr double deg() const {
    constexpr double kDecimals = 1e10;
    const double x = rad_ * kDegPerRad;
    if (!(x > -1e5 && x < 1e5) || x == 0.0) return x;
    const double units = x * kDecimals + (x < 0.0 ? -0.5 : 0.5);
    const double given = static_cast<double>(static_cast<long long>(units)) / kDecimals;
    return given * kRadPerDeg == rad_ ? given : x;
  }
  constexpr double arcsec() const { return rad_ * kArcsecPerRad; }
  constexpr Angle operator-() const { return Angle(-rad_); }
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.rad_ + b.rad_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.rad_ - b.rad_); }
  friend constexpr Angle operator*(double k, Angle a) { return Angle(k * a.rad_); }
  friend constexpr Angle operator/(Angle a, double k) { return Angle(a.rad_ / k); }
  constexpr Angle& operator+=(Angle a) { return *this = *this + a; }
  friend Angle abs(Angle a) { return Angle(std::abs(a.rad_)); }
  friend constexpr bool operator==(Angle a, Angle b) = default;
  friend constexpr auto operator<=>(Angle a, Angle b) = default;

 private:
  constexpr explicit Angle(double rad) : rad_(rad) {}
  double rad_ = 0.0;
};

/// Converts an angle in rad to degrees, as Angle::deg().
constexpr double deg(double rad) { return Angle::radians(rad).deg(); }

namespace literals {
constexpr Angle operator""_deg(long double value) {
  return Angle::degrees(static_cast<double>(value));
}
constexpr Angle operator""_deg(unsigned long long value) {
  return Angle::degrees(static_cast<double>(value));
}
}  // namespace literals

struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine of the turn 2π k/n [T1.4] for integers k and n.
///
/// Accuracy  the quarter turns are exact ({0,1}, {1,0}, {0,-1}, {-1,0}). k and k + n give the same
///           bits, because k is reduced as an integer into the first eighth of the turn
/// Domain    n ≥ 1 (contract)
SinCos sincos_turn(long long k, long long n);

}  // namespace gearwright
