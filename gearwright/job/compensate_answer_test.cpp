// Corrections of specs that the fuzzer found.
#include "gearwright/job/compensate_answer.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gearwright/base/units.hpp"
#include "gearwright/spec/parse_spec.hpp"

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
    EXPECT_LE(*answer->after.span, std::max(kQuiet, *answer->before.span + kSameError)) << curves;
  }
}

// In the case `worst-inside-the-box` of theory page 14, the peak-to-peak transmission error without
// corrections is 4.3″ inside the range and at most 0.74″ at its ends. The corrections must hold for
// the whole range.
TEST(CompensateAnswer, inside_the_range_nothing_is_worse_than_the_scenarios) {
  constexpr const char* kSpec = R"(
[gear1]
teeth = 23
normal_module_mm = 2
helix_angle_deg = -20
profile_shift = 0.15
thickness_allowance_mm = -0.05
face_width_mm = 20
[gear2]
teeth = 61
profile_shift = 0
thickness_allowance_mm = -0.05
face_width_mm = 20
[pair]
center_distance_mm = 89.8
[errors]
center_distance_mm = -0.0012
crossing_deg = 0.0248
helix_slope1_um = -10.77
helix_slope2_um = -4.01
[compensate.range]
intersecting_deg = [-0.046, 0.046]
)";
  const auto spec = read_spec(kSpec, SpecFormat::toml);
  ASSERT_TRUE(spec) << spec.error().message();
  auto solved = solve(*spec, Scope::pair);
  ASSERT_TRUE(solved) << solved.error().message();
  SolvedJob job = std::move(solved).take();
  const auto answer = answer_compensate(job);
  ASSERT_TRUE(answer) << answer.error().message();
  EXPECT_GT(answer->scenarios.size(), 3u);  // more than the given errors and the ends
  EXPECT_LT(answer->after.peak_to_peak, answer->before.peak_to_peak);

  double worst = 0.0;
  for (int k = -46; k <= 46; ++k) {
    Json tables = answer->corrected->tables;
    tables["errors"]["intersecting_deg"] = 0.001 * k;
    const auto corrected = read_spec_tree(tables);
    ASSERT_TRUE(corrected) << corrected.error().message();
    auto with = solve(*corrected, Scope::pair);
    ASSERT_TRUE(with) << with.error().message();
    const SolvedJob member = std::move(with).take();
    const auto setup = setup_of(member);
    ASSERT_TRUE(setup) << setup.error().message();
    worst =
        std::max(worst, peak_to_peak(transmission_error(setup->pair(false), 64)) / kRadPerArcsec);
  }
  EXPECT_LT(worst, 1.05 * answer->after.peak_to_peak.arcsec() + 0.02);
}

}  // namespace
}  // namespace gearwright
