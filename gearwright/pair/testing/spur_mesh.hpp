// The mesh of two spur gears with 20°, module 2 and no profile shift.
#pragma once

#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/pair/mesh.hpp"

namespace gearwright::testing {

inline constexpr double kAlpha = kPi / 9;  ///< 20°

/// r_b = z cos α, s_bt = d_b (π/(2z) ± inv α); z2 < 0: an internal gear.
inline MeshInput<double> spur(int z1, int z2) {
  MeshInput<double> in;
  in.gears[0].teeth = z1;
  in.gears[1].teeth = z2;
  in.gears[0].radius = z1 * std::cos(kAlpha);
  in.gears[1].radius = std::abs(z2) * std::cos(kAlpha);
  const double inv = involute(kAlpha);
  in.gears[0].tooth_thickness = 2 * in.gears[0].radius * (kPi / (2 * z1) + inv);
  in.gears[1].tooth_thickness =
      2 * in.gears[1].radius * (kPi / (2 * std::abs(z2)) + (z2 > 0 ? inv : -inv));
  in.tip_form_radius[0] = z1 + 2;
  in.tip_form_radius[1] = z2 > 0 ? z2 + 2 : -z2 - 2;
  in.face_width = {20.0, 20.0};
  in.center_distance = std::abs(z1 + z2);
  return in;
}

}  // namespace gearwright::testing
