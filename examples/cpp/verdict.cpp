// The verdict on a pair at a fixed centre distance, also at the ends of its tolerances.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  CylindricalSpec pinion{.teeth = 17, .normal_module = 2, .face_width = 20};
  CylindricalSpec wheel = pinion;
  wheel.teeth = 43;
  GivenPair given;
  given.gears = {GearInput::of(pinion), GearInput::of(wheel)};
  given.gear(2).shift_given = false;  // follows from the centre distance
  given.pair.center_distance = 60;
  given.pair.distance_tolerance = "JS7";
  const Result<Arranged> pair = arrange(given);
  if (!pair) return fail(pair.error());

  const Verdict verdict = judge(*pair);
  std::printf("%s: %s\n", to_string(verdict.level), verdict.headline.c_str());
  for (const Finding& finding : verdict.findings) std::printf("- %s\n", finding.whole().c_str());
}

/* prints
red: The pair does not run as specified: the teeth are too thick for this centre distance. At a centre distance of 59.9850 mm: The backlash is negative, because the teeth are too thick by 0.0109 mm (normal) at this centre distance. The backlash-free centre distance is 60.0000 mm. With a thickness allowance of -0.011 mm on gear 1, the backlash is positive at both ends of every tolerance. Also: undercut.
- At a centre distance of 59.9850 mm: The backlash is negative, because the teeth are too thick by 0.0109 mm (normal) at this centre distance. The backlash-free centre distance is 60.0000 mm. With a thickness allowance of -0.011 mm on gear 1, the backlash is positive at both ends of every tolerance.
- There is undercut, so the usable flank starts at a diameter of 31.9496 mm; a profile shift of at least 0.0057 avoids undercut.
- There is no backlash; ISO/TR 10064-2 recommends at least 0.107 mm. Give thickness allowances or a series of DIN 3967.
*/
