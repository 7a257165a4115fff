// A typical first program with the installed library: two gears, their pair, a solid.
#include <cmath>
#include <cstdio>

#include <gearwright/gearwright.hpp>

int main() {
  using namespace gearwright;
  const CylindricalSpec pinion{
      .teeth = 17, .normal_module = 2.5, .profile_shift = 0.3, .face_width = 25};
  CylindricalSpec wheel = pinion;
  wheel.teeth = 43;
  wheel.profile_shift = 0.0;
  auto gear_1 = make_gear(pinion);
  auto gear_2 = make_gear(wheel);
  if (!gear_1 || !gear_2) return 1;
  const double alpha = pinion.normal_pressure_angle.rad();
  const double a = tight_center_distance(17, 43, 2.5, alpha, alpha, 1.0, 0.3);
  const auto pair = mount(*gear_1, *gear_2, {a});
  if (!pair) {
    std::fprintf(stderr, "%s\n", pair.error().message().c_str());
    return 1;
  }
  std::printf("a %.6f mm, contact ratio %.6f, root form diameter %.6f mm\n",
              pair->center_distance(), pair->contact_ratio(),
              2 * gear_1->root_form_radius().value());

  const ToothedBody body{"pinion", gear_1->tooth->outline, gear_1->twist(), 25.0, std::nullopt, {}};
  const auto mesh = tessellate(body);
  const auto solid = step_document({body}, "pinion.step");
  const auto touching = contact(*pair, {.crossing = Angle::radians(1e-4)});
  const auto bad = make_gear({.teeth = 17, .normal_module = -1.0, .face_width = 5});
  const bool good = std::abs(pair->involute()->mesh.backlash.normal_base) < 1e-12 && mesh &&
                    solid && touching && !bad && bad.error().field == "normal_module";
  return good ? 0 : 1;
}
