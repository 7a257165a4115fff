// Crossed axes: two right-hand gears at 90 degrees, and helix angles that fit a given centre distance.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  CylindricalSpec spec{.teeth = 16, .normal_module = 2, .helix_angle = 45_deg, .face_width = 20};
  const Result<Gear> gear_1 = make_gear(spec);
  if (!gear_1) return fail(gear_1.error());
  spec.teeth = 31;
  const Result<Gear> gear_2 = make_gear(spec);
  if (!gear_2) return fail(gear_2.error());
  const Result<Pair> pair =
      mount(*gear_1, *gear_2, {.center_distance = 66.5, .shaft_angle = 90_deg, .friction = 0.05});
  if (!pair) return fail(pair.error());
  std::printf("contact ratio    %.4f\n", pair->contact_ratio());
  std::printf("normal backlash  %.4f mm\n", pair->crossed()->normal_backlash());
  const FaceWidths<double>& widths = pair->crossed()->face_widths;
  std::printf("face widths      %.4f and %.4f mm\n", widths.both_flanks[0], widths.both_flanks[1]);

  // The inverse problem: the helix angles of 12 and 24 teeth for a centre distance of 40 mm.
  FitProblem problem;
  problem.teeth = {12, 24};
  problem.normal_module = 1.5;
  problem.normal_pressure_angle = 20_deg;
  problem.center_distance = 40;
  problem.shaft_angle = 90_deg;
  const Result<Fit> answer = fit(problem);
  if (!answer) return fail(answer.error());
  for (const FitBranch& branch : answer->branches)
    std::printf("helix angles     %.5f and %.5f deg\n", branch.helix[0].deg(),
                branch.helix[1].deg());
}

/* prints
contact ratio    1.7762
normal backlash  0.0233 mm
face widths      7.2182 and 7.0940 mm
helix angles     39.41253 and 50.58747 deg
helix angles     62.94762 and 27.05238 deg
*/
