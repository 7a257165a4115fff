#include "gearwright/pair/arc_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/numbers.hpp"

namespace gearwright {
namespace {

using testing::kDegree;

ArcMeshInput mesh(double change = 0.0) {
  const double psi = 30 * kDegree;
  const double b = 1.2, difference = 0.75;
  ArcMeshInput in;
  in.convex = {7.0, b / std::tan(psi), b};
  in.concave = {7.0 + difference, in.convex.a + difference * std::cos(psi),
                b + difference * std::sin(psi)};
  in.pitch_radius_convex = 53.0;
  in.pitch_radius_concave = 160.0;
  in.lead_angle = Angle::degrees(70);
  in.center_distance = in.pitch_radius_convex + in.pitch_radius_concave + change;
  return in;
}

// [T7.9]: at the reference distance sin θ = (b_P − b_F)/(ρ_P − ρ_F), and neither gear is ahead.
TEST(ArcContact, nominal) {
  const ArcMeshInput in = mesh();
  const auto theta = contact_angle(in);
  ASSERT_TRUE(theta);
  EXPECT_NEAR(theta->rad(), 30 * kDegree, 1e-15);
  const ArcContact at = arc_contact(in, *theta);
  EXPECT_NEAR(at.mu.rad(), 0.0, 1e-16);
  EXPECT_NEAR(at.rotation_offset.rad(), 0.0, 1e-16);
  EXPECT_GT(at.gap[0], 0.0);
  // The normal intersects the line through the pitch point parallel to the axes, so its moment
  // about this line is 0.
  const Vec3 arm = at.point - Vec3(in.pitch_radius_convex, 0.0, 0.0);
  EXPECT_NEAR(arm.x() * at.normal.y() - arm.y() * at.normal.x(), 0.0, 1e-14);
}

// If both arcs grow by the same amount, they touch at the same angle, and the contact point moves
// along the normal.
TEST(ArcContact, parallel_surfaces_touch_alike) {
  for (const double change : {0.0, 0.05, -0.04}) {
    ArcMeshInput in = mesh(change);
    const ArcContact at = arc_contact(in, *contact_angle(in));
    in.convex.radius += 0.6;
    in.concave.radius += 0.6;
    const ArcContact grown = arc_contact(in, *contact_angle(in));
    EXPECT_NEAR(grown.theta.rad(), at.theta.rad(), 1e-12);
    EXPECT_NEAR(grown.rotation_offset.rad(), at.rotation_offset.rad(), 1e-14);
    EXPECT_NEAR((grown.point - at.point - 0.6 * at.normal).norm(), 0.0, 1e-12);
  }
}

// If both centres move along the datum line, the contact point moves parallel to the axes by their
// displacement divided by cos λ. The contact angle and the rotation offset do not change.
TEST(ArcContact, a_shift_along_the_datum_line_is_one_of_phase) {
  ArcMeshInput in = mesh(0.05);
  const ArcContact at = arc_contact(in, *contact_angle(in));
  in.convex.a += 0.3;
  in.concave.a += 0.3;
  const ArcContact moved = arc_contact(in, *contact_angle(in));
  EXPECT_EQ(moved.theta, at.theta);
  EXPECT_NEAR(at.point.z() - moved.point.z(), 0.3 / std::cos(in.lead_angle.rad()), 1e-12);
  // The rotation offset is unchanged, because both flanks move by the same distance.
  EXPECT_NEAR(moved.rotation_offset.rad(), at.rotation_offset.rad(), 1e-15);
}

// For small changes of the centre distance, the exact angle tends to the first-order angle [T7.17].
TEST(ArcContact, small_changes_are_of_first_order) {
  for (const double change : {1e-4, -1e-4, 1e-6}) {
    const ArcMeshInput in = mesh(change);
    const double first = std::asin(0.5 - change / 0.75);
    EXPECT_NEAR(contact_angle(in)->rad(), first, 2 * change * change);
  }
}

TEST(ArcContact, there_is_none_where_the_arcs_have_no_common_normal) {
  EXPECT_FALSE(contact_angle(mesh(0.376)));   // sin θ < 0
  EXPECT_FALSE(contact_angle(mesh(-0.376)));  // sin θ > 1
  EXPECT_TRUE(contact_angle(mesh(0.37)));
  EXPECT_TRUE(contact_angle(mesh(-0.37)));
}

// Two gears cut by the same rack are in line contact. Their transverse profiles satisfy the
// Euler-Savary equation [T7.10], and the surfaces separate on both sides of the line.
TEST(ArcContact, one_rack_for_both_gears_means_line_contact) {
  for (const double b : {-0.5, 0.0, 0.9, 2.4}) {
    for (const double theta : {0.2, 0.5, 0.9}) {
      for (const double lambda : {50 * kDegree, 75 * kDegree, 85 * kDegree}) {
        ArcMeshInput in = mesh();
        in.lead_angle = Angle::radians(lambda);
        in.convex.b = in.concave.b = b;
        in.concave.radius = in.convex.radius;
        const ArcContact at = arc_contact(in, Angle::radians(theta));
        const double difference = at.transverse_radius_concave - at.transverse_radius_convex;
        EXPECT_NEAR(difference, at.line_contact_difference,
                    1e-9 * std::max(1.0, std::abs(difference)));
        const double greatest = std::max(std::abs(at.gap[0]), std::abs(at.gap[1]));
        EXPECT_NEAR(std::min(std::abs(at.gap[0]), std::abs(at.gap[1])), 0.0,
                    1e-12 + 1e-10 * greatest);
      }
    }
  }
}

// K equals the curvature of the surface, computed from differences of the normals.
TEST(ArcContact, curvature_is_the_change_of_the_normal) {
  const double rho = 7.0, b = 1.2, a = 2.0, lambda = 70 * kDegree, r = 53.0;
  const double s = std::sin(lambda), c = std::cos(lambda);
  for (const double turn : {1.0, -1.0}) {
    const auto point = [&](double th, double phi) {
      const double x = rho * std::sin(th) - b;
      const double u = x / std::tan(th) * s;
      const double R = turn * r + x;
      const double z =
          rho * std::cos(th) * c - a / c + b / std::tan(th) * s * s / c + r * phi * s / c;
      const double q = turn * phi;
      return Vec3(R * std::cos(q) + u * std::sin(q), R * std::sin(q) - u * std::cos(q), z);
    };
    const auto normal = [&](double th, double phi) {
      const double q = turn * phi;
      const double nx = std::sin(th), ny = -std::cos(th) * s;
      return Vec3(nx * std::cos(q) - ny * std::sin(q), nx * std::sin(q) + ny * std::cos(q),
                  std::cos(th) * c);
    };
    const double th = 0.6, h = 1e-5;
    const Vec3 t(std::cos(th), std::sin(th) * s, -std::sin(th) * c), u(0.0, c, s);
    const Mat2 k = cut_curvature(rho, b, th, lambda, r, turn);
    for (const bool along_theta : {true, false}) {
      const double d_th = along_theta ? h : 0.0, d_phi = along_theta ? 0.0 : h;
      const Vec3 dr = (point(th + d_th, d_phi) - point(th - d_th, -d_phi)) / (2 * h);
      const Vec3 dn = (normal(th + d_th, d_phi) - normal(th - d_th, -d_phi)) / (2 * h);
      const Vec2 want = -k * Vec2(dr.dot(t), dr.dot(u));
      EXPECT_NEAR(dr.dot(normal(th, 0.0)), 0.0, 1e-7);
      EXPECT_NEAR(dn.dot(t), want.x(), 1e-8);
      EXPECT_NEAR(dn.dot(u), want.y(), 1e-8);
    }
  }
}

}  // namespace
}  // namespace gearwright
