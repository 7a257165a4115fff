// The positions of two gears in the housing, with errors.
//
// Housing.  Without errors, axis 1 is the z axis. Axis 2 passes through (C, 0, 0), C = C_0 + ΔC, in
// the direction (0, sin Σ, cos Σ). Gear 1 turns by −φ_1 (clockwise seen from +z), and gear 2 turns
// by +φ_2 about its own +z. With all errors:  r_f = R_x(Δγ) R_y(Δδ) R_z(−φ_1) r_1 + (0, 0, Δz)
//
//   R_x(γ) = [1 0 0; 0 c s; 0 −s c]   crossing: +z goes to +y
//   R_y(δ) = [c 0 s; 0 1 0; −s 0 c]   intersecting: +z goes to +x, towards gear 2
#pragma once

#include <cmath>

#include "tests/oracle/flank_surface.hpp"

namespace gearwright::oracle::tca {

struct Mounting {
  Real center_distance = 0;  ///< C_0
  Real shaft_angle = 0;      ///< Σ
  Real d_center = 0;         ///< ΔC
  Real crossing = 0;         ///< Δγ
  Real intersecting = 0;     ///< Δδ
  Real axial = 0;            ///< Δz
};

/// r_f = turn · r + shift
struct Frame {
  Matrix3 turn;
  Vector3 shift;
};

inline Matrix3 crossed(Real angle) {
  const Real c = std::cos(angle), s = std::sin(angle);
  Matrix3 m;
  m << 1, 0, 0, 0, c, s, 0, -s, c;
  return m;
}

inline Matrix3 tilted(Real angle) {
  const Real c = std::cos(angle), s = std::sin(angle);
  Matrix3 m;
  m << c, 0, s, 0, 1, 0, -s, 0, c;
  return m;
}

inline Frame frame_1(const Mounting& m, Real rotation_1) {
  return {crossed(m.crossing) * tilted(m.intersecting) * turn_about_z(-rotation_1),
          Vector3(0, 0, m.axial)};
}

inline Frame frame_2(const Mounting& m, Real rotation_2) {
  return {crossed(m.shaft_angle) * turn_about_z(rotation_2),
          Vector3(m.center_distance + m.d_center, 0, 0)};
}

}  // namespace gearwright::oracle::tca
