#include "gearwright/pair/clearances.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/math/involute.hpp"

namespace gearwright {

std::array<double, 2> tip_clearances(const std::array<double, 2>& tip_radius,
                                     const std::array<double, 2>& root_radius,
                                     double center_distance, double side) {
  const double a = center_distance;
  if (side < 0.0) return {root_radius[1] - a - tip_radius[0], tip_radius[1] - a - root_radius[0]};
  return {a - tip_radius[0] - root_radius[1], a - tip_radius[1] - root_radius[0]};
}

double extended_center_distance(const Gear& gear_1, const Gear& gear_2) {
  const double sigma = gear_2.side();
  const double reference = (gear_2.reference_diameter + sigma * gear_1.reference_diameter) / 2;
  return reference + sigma * (gear_1.spec.profile_shift * gear_1.spec.normal_module +
                              gear_2.spec.profile_shift * gear_2.spec.normal_module);
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

std::optional<double> tip_that_clears(const InvolutePair& pair, int tip, double margin) {
  return tip_that_clears({&pair.gears[0], &pair.gears[1]}, pair.mesh, tip, margin);
}

std::optional<double> tip_that_clears(const std::array<const Gear*, 2>& gears,
                                      const Mesh<double>& mesh, int tip, double margin) {
  const std::size_t t = tip - 1;
  const Gear& mate = *gears[2 - static_cast<std::size_t>(tip)];
  const Gear& gear = *gears[t];
  const auto form = mate.root_form_radius();
  if (!form) return std::nullopt;
  const double base = mate.base_radius();
  const double start = roll_length(std::max(*form, base) + mate.side() * margin, base);
  const double rho = tip == 2 ? mesh.rho2(start)
                              : leaf::rho_1_where(mesh.base_tangent_distance, mesh.sigma,
                                                  start / mesh.base_cosine_ratio);
  if (!(rho > 0.0)) return std::nullopt;
  const double radius = std::hypot(gear.base_radius(), rho);
  const bool shorter = gear.side() * (radius - gear.actual_tip_radius()) < 0.0;
  return shorter ? std::optional(2 * radius) : std::nullopt;
}

}  // namespace gearwright
