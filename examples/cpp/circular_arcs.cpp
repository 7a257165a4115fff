// Circular-arc (Wildhaber-Novikov) gears: convex teeth of the pinion in concave teeth of the wheel.
#include <cmath>
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  // Both arcs touch at 30 degrees; their radii differ by 0.15 modules.
  ArcRack convex = default_arc_rack(ArcRack::Cutter::F);
  convex.arc_radius = 1.4;
  convex.center_a = 0.42;
  convex.center_b = 0.24;
  ArcRack concave = default_arc_rack(ArcRack::Cutter::P);
  concave.arc_radius = 1.55;
  concave.center_a = convex.center_a + 0.15 * std::cos((30_deg).rad());
  concave.center_b = convex.center_b + 0.15 * std::sin((30_deg).rad());

  CylindricalSpec spec{.teeth = 16, .normal_module = 4, .helix_angle = 20_deg, .face_width = 60};
  spec.rack = convex;
  const Result<Gear> pinion = make_gear(spec);
  if (!pinion) return fail(pinion.error());
  spec.teeth = 48;
  spec.helix_angle = -20_deg;
  spec.rack = concave;
  const Result<Gear> wheel = make_gear(spec);
  if (!wheel) return fail(wheel.error());

  const Result<Pair> pair = mount(*pinion, *wheel);
  if (!pair) return fail(pair.error());
  std::printf("centre distance  %.4f mm\n", pair->center_distance());
  std::printf("contact ratio    %.4f\n", pair->contact_ratio());
  std::printf("least face       %.4f mm\n", pair->arcs()->face_for_contact);

  const Result<Contact> touching =
      contact(*pair, {.center_distance = 0.02, .crossing = Angle::radians(2e-4)});
  if (!touching) return fail(touching.error());
  std::printf("transmission error with the shafts crossed by 0.2 mrad  %.3f arcsec\n",
              touching->peak_to_peak.arcsec());
}

/* prints
centre distance  136.2148 mm
contact ratio    1.6330
least face       36.7416 mm
transmission error with the shafts crossed by 0.2 mrad  13.375 arcsec
*/
