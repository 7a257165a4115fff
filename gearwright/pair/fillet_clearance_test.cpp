// Compares the least distance between the path of a tip corner and the mating root fillet with a
// scan that turns the gears step by step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/testing/mounted.hpp"

namespace gearwright {
namespace {

using namespace literals;
using testing::mounted;

Gear filleted(int teeth, double x = 0.0, double fillet = 0.38, double tip = 0.0) {
  CylindricalSpec s =
      testing::plain_spec({.teeth = teeth, .module = 2.0, .x = x, .face_width = 20.0});
  s.straight_rack().root_fillet_radius = fillet;
  if (tip > 0.0) s.tip_diameter = tip;
  return testing::taken(make_gear(s));
}

// Computes the least distance between 2000 points of the fillet of gear `which` and both tip
// corners of the mating gear, in 1000 positions per pitch. The fillet is on the side y > 0 of its
// tooth. At rest, a tooth of the mating gear is on the line of centres, in the space above this
// tooth. The mesh is at +x of the axis of the gear. The pair has no backlash, so both flanks touch
// and no play is considered.
double scanned(const ParallelPair& p, int which) {
  const Gear& gear = p.gears[which - 1];
  const Gear& mate = p.gears[static_cast<std::size_t>(2 - which)];
  std::vector<Vec2> fillet;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    if (arc.name != ArcName::root_fillet) continue;
    for (const Vec2& q : sample(arc, 2000)) fillet.push_back(q);
  }
  const Vec2 corner = mate.tooth->outline.arcs.back().begin_point;  // the start of the tip land
  const double rho = corner.norm(), theta = std::atan2(corner.y(), corner.x());
  const double z = std::abs(gear.spec.teeth), z_mate = std::abs(mate.spec.teeth);
  const double flank = gear.tooth->outline.find(ArcName::flank)->begin_point.norm();
  const bool external = p.side() > 0.0;
  const double apart = mate.side() * p.center_distance;
  double least = std::numeric_limits<double>::infinity();
  for (int i = -3000; i <= 3000; ++i) {
    const double turn_mate = 2 * std::numbers::pi / z_mate * i / 1000;
    const double turn = turn_mate * z_mate / z * (external ? -1.0 : 1.0);
    for (const double side : {-1.0, 1.0}) {
      const double angle = (external ? std::numbers::pi : 0.0) + turn_mate + side * theta;
      const Vec2 c(apart + rho * std::cos(angle), rho * std::sin(angle));
      // Transforms the corner to the frame of the tooth, which is half a pitch beside the space.
      const double back = -turn + std::numbers::pi / z;
      const Vec2 q(c.x() * std::cos(back) - c.y() * std::sin(back),
                   c.x() * std::sin(back) + c.y() * std::cos(back));
      if (gear.side() * q.norm() > gear.side() * flank) continue;
      for (const Vec2& f : fillet) least = std::min(least, (q - f).norm());
    }
  }
  return least;
}

// The scanned distance is never too small. It is too large by at most half a step of the fillet and
// half a step of the corner. There are 2000 steps on 1.5 mm of the fillet, and 1000 on each 1.5 mm
// that the corner moves through a space.
// Returns false if no corner reaches the depth of the fillet.
bool expect_scanned(const ParallelPair& p, int which) {
  const auto clearance = fillet_clearance(p, which);
  const double scan = scanned(p, which);
  EXPECT_EQ(clearance.has_value(), std::isfinite(scan)) << p.gears[1].spec.teeth << " " << which;
  if (!clearance) return false;
  EXPECT_GT(*clearance, 0.0) << p.gears[1].spec.teeth << " " << which;
  EXPECT_LE(*clearance, scan + 1e-12) << p.gears[1].spec.teeth << " " << which;
  EXPECT_GE(*clearance, scan - 1e-3) << p.gears[1].spec.teeth << " " << which;
  return true;
}

TEST(FilletClearance, agrees_with_a_scan) {
  for (const auto& [z1, z2, fillet] : {std::tuple{20, 40, 0.38}, {30, 30, 0.25}, {17, 90, 0.38}}) {
    const ParallelPair p = mounted(filleted(z1, 0.0, fillet), filleted(z2, 0.0, fillet), z1 + z2);
    for (const int which : {1, 2}) EXPECT_TRUE(expect_scanned(p, which));
  }
}

TEST(FilletClearance, of_internal_pairs_agrees_with_a_scan) {
  for (const auto& [z1, tip_1, z2, tip_2] :
       {std::tuple{30, 64.3, 90, 177.0}, {20, 44.3, 60, 117.0}, {24, 52.3, 71, 139.0}}) {
    const auto ring = cut_by_default(filleted(-z2, 0.0, 0.38, tip_2));
    ASSERT_TRUE(ring);
    const ParallelPair p = mounted(filleted(z1, 0.0, 0.38, tip_1), *ring, z2 - z1);
    for (const int which : {1, 2}) EXPECT_TRUE(expect_scanned(p, which));
  }
}

TEST(FilletClearance, shrinks_with_the_tip_and_goes_negative) {
  double last = std::numeric_limits<double>::infinity();
  for (const double tip : {83.6, 84.0, 84.4, 84.8, 85.4}) {
    const ParallelPair p = mounted(filleted(20), filleted(40, 0.0, 0.38, tip), 60.0);
    const auto c = fillet_clearance(p, 1);
    ASSERT_TRUE(c);
    EXPECT_LT(*c, last);
    last = *c;
  }
  EXPECT_LT(last, 0.0);
}

TEST(FilletClearance, equal_gears_have_equal_clearances) {
  const ParallelPair p = mounted(filleted(30, 0.1), filleted(30, 0.1), 60.3);
  EXPECT_EQ(*fillet_clearance(p, 1), *fillet_clearance(p, 2));
}

TEST(FilletClearance, a_ring_has_no_fillet_here) {
  const ParallelPair p = mounted(filleted(20), filleted(-60), 40.0);
  EXPECT_FALSE(fillet_clearance(p, 2));
  EXPECT_TRUE(fillet_clearance(p, 1));
}

}  // namespace
}  // namespace gearwright
