// A rack of your own: deeper teeth, a protuberance for grinding, and a tip chamfer by semi-topping.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  CylindricalSpec spec{.teeth = 30, .normal_module = 4, .face_width = 30};
  StraightRack rack;  // all lengths in modules
  rack.addendum = 1.2;
  rack.dedendum = 1.5;
  rack.root_fillet_radius = 0.3;
  rack.protuberance = 0.02;
  rack.protuberance_angle = 10_deg;
  rack.tool_addendum = 1.1;
  rack.semi_topping_angle = 45_deg;
  spec.rack = rack;
  const Result<Gear> gear = make_gear(spec);
  if (!gear) return fail(gear.error());
  std::printf("tip and root diameter  %.3f, %.3f mm\n", gear->tip_diameter, gear->root_diameter);
  std::printf("flank from and to      %.3f, %.3f mm\n", 2 * gear->root_form_radius().value(),
              2 * gear->tip_form_radius());
  for (const Arc& arc : gear->tooth->outline.arcs)
    std::printf("%-12s ends at radius %.4f mm\n", to_string(arc.name).data(), arc.end_point.norm());
  for (const Warning& warning : gear->warnings) std::printf("%s\n", to_string(warning.code));
}

/* prints
tip and root diameter  129.600, 108.000 mm
flank from and to      114.799, 129.582 mm
root_land    ends at radius 54.0000 mm
root_fillet  ends at radius 57.3995 mm
flank        ends at radius 64.7911 mm
tip_fillet   ends at radius 64.8000 mm
tip_land     ends at radius 64.8000 mm
*/
