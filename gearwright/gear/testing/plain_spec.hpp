// Makes a spec from the numbers that most tests vary.
#pragma once

#include "gearwright/gear/gear.hpp"

namespace gearwright::testing {

struct PlainSpec {
  int teeth;
  double module;
  double beta_deg = 0.0;
  double x = 0.0;
  double face_width;
};

inline CylindricalSpec plain_spec(const PlainSpec& p) {
  CylindricalSpec s;
  s.teeth = p.teeth;
  s.normal_module = p.module;
  s.helix_angle = Angle::degrees(p.beta_deg);
  s.profile_shift = p.x;
  s.face_width = p.face_width;
  return s;
}

}  // namespace gearwright::testing
