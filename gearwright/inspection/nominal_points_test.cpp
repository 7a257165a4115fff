// Compares points for a measuring machine with points of a string unwound from the base cylinder,
// and normals with difference quotients.
#include "gearwright/inspection/nominal_points.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

namespace gearwright {
namespace {

Gear module_3_gear(int teeth, double beta_deg, double x) {
  return testing::taken(make_gear(testing::plain_spec(
      {.teeth = teeth, .module = 3, .beta_deg = beta_deg, .x = x, .face_width = 30})));
}

RemovalField field_of(const Gear& gear, const FlankModifications& m) {
  const auto flank = usable_flank(gear);
  return testing::taken(make_removal_field(
      m, {gear.base_radius(), flank->root_end / 2, flank->tip_end / 2, gear.spec.face_width}));
}

// The point of the flank at a roll angle and a height, computed from the data of the drawing with
// more digits.
Vec3 unwound(const Gear& gear, FlankSide side, double roll, double z) {
  const CylindricalSpec& s = gear.spec;
  const long double beta = s.helix_angle.rad(), alpha = s.normal_pressure_angle.rad();
  const long double sign = s.teeth > 0 ? 1 : -1;
  const long double alpha_t = std::atan(std::tan(alpha) / std::cos(beta));
  const long double r = std::abs(s.teeth) * s.normal_module / std::cos(beta) / 2;
  const long double s_t = s.normal_module *
                          (testing::kLongPi / 2 + 2 * s.profile_shift * std::tan(alpha)) /
                          std::cos(beta);
  const long double half = s_t / (2 * r) + sign * (std::tan(alpha_t) - alpha_t);
  const long double xi = roll, rho = r * std::cos(alpha_t) * std::sqrt(1 + xi * xi);
  const long double theta =
      (side == FlankSide::left ? 1 : -1) * (half - sign * (xi - std::atan(xi))) +
      z * std::tan(beta) / r;
  return {double(rho * std::cos(theta)), double(rho * std::sin(theta)), z};
}

TEST(NominalPoints, lie_on_the_unwound_flank) {
  for (const int teeth : {17, 40, -60}) {
    for (const double beta : {0.0, 22.0, -14.0}) {
      const Gear gear = module_3_gear(teeth, beta, 0.1);
      const RemovalField none = field_of(gear, {});
      for (const FlankSide side : {FlankSide::right, FlankSide::left}) {
        const auto ranges = evaluation_ranges(gear);
        ASSERT_TRUE(ranges);
        const auto points = nominal_points(gear, none, side, *ranges, {9, 5});
        EXPECT_EQ(points.size(), 45u);
        for (const NominalPoint& p : points) {
          const double rho = p.diameter / 2;
          const double roll =
              std::sqrt(rho * rho - gear.base_radius() * gear.base_radius()) / gear.base_radius();
          EXPECT_NEAR((p.point - unwound(gear, side, roll, p.height)).norm(), 0.0, 1e-11);
          // The normal points out of the material, which is to the left on a left flank.
          EXPECT_NEAR(p.normal.norm(), 1.0, 1e-15);
          const Vec3 around = Vec3(0, 0, 1).cross(p.point);
          EXPECT_GT(p.normal.dot(around) * (side == FlankSide::left ? 1 : -1), 0.0);
          // The normal is perpendicular to both tangents of the surface, which are difference
          // quotients.
          const double h = 1e-6;
          const Vec3 du =
              unwound(gear, side, roll + h, p.height) - unwound(gear, side, roll - h, p.height);
          const Vec3 dz =
              unwound(gear, side, roll, p.height + h) - unwound(gear, side, roll, p.height - h);
          EXPECT_NEAR(p.normal.dot(du.normalized()), 0.0, 1e-7);
          EXPECT_NEAR(p.normal.dot(dz.normalized()), 0.0, 1e-7);
        }
      }
    }
  }
}

TEST(NominalPoints, of_a_modified_flank_have_its_normals) {
  FlankModifications m;
  m.profile_crowning = 0.05;
  m.lead_crowning = 0.04;
  m.profile_slope = 0.03;
  for (const double beta : {0.0, 25.0}) {
    const Gear gear = module_3_gear(25, beta, 0.2);
    const RemovalField field = field_of(gear, m), none = field_of(gear, {});
    for (const FlankSide side : {FlankSide::right, FlankSide::left}) {
      for (const double roll : {0.35, 0.45}) {
        const double z = 7.0, h = 1e-4;
        const NominalPoint p = nominal_point(gear, field, side, roll, z);
        const NominalPoint plain = nominal_point(gear, none, side, roll, z);
        const double c = field.at(std::log(plain.diameter / 2), z).c;
        EXPECT_NEAR((plain.point - p.point).dot(plain.normal), c, 1e-12);
        const auto at = [&](double u, double w) {
          return nominal_point(gear, field, side, u, w).point;
        };
        const Vec3 du = at(roll + h, z) - at(roll - h, z), dz = at(roll, z + h) - at(roll, z - h);
        EXPECT_NEAR(p.normal.dot(du.normalized()), 0.0, 1e-7);
        EXPECT_NEAR(p.normal.dot(dz.normalized()), 0.0, 1e-7);
        EXPECT_GT((p.normal - plain.normal).norm(), 1e-4);  // the section is rotated
      }
    }
  }
}

}  // namespace
}  // namespace gearwright
