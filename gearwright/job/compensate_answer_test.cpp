// Corrections of whole specs that the fuzzer found.
#include "gearwright/job/compensate_answer.hpp"

#include <gtest/gtest.h>

namespace gearwright {
namespace {

// With few positions, the search must not accept a greater transmission error in exchange for a
// better pattern.
TEST(CompensateAnswer, the_limit_holds_however_little_is_looked_at) {
  constexpr const char* kSpec = R"(
[gear1]
teeth = 17
normal_module_mm = 2
helix_angle_deg = 10
[gear2]
teeth = -50
normal_module_mm = 2
helix_angle_deg = 10
cut_by = "gear1"
[errors]
axial_mm = 0.1
intersecting_deg = -0.7
[contact]
positions = 6
[compensate.range]
center_distance_mm = [-0.02, 0.02]
)";
  const auto spec = read_spec(kSpec, SpecFormat::toml);
  ASSERT_TRUE(spec) << spec.error().message();
  for (const int curves : {1, 6, 40, 400}) {
    auto solved = solve(*spec, Scope::pair);
    ASSERT_TRUE(solved) << solved.error().message();
    SolvedJob job = std::move(solved).take();
    const auto answer = answer_compensate(job, nullptr, curves);
    ASSERT_TRUE(answer) << answer.error().message();
    const Compensation& found = answer->result;
    EXPECT_LE(found.after.peak_to_peak, std::max(kQuiet, found.before.peak_to_peak + kSameError))
        << curves;
  }
}

}  // namespace
}  // namespace gearwright
