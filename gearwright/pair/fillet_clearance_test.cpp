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

// Computes the least distance between 2000 points of the fillet of gear 1 and 4000 positions of
// both tip corners of gear 2. The fillet is on the side y > 0 of tooth 0, in the frame of gear 1 in
// which tooth 0 lies on the x axis. The pair has no backlash, so both flanks touch and no play is
// considered.
double scanned(const ParallelPair& p) {
  const Gear& g1 = p.gears[0];
  const Gear& g2 = p.gears[1];
  std::vector<Vec2> fillet;
  for (const Arc& arc : g1.tooth->outline.arcs) {
    if (arc.name != ArcName::root_fillet) continue;
    for (const Vec2& q : sample(arc, 2000)) fillet.push_back(q);
  }
  const Vec2 corner = g2.tooth->outline.arcs.back().begin_point;  // the start of the tip land
  const double rho = corner.norm(), theta = std::atan2(corner.y(), corner.x());
  const double z1 = g1.spec.teeth, z2 = g2.spec.teeth;
  double least = std::numeric_limits<double>::infinity();
  for (int i = -2000; i <= 2000; ++i) {
    // At rest, tooth 0 of gear 2 lies in the space of gear 1 that is half a pitch above tooth 0.
    const double turn_2 = std::numbers::pi / z2 * i / 1000;
    const double turn_1 = -turn_2 * z2 / z1;
    for (const double side : {-1.0, 1.0}) {
      const double angle = std::numbers::pi + turn_2 + side * theta;
      const Vec2 c(p.center_distance + rho * std::cos(angle), rho * std::sin(angle));
      // Transforms the corner to the frame of tooth 0 of gear 1, which is half a pitch beside the
      // space.
      const double back = -turn_1 + std::numbers::pi / z1;
      const Vec2 q(c.x() * std::cos(back) - c.y() * std::sin(back),
                   c.x() * std::sin(back) + c.y() * std::cos(back));
      if (q.norm() > g1.tooth->outline.find(ArcName::flank)->begin_point.norm()) continue;
      for (const Vec2& f : fillet) least = std::min(least, (q - f).norm());
    }
  }
  return least;
}

// The scanned distance is never too small. It is too large by at most half a step of the fillet and
// half a step of the corner. There are 2000 steps on 1.5 mm of the fillet, and 2000 on the 1.5 mm
// that the corner moves through a space.
TEST(FilletClearance, agrees_with_a_scan) {
  for (const auto& [z1, z2, fillet] : {std::tuple{20, 40, 0.38}, {30, 30, 0.25}, {17, 90, 0.38}}) {
    const ParallelPair p = mounted(filleted(z1, 0.0, fillet), filleted(z2, 0.0, fillet), z1 + z2);
    const auto clearance = fillet_clearance(p, 1);
    ASSERT_TRUE(clearance);
    const double scan = scanned(p);
    EXPECT_LE(*clearance, scan + 1e-12) << z1 << " " << z2;
    EXPECT_GE(*clearance, scan - 1e-3) << z1 << " " << z2;
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
