// One gear: its main dimensions, its outline, and the chord that a calliper measures.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  const CylindricalSpec pinion{.teeth = 17,
                               .normal_module = 2.5,   // mm
                               .helix_angle = 15_deg,  // right hand
                               .profile_shift = 0.3,
                               .thickness_allowance = -0.05,  // mm
                               .face_width = 25};             // mm
  const Result<Gear> gear = make_gear(pinion);
  if (!gear) return fail(gear.error());
  std::printf("reference diameter  %.4f mm\n", gear->reference_diameter);
  std::printf("tip diameter        %.4f mm\n", gear->tip_diameter);
  std::printf("base diameter       %.4f mm\n", 2 * gear->base_radius());
  std::printf("flank starts at     %.4f mm\n", 2 * gear->root_form_radius().value());
  for (const Arc& arc : gear->tooth->outline.arcs) {
    const Vec2 end = arc.end_point;
    std::printf("%-12s ends at (%.4f, %.4f) mm\n", to_string(arc.name).data(), end.x(), end.y());
  }

  const auto chord = chordal_thickness(*gear, gear->reference_diameter);
  if (!chord) return fail(chord.error());
  std::printf("chord %.4f mm, %.4f mm below the tip\n", chord->chord, chord->tip_to_chord);
}

/* prints
reference diameter  43.9992 mm
tip diameter        50.4992 mm
base diameter       41.1732 mm
flank starts at     41.5002 mm
root_land    ends at (19.2496, 3.4477) mm
root_fillet  ends at (20.6012, 2.4811) mm
flank        ends at (25.2398, 0.7038) mm
tip_land     ends at (25.2496, 0.0000) mm
chord 4.4165 mm, 3.3537 mm below the tip
*/
