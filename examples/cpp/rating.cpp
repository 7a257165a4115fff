// A rating by ISO 6336: safety factors, and the torque for required safety factors.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  CylindricalSpec pinion{.teeth = 21, .normal_module = 4, .helix_angle = 15_deg, .face_width = 45};
  pinion.profile_shift = 0.35;
  CylindricalSpec wheel = pinion;
  wheel.teeth = 68;
  wheel.helix_angle = -15_deg;
  wheel.profile_shift = 0.1;
  const Result<Gear> gear_1 = make_gear(pinion);
  if (!gear_1) return fail(gear_1.error());
  const Result<Gear> gear_2 = make_gear(wheel);
  if (!gear_2) return fail(gear_2.error());
  const Result<Pair> pair = mount(*gear_1, *gear_2);
  if (!pair) return fail(pair.error());

  const Result<RatedPair> rated = rated_pair(*pair);
  if (!rated) return fail(rated.error());
  RatingInput input;
  input.torque = 480;  // N m on gear 1
  input.speed = 1480;  // 1/min, of gear 1
  input.application_factor = 1.25;
  input.life_h = 20000;
  input.viscosity = 220;  // mm2/s at 40 degrees Celsius
  input.quality = {6, 6};
  input.flank_roughness = {4, 4};   // um
  input.root_roughness = {16, 16};  // um
  input.face_load_factor = 1.2;
  input.materials = {*material_named("18CrNiMo7-6"), *material_named("18CrNiMo7-6")};
  const Result<Rating> rating = rate(*rated, input);
  if (!rating) return fail(rating.error());
  std::printf("safety against pitting        %.3f and %.3f\n", rating->S_H[0].value,
              rating->S_H[1].value);
  std::printf("safety against root breakage  %.3f and %.3f\n", rating->S_F[0].value,
              rating->S_F[1].value);
  const auto torque = torque_of_safety(*rated, input, {.flank = 1.1, .root = 1.4});
  if (torque) std::printf("torque with S_H 1.1, S_F 1.4  %.0f N m\n", *torque);
}

/* prints
safety against pitting        1.376 and 1.430
safety against root breakage  2.897 and 2.780
torque with S_H 1.1, S_F 1.4  844 N m
*/
