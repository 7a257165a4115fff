// Few teeth: the best pinion of three teeth for a wheel of thirty, and the wheel that it cuts.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  FewTeethProblem problem;
  problem.teeth = {3, 30};
  problem.normal_module = 1.5;  // mm
  problem.normal_pressure_angle = 20_deg;
  problem.helix = 30_deg;
  problem.min_tip_land = 0.3;  // mm, as all lengths here
  problem.min_gap = 0.2;
  problem.clearance = 0.25;
  problem.backlash = 0.05;
  const Result<FewTeethAnswer> answer = design_few_teeth(problem);
  if (!answer) return fail(answer.error());
  if (!answer->design) {
    std::printf("no such pair: %s\n", answer->limit.c_str());
    return 1;
  }
  const FewTeethDesign& design = *answer->design;
  std::printf("profile shifts   %.3f and %.3f\n", design.pinion.profile_shift, design.wheel_shift);
  std::printf("centre distance  %.4f mm\n", design.center_distance);
  std::printf("face width       %.4f mm\n", design.face_width);
  std::printf("contact ratio    %.4f, of the profile %.4f\n", design.pair.contact_ratio_true(),
              design.pair.mesh.true_ratio);
}

/* prints
profile shifts   0.705 and -0.274
centre distance  29.2428 mm
face width       4.2000 mm
contact ratio    2.3517, of the profile 0.7601
*/
