// The backlash given in messages and verdicts, and the limit below which a backlash counts as none.
#pragma once

#include <algorithm>
#include <cmath>

namespace gearwright {

/// A normal backlash of a magnitude below this limit, mm, counts as no backlash for this module.
/// Drawings give centre distances in mm and profile shifts, both with four decimals. At a pressure
/// angle of 20°, rounding the distance changes j_n by at most 2 · 0.5e-4 tan α_wn = 3.6e-5 mm, and
/// rounding both shifts changes j_n by at most 4 · 0.5e-4 m_n tan α_n = 7.3e-5 m_n.
constexpr double no_backlash(double normal_module) {
  return std::max(0.5e-4, 1e-4 * normal_module);
}

struct StatedBacklash {
  double normal;           ///< j_n       mm
  double cos_angle;        ///< cos α_wn  j_bn = j_n cos α_wn
  double center_distance;  ///< a         mm
  double normal_module;    ///< m_n       mm
  bool none() const { return std::abs(normal) < no_backlash(normal_module); }
  bool negative() const { return normal <= -no_backlash(normal_module); }
  /// The smallest recommended j_n for iron or steel gears in an iron or steel housing, at speeds
  /// below 15 m/s.
  ///
  /// Formula   j_n = j_bn/cos α_wn, j_bn = 2/3 (0.06 + 0.0005 a + 0.03 m_n); ISO/TR 10064-2:1996,
  ///           annex A
  /// Units     mm
  double recommended() const {
    return 2.0 / 3.0 * (0.06 + 0.0005 * center_distance + 0.03 * normal_module) / cos_angle;
  }
  /// True if there is a backlash, but less than a quarter of the recommended one. The pitch, helix
  /// and runout deviations of a gear of grade 8 can take so much backlash.
  bool little() const { return !none() && !negative() && normal < 0.25 * recommended(); }
};

}  // namespace gearwright
