#include "gearwright/report/pair_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

// The flank's point at a radius, on the side y > 0 of the tooth at the x axis.
Vec2 flank_point(const Gear& gear, double radius) {
  const Arc* flank = gear.tooth->outline.find(ArcName::flank);
  return flank->curve->point(flank->curve->parameter_at_radius(radius, flank->begin, flank->end));
}

Vec2 turned(const Vec2& p, double angle) {
  return {std::cos(angle) * p.x() - std::sin(angle) * p.y(),
          std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

TEST(MeshPicture, LeadingFlanksMeetAtThePitchPoint) {
  for (const ParallelPair& pair : {testing::helical_pair(), testing::undercut_pair()}) {
    const auto phi = rotation_to_pitch_point(pair);
    const Vec2 C = pair.on_line_of_action(pair.mesh.rho1_C).r.head<2>();
    // Gear 1: the clockwise flank of tooth 0.
    Vec2 p1 = flank_point(pair.gears[0], pair.mesh.rack.sides[0].pitch_radius);
    p1.y() = -p1.y();
    EXPECT_LT((turned(p1, phi[0]) - C).norm(), 1e-9);
    // Gear 2: tooth 1 follows space 0 counter-clockwise and stands below it at −x; its clockwise
    // flank.
    Vec2 p2 = flank_point(pair.gears[1], pair.mesh.rack.sides[1].pitch_radius);
    p2.y() = -p2.y();
    const double pitch = 2 * std::acos(-1.0) / pair.input.gears[1].teeth;
    const Vec3 local(turned(p2, pitch).x(), turned(p2, pitch).y(), 0.0);
    const Vec3 placed = pair.pose_2().isometry() * local;
    const Vec2 axis(pair.center_distance, 0.0);
    EXPECT_LT((axis + turned(placed.head<2>() - axis, phi[1]) - C).norm(), 1e-9);
  }
}

TEST(MeshPicture, PinionInItsRing) {
  const ParallelPair pair = testing::internal_pair();
  const auto phi = rotation_to_pitch_point(pair);
  const Vec2 C = pair.on_line_of_action(pair.mesh.rho1_C).r.head<2>();
  Vec2 p1 = flank_point(pair.gears[0], pair.mesh.rack.sides[0].pitch_radius);
  p1.y() = -p1.y();
  const Vec3 placed = pair.pose_1().isometry() * Vec3(p1.x(), p1.y(), 0.0);
  EXPECT_LT((turned(placed.head<2>(), phi[0]) - C).norm(), 1e-9);
  // Without backlash tooth and space fill each other on the pitch circles.
  const double s_1 = phi[0] * pair.mesh.rack.sides[0].pitch_radius;
  const double s_2 = phi[1] * pair.mesh.rack.sides[1].pitch_radius;
  EXPECT_NEAR(s_2 - s_1, pair.mesh.backlash.circumferential[0] / 2, 1e-9);
}

}  // namespace
}  // namespace gearwright
