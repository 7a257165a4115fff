#include "gearwright/pair/mounted_gears.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace gearwright {

double MountedGears::whole_face(double face) const {
  return std::max(gears[0].whole_face(face), gears[1].whole_face(face));
}

double MountedGears::gear_ratio() const {
  return static_cast<double>(gears[1].spec.teeth) / gears[0].spec.teeth;
}

Pose<Housing, Gear1> MountedGears::pose_1() const {
  // Tooth 0 points to the mesh, which is at +x for external pairs and at −x for internal pairs.
  return {Vec3::Zero(), Mat3(Vec3(side(), side(), 1.0).asDiagonal())};
}

Pose<Housing, Gear2> MountedGears::pose_2() const {
  // Space 0 is half a pitch from tooth 0 and points to −x, where the mesh is.
  const int z2 = std::abs(gears[1].spec.teeth);
  const SinCos t = sincos_turn(z2 - 1, 2LL * z2);
  const double s = std::sin(axis_angle().rad());
  const double c = std::cos(axis_angle().rad());
  return {Vec3(center_distance, 0.0, 0.0),
          Mat3{{t.cos, -t.sin, 0.0}, {c * t.sin, c * t.cos, s}, {-s * t.sin, -s * t.cos, c}}};
}

}  // namespace gearwright
