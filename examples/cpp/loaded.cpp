// Teeth under torque: transmission error, flank pressure and root stress.
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
  GivenPair given;
  given.gears = {GearInput::of(pinion), GearInput::of(wheel)};
  const Result<Arranged> pair = arrange(given);
  if (!pair) return fail(pair.error());

  const ContactErrors errors{.crossing = 0.01_deg};
  const LoadInput load{.torques = {200, 480}, .positions = 16};  // N m on gear 1
  std::vector<Warning> warnings;  // for example: the bodies are held at half the root
  const Result<LoadAnalysis> found = loaded(*pair, errors, load, warnings);
  if (!found) return fail(found.error());
  for (const LoadedTorque& t : found->contact->torques) {
    std::printf("%.0f N m\n", t.torque / kMmPerM);
    std::printf("  transmission error  %.2f arcsec peak to peak\n", t.peak_to_peak.arcsec());
    std::printf("  flank pressure      %.0f MPa\n", t.max_pressure);
    std::printf("  root stress         %.0f and %.0f MPa\n", t.max_root_stress[0],
                t.max_root_stress[1]);
    std::printf("  K_Hbeta             %.3f\n", t.face_load_factor);
  }
}

/* prints
200 N m
  transmission error  1.23 arcsec peak to peak
  flank pressure      950 MPa
  root stress         125 and 71 MPa
  K_Hbeta             1.755
480 N m
  transmission error  1.59 arcsec peak to peak
  flank pressure      1244 MPa
  root stress         222 and 140 MPa
  K_Hbeta             1.344
*/
