// Tests the closed-form reference geometry with printed values and with laws that hold to the last
// bit.
#include "gearwright/gear/reference.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

using testing::kDegree;
using testing::kEps;

ReferenceInput<double> helical() { return {17, 2.5, 20 * kDegree, 15 * kDegree, 0.3, 0.0}; }

TEST(Reference, helical_gear_by_hand) {
  const auto g = reference_geometry(helical());
  const double cb = std::cos(15 * kDegree), alpha_t = std::atan(std::tan(20 * kDegree) / cb);
  EXPECT_NEAR(g.transverse_module, 2.5 / cb, 4 * kEps * 3);
  EXPECT_NEAR(g.transverse_pressure_angle, alpha_t, 2 * kEps);
  EXPECT_NEAR(g.reference_diameter, 17 * 2.5 / cb, 2 * kEps * 44);
  EXPECT_NEAR(g.base_diameter, 17 * 2.5 / cb * std::cos(alpha_t), 2 * kEps * 41);
  // tan β_b = tan β cos α_t is the second of the two formulas of ISO.
  EXPECT_NEAR(std::tan(g.base_helix_angle), std::tan(15 * kDegree) * std::cos(alpha_t), 4 * kEps);
  EXPECT_NEAR(g.base_pitch_normal, kPi * 2.5 * std::cos(20 * kDegree), 4 * kEps * 8);
  EXPECT_NEAR(g.base_pitch_transverse * std::cos(g.base_helix_angle), g.base_pitch_normal,
              8 * kEps * 8);
  EXPECT_NEAR(g.reference_tooth_thickness_normal, 2.5 * (kPi / 2 + 0.6 * std::tan(20 * kDegree)),
              4 * kEps * 5);
  // The base thickness follows from the involutes through the ends of the reference thickness.
  EXPECT_NEAR(g.base_tooth_thickness / g.base_diameter,
              g.reference_tooth_thickness_transverse / g.reference_diameter + involute(alpha_t),
              4 * kEps);
}

TEST(Reference, base_cylinder_does_not_know_the_shift) {
  ReferenceInput<double> in = helical();
  const auto a = reference_geometry(in);
  in.profile_shift = -0.7;
  in.thickness_allowance = -0.1;
  const auto b = reference_geometry(in);
  EXPECT_EQ(a.base_diameter, b.base_diameter);
  EXPECT_EQ(a.base_helix_angle, b.base_helix_angle);
  EXPECT_EQ(a.base_pitch_transverse, b.base_pitch_transverse);
}

// An allowance is a shift of the cutter, so a gear with the shift x_E and no allowance has the same
// tooth.
TEST(Reference, allowance_is_a_shift) {
  ReferenceInput<double> allowed = helical();
  allowed.thickness_allowance = -0.12;
  const auto a = reference_geometry(allowed);
  ReferenceInput<double> shifted = helical();
  shifted.profile_shift = a.generating_profile_shift;
  const auto b = reference_geometry(shifted);
  EXPECT_NEAR(a.base_tooth_thickness, b.base_tooth_thickness, 8 * kEps * a.base_diameter);
  EXPECT_EQ(reference_geometry(helical()).generating_profile_shift, 0.3);
}

// The space of an internal gear equals the tooth of an external gear with the same data. At x = 0,
// the base thicknesses of both gears add up to the pitch.
TEST(Reference, ring_and_pinion_of_the_same_numbers_fill_the_pitch) {
  ReferenceInput<double> in = helical();
  in.profile_shift = 0.0;
  const auto pinion = reference_geometry(in);
  in.teeth = -17;
  const auto ring = reference_geometry(in);
  EXPECT_EQ(ring.reference_diameter, pinion.reference_diameter);
  EXPECT_EQ(ring.base_diameter, pinion.base_diameter);
  EXPECT_NEAR(ring.base_tooth_thickness + pinion.base_tooth_thickness, pinion.base_pitch_transverse,
              8 * kEps * pinion.base_diameter);
}

TEST(Reference, spur_is_exact) {
  const auto g = reference_geometry<double>({20, 2.0, 20 * kDegree, 0.0, 0.0, 0.0});
  EXPECT_EQ(g.transverse_module, 2.0);
  EXPECT_EQ(g.transverse_pressure_angle, 20 * kDegree);
  EXPECT_EQ(g.base_helix_angle, 0.0);
  EXPECT_EQ(g.reference_diameter, 40.0);
}

TEST(ToothThickness, on_the_reference_circle_and_at_the_point) {
  const auto g = reference_geometry(helical());
  EXPECT_NEAR(
      tooth_thickness_transverse(17, g.base_diameter, g.base_tooth_thickness, g.reference_diameter),
      g.reference_tooth_thickness_transverse, 16 * kEps * g.reference_diameter);
  EXPECT_EQ(
      tooth_thickness_transverse(17, g.base_diameter, g.base_tooth_thickness, g.base_diameter),
      g.base_tooth_thickness);
  const double pointed =
      g.base_diameter / std::cos(inverse_involute(g.base_tooth_thickness / g.base_diameter));
  EXPECT_NEAR(tooth_thickness_transverse(17, g.base_diameter, g.base_tooth_thickness, pointed), 0.0,
              64 * kEps * pointed);
  // The teeth of an internal gear become thicker outward.
  EXPECT_GT(tooth_thickness_transverse(-40, 80.0, 3.0, 84.0), 3.0);
}

TEST(CosHelix, is_that_of_the_reference_cylinder_there) {
  const auto g = reference_geometry(helical());
  EXPECT_NEAR(cos_helix_at(g.base_diameter, g.base_helix_angle, g.reference_diameter),
              std::cos(15 * kDegree), 4 * kEps);
  EXPECT_EQ(cos_helix_at(40.0, 0.0, 44.0), 1.0);
}

TEST(ReferenceDeathTest, numbers_that_are_no_gear) {
  GW_EXPECT_VIOLATION(reference_geometry<double>({0, 2.0, 0.3, 0.0, 0.0, 0.0}));
  GW_EXPECT_VIOLATION(reference_geometry<double>({20, 0.0, 0.3, 0.0, 0.0, 0.0}));
  GW_EXPECT_VIOLATION(tooth_thickness_transverse(20, 40.0, 3.0, 39.0));
}

}  // namespace
}  // namespace gearwright
