// A ring gear cut by a shaper's pinion cutter, with a planet inside it.
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
  CylindricalSpec spec{.teeth = 25, .normal_module = 1.5, .helix_angle = 20_deg, .face_width = 16};
  spec.rack = StraightRack{.addendum = 1.25, .tip_fillet_radius = 0.2};
  const Result<Gear> cutter = make_gear(spec);
  if (!cutter) return fail(cutter.error());

  // At this distance from the cutter, the ring has a profile shift of -0.35.
  const Result<double> distance = generating_distance(*cutter, -66, -0.35);
  if (!distance) return fail(distance.error());
  const Result<Gear> ring = make_pinion_cut_gear(
      *cutter, {.teeth = -66, .distance = *distance, .face_width = 16, .tip_diameter = 103.4});
  if (!ring) return fail(ring.error());
  std::printf("generating distance  %.4f mm\n", *distance);
  std::printf("root diameter        %.4f mm\n", ring->root_diameter);
  std::printf("flank ends at        %.4f mm\n", 2 * ring->root_form_radius().value());

  const CylindricalSpec planet{.teeth = 21,
                               .normal_module = 1.5,
                               .helix_angle = 20_deg,
                               .profile_shift = 0.35,
                               .thickness_allowance = -0.04,
                               .face_width = 16};
  const Result<Gear> gear = make_gear(planet);
  if (!gear) return fail(gear.error());
  const double a = 1.5 / std::cos((20_deg).rad()) * (66 - 21) / 2;
  const Result<Pair> pair = mount(*gear, *ring, {.center_distance = a});
  if (!pair) return fail(pair.error());
  std::printf("contact ratio        %.4f\n", pair->involute()->contact_ratio_true());
  std::printf("normal backlash      %.4f mm\n", pair->involute()->mesh.backlash.normal);
}

/* prints
generating distance  33.2241 mm
root diameter        110.1049 mm
flank ends at        109.8223 mm
contact ratio        2.7007
normal backlash      0.0400 mm
*/
