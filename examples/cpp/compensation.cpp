// Compensation: the lead slope and the crowning that keep a pair quiet over a range of shaft errors.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  CylindricalSpec spec{.teeth = 21, .normal_module = 3, .helix_angle = 12_deg, .face_width = 40};
  const Result<Gear> pinion = make_gear(spec);
  if (!pinion) return fail(pinion.error());
  spec.teeth = 55, spec.helix_angle = -12_deg;
  const Result<Gear> wheel = make_gear(spec);
  if (!wheel) return fail(wheel.error());
  const Result<Pair> pair = mount(*pinion, *wheel, {.center_distance = 116.6});
  if (!pair) return fail(pair.error());

  const Result<ContactSetup> setup = ContactSetup::of(*pair, {});
  if (!setup) return fail(setup.error());

  const std::vector<ContactErrors> shafts{{.crossing = -0.01_deg}, {.crossing = 0.04_deg}};
  CompensationTask task = compensation_task(
      *setup, {{Modification::lead_slope, 1}, {Modification::lead_crowning, 1}}, shafts);
  task.corrections = {{.lo = -50, .hi = 50, .step = 1},  // um
                      {.lo = 0, .hi = 20, .step = 1}};
  task.centering = Angle::arcseconds(20);  // penalty for contact at the end of the face
  const Compensation found = compensate(task);
  std::printf("lead slope %.2f um, crowning %.2f um\n", found.value[0], found.value[1]);
  std::printf("worst transmission error %.3f arcsec before, %.3f arcsec after\n",
              found.before.peak_to_peak.arcsec(), found.after.peak_to_peak.arcsec());
  std::printf("contact along the face   %.3f before, %.3f after (1: at the end)\n",
              found.before.along_face, found.after.along_face);
}

/* prints
lead slope -10.00 um, crowning 20.00 um
worst transmission error 2.875 arcsec before, 2.724 arcsec after
contact along the face   -0.998 before, 0.205 after (1: at the end)
*/
