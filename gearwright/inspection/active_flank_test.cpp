// The part of a flank that the mating gear touches is compared with the formula of the handbook.
#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {
namespace {

Gear gear_of(int teeth, double beta_deg, double x, double tip = 0.0) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = teeth, .module = 2.5, .beta_deg = beta_deg, .x = x, .face_width = 25});
  if (tip != 0.0) s.tip_diameter = tip;
  return testing::taken(make_gear(s));
}

// d_Nf from the tip of the mating gear is √((2 a sin α_wt − √(d_Fa2² − d_b2²))² + d_b1²). For a
// ring, the difference becomes the sum 2 a sin α_wt + √(d_Fa1² − d_b1²).
double by_hand(double base, double mate_base, double mate_tip, double twice_a_sin, double sigma) {
  const double mate = std::sqrt(mate_tip * mate_tip - mate_base * mate_base);
  return std::hypot(base, sigma * (twice_a_sin - mate));
}

TEST(ActiveFlank, of_external_gears_by_hand) {
  for (const double beta : {0.0, 15.0}) {
    const auto pair = testing::taken(mount_as<ParallelPair>(
        gear_of(23, beta, 0.2), gear_of(43, -beta, 0.1), {.center_distance = {}}));
    const auto& g = pair.gears;
    const double d_b1 = 2 * g[0].base_radius(), d_b2 = 2 * g[1].base_radius();
    const double a = pair.center_distance;
    const double twice = std::sqrt(4 * a * a - (d_b1 + d_b2) * (d_b1 + d_b2));
    const auto one = active_flank(pair, 1), two = active_flank(pair, 2);
    ASSERT_TRUE(one && two);
    EXPECT_NEAR(one->root.diameter, by_hand(d_b1, d_b2, g[1].tip_diameter, twice, 1), 1e-9);
    EXPECT_NEAR(two->root.diameter, by_hand(d_b2, d_b1, g[0].tip_diameter, twice, 1), 1e-9);
    EXPECT_NEAR(one->tip.diameter, g[0].tip_diameter, 1e-9);
    EXPECT_NEAR(two->tip.diameter, g[1].tip_diameter, 1e-9);
    // [T10.22] holds for the active diameters as it does for any other diameter.
    for (const RollPlace& p : {one->root, one->tip}) {
      const RollPlace same = roll_place(g[0], p.diameter);
      EXPECT_NEAR(p.length, same.length, 1e-9);
      EXPECT_NEAR(p.angle, same.angle, 1e-10);
    }
  }
}

TEST(ActiveFlank, of_a_ring_and_its_pinion) {
  const auto pair =
      testing::taken(mount_as<ParallelPair>(gear_of(23, 0, 0.2), gear_of(-60, 0, 0.2, 147.0), {}));
  const auto& g = pair.gears;
  const double d_b1 = 2 * g[0].base_radius(), d_b2 = 2 * g[1].base_radius();
  const double a = pair.center_distance;
  const double twice = std::sqrt(4 * a * a - (d_b2 - d_b1) * (d_b2 - d_b1));
  const auto one = active_flank(pair, 1), two = active_flank(pair, 2);
  ASSERT_TRUE(one && two);
  const double tip_1 = 2 * g[0].tip_form_radius();
  const double pinion_tip = std::sqrt(tip_1 * tip_1 - d_b1 * d_b1);
  EXPECT_NEAR(one->root.diameter, by_hand(d_b1, d_b2, 2 * g[1].tip_form_radius(), twice, -1), 1e-9);
  EXPECT_NEAR(two->root.diameter, std::hypot(d_b2, twice + pinion_tip), 1e-9);
  EXPECT_GT(two->root.diameter, two->tip.diameter);
}

TEST(ActiveFlank, ends_where_the_flank_itself_ends) {
  // On an undercut gear, contact cannot begin below d_Ff, although the mating tip reaches below it.
  const auto pair =
      testing::taken(mount_as<ParallelPair>(gear_of(9, 0, -0.1), gear_of(80, 0, 0.0), {}));
  const auto one = active_flank(pair, 1), two = active_flank(pair, 2);
  ASSERT_TRUE(one && two);
  EXPECT_NEAR(one->root.diameter, 2 * *pair.gears[0].root_form_radius(), 1e-9);
  EXPECT_LT(two->tip.diameter, pair.gears[1].tip_diameter);
}

TEST(ActiveFlank, none_of_gears_that_do_not_touch) {
  const auto pair = testing::taken(
      mount_as<ParallelPair>(gear_of(23, 0, 0.2), gear_of(43, 0, 0.1), {.center_distance = 92.0}));
  EXPECT_FALSE(active_flank(pair, 1));
}

}  // namespace
}  // namespace gearwright
