// Laws of the two halves:
// (1) the face width of a half is half of the face width without the gap
// (2) the gap suffices for both settings of the hob
// (3) an axial shift by Δz rotates a half by e/2 on its pitch circle
#include "gearwright/arrange/two_halves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gearwright {
namespace {

GearInput helical(int teeth, double beta_deg, double face) {
  CylindricalSpec spec;
  spec.teeth = teeth;
  spec.normal_module = 3;
  spec.helix_angle = Angle::degrees(beta_deg);
  spec.face_width = face;
  return GearInput::of(spec);
}

GivenPair pair_of(double face_1, double face_2) {
  GivenPair given;
  given.gears = {helical(23, 28, face_1), helical(67, -28, face_2)};
  return given;
}

Gear half_gear() {
  CylindricalSpec spec = helical(23, 28, 60).cylindrical;
  auto gear = make_gear(spec);
  return std::move(gear).take();
}

TEST(TwoHalves, a_half_is_a_helical_gear) {
  GivenPair given = pair_of(150, 150);
  for (auto& gear : given.gears) gear->double_helical = DoubleHelical{.gap = 30};
  ASSERT_FALSE(halve(given));
  EXPECT_EQ(given.gear(1).cylindrical.face_width, 60);  // (1)
  const auto arranged = arrange(given, Scope::pair);
  ASSERT_TRUE(arranged);
  const double overlap = 60 * std::sin(Angle::degrees(28).rad()) / (std::numbers::pi * 3);
  EXPECT_NEAR(arranged->pair->involute()->mesh.overlap_ratio, overlap, 1e-14);
  const auto halves = halves_of(arranged->gear(1), {.gap = 30});
  ASSERT_TRUE(halves);
  EXPECT_EQ(halves->face_width, 150);
  EXPECT_EQ(halves->half_face_width, 60);
}

TEST(TwoHalves, nothing_happens_without_the_table) {
  GivenPair given = pair_of(150, 150);
  ASSERT_FALSE(halve(given));
  EXPECT_EQ(given.gear(2).cylindrical.face_width, 150);
}

TEST(TwoHalves, what_makes_no_pair_of_halves_is_an_error) {
  using Halves = std::array<std::optional<DoubleHelical>, 2>;
  const auto field = [](GivenPair given, const Halves& halves) {
    for (const std::size_t i : {0, 1}) given.gears[i]->double_helical = halves[i];
    const auto error = halve(given);
    return error ? error->field : std::string();
  };
  const DoubleHelical gap_30{.gap = 30}, gap_10{.gap = 10};
  EXPECT_EQ(field(pair_of(150, 150), {gap_30, std::nullopt}), "gear2.double_helical");
  EXPECT_EQ(field(pair_of(150, 150), {std::nullopt, gap_30}), "gear1.double_helical");
  EXPECT_EQ(field(pair_of(30, 150), {gap_30, gap_30}), "gear1.double_helical.gap");
  EXPECT_EQ(field(pair_of(150, 150), {gap_30, DoubleHelical{.gap = 30, .stagger_pitches = 0.5}}),
            "gear2.double_helical.stagger_pitches");
  // The gap of the wider gear may be narrower than the gap of its mating gear, but not wider.
  EXPECT_EQ(field(pair_of(160, 150), {gap_10, gap_30}), "");
  EXPECT_EQ(field(pair_of(160, 150), {gap_30, gap_10}), "gear2.double_helical.gap");
  GivenPair open = pair_of(150, 150);
  open.gear(2).face_width_given = false;
  EXPECT_EQ(field(open, {gap_30, gap_30}), "gear2.face_width");
}

TEST(TwoHalves, a_groove_limits_the_bore) {
  const auto codes = [](double bore, double gap) {
    GivenPair given = pair_of(150, 150);
    for (auto& gear : given.gears) gear->double_helical = DoubleHelical{.gap = gap};
    given.gear(1).bore = Bore{bore};
    EXPECT_FALSE(halve(given));
    const auto arranged = arrange(given, Scope::pair);
    return std::count_if(arranged->warnings.begin(), arranged->warnings.end(),
                         [](const Warning& w) { return w.code == WarningCode::no_body; });
  };
  const double root = half_gear().root_diameter;
  EXPECT_EQ(codes(root - 1.4, 30), 1);
  EXPECT_EQ(codes(root - 1.6, 30), 0);
  EXPECT_EQ(codes(root - 1.4, 0), 0);
}

TEST(TwoHalves, staggered_halves_need_a_gap) {
  const auto warns = [](const DoubleHelical& given) {
    return stagger_warning(*halves_of(half_gear(), given), 1).has_value();
  };
  EXPECT_TRUE(warns({.stagger_pitches = 0.5}));
  EXPECT_FALSE(warns({.gap = 30, .stagger_pitches = 0.5}));
  EXPECT_FALSE(warns({}));
}

TEST(TwoHalves, the_gap_serves_the_hob) {
  const Gear half = half_gear();
  const double h = (half.tip_diameter - half.root_diameter) / 2;
  EXPECT_NEAR(h, 2.25 * 3, 1e-12);
  const double beta = Angle::degrees(28).rad(), gamma = Angle::degrees(3).rad();
  const double reach = std::sqrt(h * (90 - h));
  const auto short_hob = halves_of(half, {.gap = 30, .hob_diameter = 90.0});
  ASSERT_TRUE(short_hob);
  EXPECT_NEAR(*short_hob->hob_run_out, reach * std::cos(beta), 1e-12);
  const auto hob = halves_of(half, {.gap = 30,
                                    .hob_diameter = 90.0,
                                    .hob_lead_angle = Angle::radians(gamma),
                                    .hob_half_length = 25});
  ASSERT_TRUE(hob);
  for (const double eta : {beta - gamma, beta + gamma})  // (2)
    EXPECT_GE(*hob->hob_run_out + 1e-12, reach * std::cos(eta) + 25 * std::sin(eta));
  EXPECT_TRUE(run_out_warning(*hob, 1));
  EXPECT_EQ(run_out_warning(*hob, 1)->code, WarningCode::hob_run_out);
  EXPECT_FALSE(run_out_warning(*short_hob, 1));
  EXPECT_FALSE(halves_of(half, {.gap = 30, .hob_diameter = 2 * h}));
  EXPECT_FALSE(halves_of(half, {.gap = 30})->hob_run_out);
}

TEST(TwoHalves, a_spur_gear_has_none) {
  const auto spur = make_gear(helical(23, 0, 60).cylindrical);
  ASSERT_TRUE(spur);
  const auto halves = halves_of(*spur, {.gap = 30});
  ASSERT_FALSE(halves);
  EXPECT_EQ(halves.error().field, "helix_angle");
}

TEST(TwoHalves, floating_shares_an_index_error) {
  const Gear half = half_gear();
  const double e = 0.02;  // mm on the pitch circle
  const double shift = halves_of(half, {})->axial_shift_per_index_error * e;
  const double turned = shift * half.twist() * half.reference_diameter / 2;
  EXPECT_NEAR(turned, e / 2, 1e-15);  // (3)
}

}  // namespace
}  // namespace gearwright
