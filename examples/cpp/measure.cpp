// Measurements in a workshop: span, dimension over balls and chord, with usual and with given tools.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  CylindricalSpec spec{.teeth = 23, .normal_module = 2.5, .helix_angle = 18_deg, .face_width = 25};
  spec.profile_shift = 0.4;
  spec.thickness_allowance = -0.06;
  const Result<Gear> gear = make_gear(spec);
  if (!gear) return fail(gear.error());

  const Result<GearMeasures> usual = measure(*gear);
  if (!usual) return fail(usual.error());
  // A member is empty if the dimension cannot be measured, for example the span of an internal
  // helical gear. The JSON keys `over_balls` and `over_pins` are the members `balls` and `pins`.
  if (usual->span)
    std::printf("span over %d teeth     %.4f mm\n", usual->span->teeth, usual->span->length);
  std::printf("over balls of %.1f mm  %.4f mm\n", usual->balls->seat.ball_diameter,
              usual->balls->dimension);
  std::printf("chord at %.3f mm    %.4f mm, %.4f mm below the tip\n", usual->chord->diameter,
              usual->chord->chord.chord, usual->chord->chord.tip_to_chord);

  const Result<GearMeasures> own = measure(*gear, {.span_teeth = 3, .ball_diameter = 5});
  if (!own) return fail(own.error());
  std::printf("span over %d teeth     %.4f mm\n", own->span->teeth, own->span->length);
  std::printf("over balls of %.1f mm  %.4f mm\n", own->balls->seat.ball_diameter,
              own->balls->dimension);
}

/* prints
span over 4 teeth     27.3879 mm
over balls of 4.5 mm  68.3956 mm
chord at 60.459 mm    4.5913 mm, 3.5790 mm below the tip
span over 3 teeth     20.0076 mm
over balls of 5.0 mm  69.9698 mm
*/
