// The closed-form mesh: against textbook formulas written the other way, and its laws.
#include "gearwright/pair/parallel_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace gearwright {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAlpha = kPi / 9;

// m = 2, α = 20°, no shift: r_b = z cos α, s_bt = d_b (π/(2z) ± inv α).
ParallelMeshInput<double> spur(int z1, int z2) {
  ParallelMeshInput<double> in;
  in.z1 = z1;
  in.z2 = z2;
  in.base_radius_1 = z1 * std::cos(kAlpha);
  in.base_radius_2 = std::abs(z2) * std::cos(kAlpha);
  const double inv = involute(kAlpha);
  in.base_thickness_1 = 2 * in.base_radius_1 * (kPi / (2 * z1) + inv);
  in.base_thickness_2 = 2 * in.base_radius_2 * (kPi / (2 * std::abs(z2)) + (z2 > 0 ? inv : -inv));
  in.tip_form_radius_1 = z1 + 2;
  in.tip_form_radius_2 = z2 > 0 ? z2 + 2 : -z2 - 2;
  in.face_width = 20.0;
  in.center_distance = std::abs(z1 + z2);
  return in;
}

TEST(ParallelMesh, external_spur_pair_of_the_textbook) {
  const auto m = parallel_mesh(spur(20, 40));
  EXPECT_NEAR(m.working_transverse_pressure_angle, kAlpha, 1e-15);
  EXPECT_NEAR(m.working_normal_pressure_angle, kAlpha, 1e-15);
  EXPECT_EQ(m.working_helix_angle, 0.0);
  EXPECT_NEAR(m.working_pitch_radius_1, 20.0, 1e-13);
  EXPECT_NEAR(m.working_pitch_radius_2, 40.0, 1e-13);
  const double g = std::sqrt(22 * 22 - std::pow(20 * std::cos(kAlpha), 2)) +
                   std::sqrt(42 * 42 - std::pow(40 * std::cos(kAlpha), 2)) - 60 * std::sin(kAlpha);
  EXPECT_NEAR(m.path_length, g, 1e-13);
  EXPECT_NEAR(m.transverse_contact_ratio, g / (2 * kPi * std::cos(kAlpha)), 1e-14);
  EXPECT_EQ(m.overlap_ratio, 0.0);
  EXPECT_NEAR(m.backlash_normal_base, 0.0, 1e-13);
}

TEST(ParallelMesh, internal_spur_pair) {
  const auto m = parallel_mesh(spur(20, -60));
  EXPECT_NEAR(m.working_transverse_pressure_angle, kAlpha, 1e-15);
  EXPECT_NEAR(m.working_pitch_radius_2, 60.0, 1e-13);
  const double g = std::sqrt(22 * 22 - std::pow(20 * std::cos(kAlpha), 2)) -
                   std::sqrt(58 * 58 - std::pow(60 * std::cos(kAlpha), 2)) + 40 * std::sin(kAlpha);
  EXPECT_NEAR(m.path_length, g, 1e-13);
  EXPECT_NEAR(m.backlash_normal_base, 0.0, 1e-13);
}

TEST(ParallelMesh, points_of_the_path_stand_in_order) {
  for (const auto& in : {spur(20, 40), spur(30, 30), spur(20, -60)}) {
    const auto m = parallel_mesh(in);
    // One pair between B and D, two outside: 1 < ε_α < 2.
    ASSERT_GT(m.transverse_contact_ratio, 1.0);
    ASSERT_LT(m.transverse_contact_ratio, 2.0);
    EXPECT_LT(m.rho1_A, m.rho1_B);
    EXPECT_LT(m.rho1_B, m.rho1_D);
    EXPECT_LT(m.rho1_D, m.rho1_E);
    EXPECT_LT(m.rho1_A, m.rho1_C);
    EXPECT_LT(m.rho1_C, m.rho1_E);
    EXPECT_NEAR(m.rho1_E - m.rho1_A, m.path_length, 1e-14 * 20);
    EXPECT_NEAR(m.rho1_D - m.rho1_A, 2 * kPi * in.base_radius_1 / in.z1, 1e-14 * 20);
    EXPECT_NEAR(m.rho1_C, m.working_pitch_radius_1 * std::sin(m.working_transverse_pressure_angle),
                1e-13);
  }
}

// Form circles clip the path, each at its own end.
TEST(ParallelMesh, clipped_path) {
  auto in = spur(20, 40);
  const auto whole = parallel_mesh(in);
  EXPECT_EQ(whole.transverse_contact_ratio_true, whole.transverse_contact_ratio);
  in.root_form_radius_1 = std::hypot(in.base_radius_1, whole.rho1_A + 0.5);
  const auto one = parallel_mesh(in);
  EXPECT_NEAR(one.rho1_true_begin, whole.rho1_A + 0.5, 1e-13);
  EXPECT_EQ(one.rho1_true_end, whole.rho1_E);
  EXPECT_EQ(one.transverse_contact_ratio, whole.transverse_contact_ratio);
  in.root_form_radius_2 =
      std::hypot(in.base_radius_2, whole.base_tangent_distance - whole.rho1_E + 0.25);
  const auto both = parallel_mesh(in);
  EXPECT_NEAR(both.rho1_true_end, whole.rho1_E - 0.25, 1e-13);
  EXPECT_NEAR(both.transverse_contact_ratio_true,
              (whole.path_length - 0.75) / (2 * kPi * std::cos(kAlpha)), 1e-13);
  in.root_form_radius_1 = 22.0;
  EXPECT_EQ(parallel_mesh(in).transverse_contact_ratio_true, 0.0);
}

// A tip beyond the base tangent point of the mate touches nothing there.
TEST(ParallelMesh, path_is_clipped_at_the_base_tangents) {
  auto in = spur(8, 120);
  const auto m = parallel_mesh(in);
  EXPECT_LT(m.rho1_A, 0.0);
  EXPECT_EQ(m.rho1_true_begin, 0.0);
  EXPECT_FALSE(specific_sliding(in, m, m.rho1_A).zeta_1);
  EXPECT_FALSE(specific_sliding(in, m, 0.0).zeta_2);
}

// j_bn by hand: base pitch less both base thicknesses plus twice the string between them.
TEST(ParallelMesh, backlash) {
  for (const int z2 : {40, -60}) {
    auto in = spur(20, z2);
    const double sigma = z2 > 0 ? 1.0 : -1.0;
    in.base_thickness_1 -= 0.05;
    in.center_distance += sigma * 0.1;
    const auto m = parallel_mesh(in);
    const double sum = in.base_radius_2 + sigma * in.base_radius_1;
    const double by_hand = 2 * kPi * in.base_radius_1 / 20 - in.base_thickness_1 -
                           in.base_thickness_2 +
                           sigma * 2 * sum * involute(std::acos(sum / in.center_distance));
    EXPECT_NEAR(m.backlash_normal_base, by_hand, 1e-12);
    EXPECT_GT(m.backlash_normal_base, 0.0);
    EXPECT_NEAR(m.backlash_normal,
                m.backlash_normal_base / std::cos(m.working_normal_pressure_angle), 1e-14);
    EXPECT_NEAR(m.backlash_circumferential, m.backlash_rotation_1 * m.working_pitch_radius_1,
                1e-14);
    EXPECT_NEAR(m.backlash_circumferential, m.backlash_rotation_2 * m.working_pitch_radius_2,
                1e-14);
  }
}

// At the distance whose involute the thicknesses ask for, nothing is left over.
TEST(ParallelMesh, backlash_free_involute_is_that) {
  auto in = spur(20, 40);
  in.base_thickness_1 += 0.4;
  const double alpha = inverse_involute(backlash_free_involute(in));
  in.center_distance = base_radius_sum(in) / std::cos(alpha);
  EXPECT_NEAR(parallel_mesh(in).backlash_normal_base, 0.0, 1e-13);
  in.base_thickness_1 -= 5.0;
  EXPECT_LT(backlash_free_involute(in), 0.0);
}

TEST(SpecificSliding, signs_and_the_pitch_point) {
  const auto in = spur(20, 40);
  const auto m = parallel_mesh(in);
  const auto at_A = specific_sliding(in, m, m.rho1_A);
  EXPECT_LT(*at_A.zeta_1, 0.0);  // the pinion's root is dragged
  EXPECT_GT(*at_A.zeta_2, 0.0);
  const auto at_E = specific_sliding(in, m, m.rho1_E);
  EXPECT_GT(*at_E.zeta_1, 0.0);
  EXPECT_LT(*at_E.zeta_2, 0.0);
  const auto at_C = specific_sliding(in, m, m.rho1_C);
  EXPECT_NEAR(*at_C.zeta_1, 0.0, 1e-14);
  EXPECT_NEAR(*at_C.zeta_2, 0.0, 1e-14);
  // (1 − ζ1)(1 − ζ2) = 1: the two are one velocity ratio, seen from either side.
  EXPECT_NEAR((1 - *at_A.zeta_1) * (1 - *at_A.zeta_2), 1.0, 1e-14);
}

TEST(ParallelMesh, helical_overlap) {
  auto in = spur(20, 40);
  in.base_helix_angle = 0.25;
  const auto m = parallel_mesh(in);
  EXPECT_NEAR(m.overlap_ratio, 20.0 * std::tan(0.25) / (2 * kPi * std::cos(kAlpha)), 1e-14);
  EXPECT_NEAR(std::sin(m.working_normal_pressure_angle), std::sin(kAlpha) * std::cos(0.25), 1e-15);
  EXPECT_NEAR(std::tan(m.working_helix_angle), std::tan(0.25) / std::cos(kAlpha), 1e-15);
}

TEST(ParallelMeshDeathTest, no_working_angle_is_for_the_caller_to_refuse) {
  auto in = spur(20, 40);
  in.center_distance = base_radius_sum(in);
  EXPECT_DEATH(parallel_mesh(in), "precondition");
}

}  // namespace
}  // namespace gearwright
