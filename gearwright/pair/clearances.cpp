#include "gearwright/pair/clearances.hpp"

#include <algorithm>
#include <cmath>

namespace gearwright {

std::array<double, 2> tip_clearances(const std::array<double, 2>& tip_radius,
                                     const std::array<double, 2>& root_radius,
                                     double center_distance, bool internal) {
  const double a = center_distance;
  if (internal) return {root_radius[1] - a - tip_radius[0], tip_radius[1] - a - root_radius[0]};
  return {a - tip_radius[0] - root_radius[1], a - tip_radius[1] - root_radius[0]};
}

std::array<std::optional<double>, 2> contact_root_radii(const MeshInput<double>& input,
                                                        const Mesh<double>& mesh) {
  const std::array<double, 2> rho{mesh.rho1_A, mesh.rho2(mesh.rho1_E)};
  std::array<std::optional<double>, 2> radii;
  for (std::size_t i = 0; i < 2; ++i)
    if (rho[i] >= -kNoCollision * normal_base_pitch(input.gears[0]))
      radii[i] = std::hypot(input.gears[i].radius, std::max(0.0, rho[i]));
  return radii;
}

}  // namespace gearwright
