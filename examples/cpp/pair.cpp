// Two gears in a housing: contact ratio, backlash, tip clearance and sliding.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  CylindricalSpec pinion{.teeth = 17, .normal_module = 2.5, .helix_angle = 15_deg};
  pinion.profile_shift = 0.3;
  pinion.thickness_allowance = -0.05;
  pinion.face_width = 25;
  CylindricalSpec wheel = pinion;
  wheel.teeth = 43;
  wheel.helix_angle = -15_deg;  // left hand
  wheel.profile_shift = 0.1;
  wheel.thickness_allowance = -0.07;

  const Result<Gear> gear_1 = make_gear(pinion);
  if (!gear_1) return fail(gear_1.error());
  const Result<Gear> gear_2 = make_gear(wheel);
  if (!gear_2) return fail(gear_2.error());
  const Result<Pair> pair = mount(*gear_1, *gear_2, {.center_distance = 78.6056});
  if (!pair) return fail(pair.error());

  const ParallelPair& teeth = *pair->parallel();  // null for any other kind of pair
  std::printf("free of backlash at  %.4f mm\n", teeth.backlash_free_center_distance.value());
  std::printf("contact ratio        %.4f\n", pair->contact_ratio());
  std::printf("normal backlash      %.4f mm\n", teeth.mesh.backlash.normal);
  std::printf("tip clearances       %.4f and %.4f mm\n", teeth.tip_clearance[0],
              teeth.tip_clearance[1]);
  std::printf("sliding at A         %.4f and %.4f\n", teeth.sliding_A.zeta_1.value(),
              teeth.sliding_A.zeta_2.value());
  std::printf("axial force          %.4f of the tangential\n", axial_force(teeth)[0]);
  for (const Warning& warning : pair->warnings()) std::printf("%s\n", warning.message.c_str());
}

/* prints
free of backlash at  78.4523 mm
contact ratio        2.2772
normal backlash      0.1214 mm
tip clearances       0.6810 and 0.6536 mm
sliding at A         -1.9340 and 0.6592
axial force          -0.2713 of the tangential
*/
