// Compares the closed-form mesh with textbook formulas in other forms, and tests its laws.
#include "gearwright/pair/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/violation.hpp"
#include "gearwright/pair/testing/spur_mesh.hpp"

namespace gearwright {
namespace {

using testing::kAlpha;
using testing::spur;

TEST(MeshOfParallelAxes, external_spur_pair_of_the_textbook) {
  const auto m = mesh_of(spur(20, 40));
  EXPECT_NEAR(m.rack.sides[0].transverse_angle, kAlpha, 1e-15);
  EXPECT_NEAR(m.rack.normal_pressure_angle, kAlpha, 1e-15);
  EXPECT_EQ(m.rack.sides[0].helix_angle, 0.0);
  EXPECT_NEAR(m.rack.sides[0].pitch_radius, 20.0, 1e-13);
  EXPECT_NEAR(m.rack.sides[1].pitch_radius, 40.0, 1e-13);
  const double g = std::sqrt(22 * 22 - std::pow(20 * std::cos(kAlpha), 2)) +
                   std::sqrt(42 * 42 - std::pow(40 * std::cos(kAlpha), 2)) - 60 * std::sin(kAlpha);
  EXPECT_NEAR(m.path_length, g, 1e-13);
  EXPECT_NEAR(m.path_ratio, g / (2 * kPi * std::cos(kAlpha)), 1e-14);
  EXPECT_EQ(m.overlap_ratio, 0.0);
  EXPECT_NEAR(m.backlash.normal_base, 0.0, 1e-13);
}

TEST(MeshOfParallelAxes, internal_spur_pair) {
  const auto m = mesh_of(spur(20, -60));
  EXPECT_NEAR(m.rack.sides[0].transverse_angle, kAlpha, 1e-15);
  EXPECT_NEAR(m.rack.sides[1].pitch_radius, 60.0, 1e-13);
  const double g = std::sqrt(22 * 22 - std::pow(20 * std::cos(kAlpha), 2)) -
                   std::sqrt(58 * 58 - std::pow(60 * std::cos(kAlpha), 2)) + 40 * std::sin(kAlpha);
  EXPECT_NEAR(m.path_length, g, 1e-13);
  EXPECT_NEAR(m.backlash.normal_base, 0.0, 1e-13);
}

TEST(MeshOfParallelAxes, points_of_the_path_stand_in_order) {
  for (const auto& in : {spur(20, 40), spur(30, 30), spur(20, -60)}) {
    const auto m = mesh_of(in);
    // One pair is in contact between B and D, and two pairs are in contact elsewhere, because
    // 1 < ε_α < 2.
    ASSERT_GT(m.path_ratio, 1.0);
    ASSERT_LT(m.path_ratio, 2.0);
    EXPECT_LT(m.rho1_A, m.rho1_B);
    EXPECT_LT(m.rho1_B, m.rho1_D);
    EXPECT_LT(m.rho1_D, m.rho1_E);
    EXPECT_LT(m.rho1_A, m.rho1_C);
    EXPECT_LT(m.rho1_C, m.rho1_E);
    EXPECT_NEAR(m.rho1_E - m.rho1_A, m.path_length, 1e-14 * 20);
    EXPECT_NEAR(m.rho1_D - m.rho1_A, 2 * kPi * in.gears[0].radius / in.gears[0].teeth, 1e-14 * 20);
    EXPECT_NEAR(m.rho1_C, m.rack.sides[0].pitch_radius * std::sin(m.rack.sides[0].transverse_angle),
                1e-13);
  }
}

// Each form circle clips one end of the path.
TEST(MeshOfParallelAxes, clipped_path) {
  auto in = spur(20, 40);
  const auto whole = mesh_of(in);
  EXPECT_EQ(whole.true_ratio, whole.path_ratio);
  in.root_form_radius[0] = std::hypot(in.gears[0].radius, whole.rho1_A + 0.5);
  const auto one = mesh_of(in);
  EXPECT_NEAR(one.rho1_true_begin, whole.rho1_A + 0.5, 1e-13);
  EXPECT_EQ(one.rho1_true_end, whole.rho1_E);
  EXPECT_EQ(one.path_ratio, whole.path_ratio);
  in.root_form_radius[1] =
      std::hypot(in.gears[1].radius, whole.base_tangent_distance - whole.rho1_E + 0.25);
  const auto both = mesh_of(in);
  EXPECT_NEAR(both.rho1_true_end, whole.rho1_E - 0.25, 1e-13);
  EXPECT_NEAR(both.true_ratio, (whole.path_length - 0.75) / (2 * kPi * std::cos(kAlpha)), 1e-13);
  in.root_form_radius[0] = 22.0;
  EXPECT_EQ(mesh_of(in).true_ratio, 0.0);
}

// The part of a tip beyond the base tangent point of the mating gear touches nothing.
TEST(MeshOfParallelAxes, path_is_clipped_at_the_base_tangents) {
  auto in = spur(8, 120);
  const auto m = mesh_of(in);
  EXPECT_LT(m.rho1_A, 0.0);
  EXPECT_EQ(m.rho1_true_begin, 0.0);
  EXPECT_FALSE(specific_sliding(in, m, m.rho1_A).zeta_1);
  EXPECT_FALSE(specific_sliding(in, m, 0.0).zeta_2);
}

// j_bn by hand: the base pitch minus both base thicknesses ± 2 (r_b2 ± r_b1) inv α_wt. The lower
// signs are those of an internal gear.
TEST(MeshOfParallelAxes, backlash) {
  for (const int z2 : {40, -60}) {
    auto in = spur(20, z2);
    const double sigma = z2 > 0 ? 1.0 : -1.0;
    in.gears[0].tooth_thickness -= 0.05;
    in.center_distance += sigma * 0.1;
    const auto m = mesh_of(in);
    const double sum = in.gears[1].radius + sigma * in.gears[0].radius;
    const double by_hand = 2 * kPi * in.gears[0].radius / 20 - in.gears[0].tooth_thickness -
                           in.gears[1].tooth_thickness +
                           sigma * 2 * sum * involute(std::acos(sum / in.center_distance));
    EXPECT_NEAR(m.backlash.normal_base, by_hand, 1e-12);
    EXPECT_GT(m.backlash.normal_base, 0.0);
    EXPECT_NEAR(m.backlash.normal, m.backlash.normal_base / std::cos(m.rack.normal_pressure_angle),
                1e-14);
    EXPECT_NEAR(m.backlash.circumferential[0],
                m.backlash.rotation[0] * m.rack.sides[0].pitch_radius, 1e-14);
    EXPECT_NEAR(m.backlash.circumferential[0],
                m.backlash.rotation[1] * m.rack.sides[1].pitch_radius, 1e-14);
  }
}

TEST(MeshOfParallelAxes, the_least_distance_is_free_of_backlash) {
  auto in = spur(20, 40);
  in.gears[0].tooth_thickness += 0.4;
  const double alpha = *transverse_angle_at_min_distance(in.gears);
  in.center_distance = base_radius_sum(in.gears) / std::cos(alpha);
  EXPECT_NEAR(mesh_of(in).backlash.normal_base, 0.0, 1e-13);
  in.gears[0].tooth_thickness -= 5.0;
  EXPECT_FALSE(transverse_angle_at_min_distance(in.gears));
}

TEST(SpecificSliding, signs_and_the_pitch_point) {
  const auto in = spur(20, 40);
  const auto m = mesh_of(in);
  const auto at_A = specific_sliding(in, m, m.rho1_A);
  EXPECT_LT(*at_A.zeta_1, 0.0);  // the flank at the root of the pinion slides backward
  EXPECT_GT(*at_A.zeta_2, 0.0);
  const auto at_E = specific_sliding(in, m, m.rho1_E);
  EXPECT_GT(*at_E.zeta_1, 0.0);
  EXPECT_LT(*at_E.zeta_2, 0.0);
  const auto at_C = specific_sliding(in, m, m.rho1_C);
  EXPECT_NEAR(*at_C.zeta_1, 0.0, 1e-14);
  EXPECT_NEAR(*at_C.zeta_2, 0.0, 1e-14);
  // (1 − ζ1)(1 − ζ2) = 1, because 1 − ζ1 = w_2/w_1 and 1 − ζ2 = w_1/w_2.
  EXPECT_NEAR((1 - *at_A.zeta_1) * (1 - *at_A.zeta_2), 1.0, 1e-14);
}

// A contact on a base circle has no specific sliding, although rounding leaves a radius of
// curvature of ±1e-15 there. Gears with few teeth touch at such a point if they are not undercut.
TEST(SpecificSliding, does_not_exist_at_the_base_tangent_points) {
  const auto in = spur(20, 40);
  const auto m = mesh_of(in);
  const double length = m.rho2(0.0);  // between the base tangent points
  for (const double error : {-3e-14, -1e-15, 0.0, 1e-15, 3e-14}) {
    for (const double rho1 : {length * error, length * (1 + error)}) {
      const auto s = specific_sliding(in, m, rho1);
      EXPECT_FALSE(s.zeta_1) << rho1;
      EXPECT_FALSE(s.zeta_2) << rho1;
    }
  }
  EXPECT_LT(*specific_sliding(in, m, 1e-9 * length).zeta_1, -1e8);
}

TEST(MeshOfParallelAxes, helical_overlap) {
  auto in = spur(20, 40);
  in.gears[0].helix_angle = 0.25;
  in.gears[1].helix_angle = -0.25;
  const auto m = mesh_of(in);
  EXPECT_NEAR(m.overlap_ratio, 20.0 * std::tan(0.25) / (2 * kPi * std::cos(kAlpha)), 1e-14);
  EXPECT_NEAR(std::sin(m.rack.normal_pressure_angle), std::sin(kAlpha) * std::cos(0.25), 1e-15);
  EXPECT_NEAR(std::tan(m.rack.sides[0].helix_angle), std::tan(0.25) / std::cos(kAlpha), 1e-15);
}

TEST(MeshDeathTest, no_working_angle_is_for_the_caller_to_refuse) {
  auto in = spur(20, 40);
  in.center_distance = base_radius_sum(in.gears);
  GW_EXPECT_VIOLATION(mesh_of(in));
}

}  // namespace
}  // namespace gearwright
