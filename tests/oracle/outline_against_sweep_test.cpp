// Tests the comparison itself: a correct outline must pass, and every kind of fault must be
// detected.
#include "tests/oracle/outline_against_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/oracle/numbers.hpp"
#include "tests/oracle/rolled_edge.hpp"

namespace gearwright::oracle {
namespace {

RackNumbers gear() {
  return {.teeth = 40,
          .normal_module = 2.0,
          .normal_pressure_angle = kPi / 9,
          .helix_angle = kPi / 10,
          .profile_shift = 0.3,
          .root_fillet_radius = 0.3};
}

/// Root land, fillet and flank with 20 points each. Joints are doubled, as in an outline of arcs.
std::vector<PlanePoint> outline(const RackNumbers& n) {
  std::vector<PlanePoint> points;
  const double a = n.normal_pressure_angle;
  const PlanePoint foot = rolled(n, on_tip_rounding(n, kPi / 2));
  const double r_f = std::hypot(foot.x, foot.y), edge = std::atan2(foot.y, foot.x);
  for (int i = 0; i < 20; ++i) {
    const double angle = kPi / n.teeth + (edge - kPi / n.teeth) * i / 19;
    points.push_back({r_f * std::cos(angle), r_f * std::sin(angle)});
  }
  for (int i = 0; i < 20; ++i) {
    points.push_back(rolled(n, on_tip_rounding(n, kPi / 2 + (a - kPi / 2) * i / 19)));
  }
  const double start = on_tip_rounding(n, a).h;
  for (int i = 0; i < 20; ++i) {
    points.push_back(rolled(n, on_flank(n, start + (2.0 - start) * i / 19)));
  }
  return points;
}

TEST(OutlineAgainstSweep, a_right_outline_holds) {
  const OutlineAgainstSweep result = outline_against_sweep(outline(gear()), SweptRack(gear()));
  EXPECT_TRUE(result.holds(1e-12)) << result.worst << " at " << result.worst_index;
  // The measured clearance of a nudge is the nudge itself or, in the metric of the normal section,
  // the nudge times cos β.
  EXPECT_GT(result.min_inward, 0.9 * kNudge * std::cos(kPi / 10));
  EXPECT_LT(result.max_outward, -0.9 * kNudge * std::cos(kPi / 10));
  EXPECT_LT(result.longest_step, 0.5);
}

TEST(OutlineAgainstSweep, a_point_off_by_a_nanometre_is_named) {
  for (const std::size_t i : {5u, 30u, 50u}) {
    std::vector<PlanePoint> points = outline(gear());
    points[i].y += 1e-6;
    const OutlineAgainstSweep result = outline_against_sweep(points, SweptRack(gear()));
    EXPECT_FALSE(result.holds(1e-8));
    EXPECT_EQ(result.worst_index, i);
  }
}

// If one value is changed, the outline must not be accepted for the original gear.
TEST(OutlineAgainstSweep, another_gear_is_refused) {
  const SweptRack rack(gear());
  RackNumbers shifted = gear(), rounder = gear(), deeper = gear();
  shifted.profile_shift += 1e-6;
  rounder.root_fillet_radius += 1e-6;
  deeper.dedendum += 1e-6;
  for (const RackNumbers& n : {shifted, rounder, deeper}) {
    EXPECT_GT(outline_against_sweep(outline(n), rack).worst, 1e-7);
  }
}

// If the gear is undercut, the rolled flank below the intersection with the fillet is a loop that
// has been cut away.
TEST(OutlineAgainstSweep, a_swallowed_loop_is_refused) {
  RackNumbers n = gear();
  n.teeth = 9;
  n.profile_shift = 0;
  const OutlineAgainstSweep result = outline_against_sweep(outline(n), SweptRack(n));
  EXPECT_GT(result.worst, 1e-4);
  EXPECT_FALSE(result.holds(1e-4));
}

// If the outline is followed from tip to root, inside and outside are exchanged. The nudges must
// detect this, although every point is on the surface.
TEST(OutlineAgainstSweep, the_wrong_side_is_refused) {
  std::vector<PlanePoint> points = outline(gear());
  std::reverse(points.begin(), points.end());
  const OutlineAgainstSweep result = outline_against_sweep(points, SweptRack(gear()));
  EXPECT_LE(result.worst, 1e-12);
  EXPECT_FALSE(result.holds(1e-12));
}

TEST(OutlineAgainstSweep, not_a_number_is_refused) {
  std::vector<PlanePoint> points = outline(gear());
  points[40].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(outline_against_sweep(points, SweptRack(gear())).holds(1.0));
}

struct Method {
  double a, b;
  double x() const { return a; }
  double y() const { return b; }
};

// Points with x() and y() are accepted, and a tooth that ends in a point passes.
TEST(OutlineAgainstSweep, pointed_tooth_of_another_point_type) {
  const RackNumbers n = gear();
  const SweptRack rack(n);
  double lo = 2.0,
         hi = 8.0;  // heights between which the involute meets the centre line
  for (int i = 0; i < 100; ++i) {
    const double mid = 0.5 * (lo + hi);
    (rolled(n, on_flank(n, mid)).y > 0 ? lo : hi) = mid;
  }
  std::vector<Method> points;
  for (int i = 0; i <= 20; ++i) {
    const PlanePoint p = rolled(n, on_flank(n, lo * i / 20));
    points.push_back({p.x, p.y});
  }
  const OutlineAgainstSweep result = outline_against_sweep(points, rack);
  EXPECT_TRUE(result.holds(1e-12)) << result.worst << " " << result.worst_index << " "
                                   << result.min_inward << " " << result.max_outward;
}

}  // namespace
}  // namespace gearwright::oracle
