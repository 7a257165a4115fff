// The limits of a shift are compared with 40-digit values, and the tip thickness with the reference
// geometry of a gear (gear/). Laws: (1) at an end of the range, one limit is reached exactly; (2)
// the hand of the helix and the index in a table have no effect.
#include "gearwright/design/trial_gear.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "gearwright/design/testing/search_reference.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {
namespace {

using testing::search::kPrinted;
using testing::search::number;
using testing::search::Random;
using testing::search::reference;

SearchProblem problem_with(double tip_thickness, double edge_depth = 1.0) {
  SearchProblem p;
  p.limits.tip_thickness = tip_thickness;
  p.racks[0].undercut_depth = {edge_depth, edge_depth};
  return p;
}

double tip_radius(const TrialGear& g, double x, double k = 0.0) {
  return std::abs(g.r + g.addendum + x + k);
}

// The lower limit of the reference includes undercut only. Tips inside the base circle and tips
// that are too thin raise it here.
TEST(TrialGear, LimitsAreThoseOfTheReference) {
  int empty = 0;
  int raised = 0;
  for (const auto& row : reference().at("shift_limits")) {
    const int z = row.at("z");
    for (const auto& [depth, low] : {std::pair{1.0, "s_min_hF1"}, {1.25, "s_min_hF1.25"}}) {
      for (const auto& [thickness, high] : {std::pair{0.0, "s_max_sa0"},
                                            {0.2, "s_max_sa0.2"},
                                            {0.25, "s_max_sa0.25"},
                                            {0.4, "s_max_sa0.4"}}) {
        const TrialGear g = trial_gear(problem_with(thickness, depth), z, Angle(), 0, 0);
        const double least = number(row.at(low));
        EXPECT_NEAR(leaf::undercut_limit<double>(depth, z, g.sin_transverse, 1.0), least, kPrinted)
            << z;
        EXPECT_NEAR(g.x_max, number(row.at(high)), kPrinted) << z << " " << thickness;
        if (least > number(row.at(high))) {
          ++empty;
          EXPECT_GT(g.x_min, g.x_max);
        } else if (tip_radius(g, least) > g.r_b && tip_thickness(g, least) >= thickness) {
          EXPECT_NEAR(g.x_min, least, kPrinted) << z << " " << thickness;
        } else {
          ++raised;
          EXPECT_GT(g.x_min, least) << z;
        }
      }
    }
  }
  EXPECT_GT(empty, 0);
  EXPECT_GT(raised, 0);
}

// s_an = s_at cos β_a follows from the reference geometry of the gear with the shift x. trial_gear
// computes it from a half angle and its derivative instead.
TEST(TrialGear, ThicknessIsThatOfTheGear) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const bool ring = i % 3 == 0;
    const int z = ring ? -random.whole(20, 150) : random.whole(7, 150);
    const double beta = i % 2 == 0 ? 0.0 : random.uniform(-0.6, 0.6);
    SearchProblem p;
    p.normal_pressure_angle = Angle::radians(random.uniform(0.25, 0.45));
    const TrialGear g = trial_gear(p, z, Angle::radians(beta), 0, 0);
    const double x = random.uniform(-0.5, 0.9);
    const double k = i % 5 == 0 ? -random.uniform(0.0, 0.3) : 0.0;
    const double d_a = 2.0 * tip_radius(g, x, k);
    if (d_a <= 2.0 * std::abs(g.r_b)) continue;
    const auto gear = reference_geometry(
        ReferenceInput<double>{z, 1.0, p.normal_pressure_angle.rad(), beta, x, 0.0});
    const double s_at =
        tooth_thickness_transverse(z, gear.base_diameter, gear.base_tooth_thickness, d_a);
    const double beta_a = std::atan(std::tan(beta) * d_a / gear.reference_diameter);
    // Radii up to 120 modules have rounding errors of 1.4e-14. The slope of the flanks increases
    // the error of the thickness.
    EXPECT_NEAR(tip_thickness(g, x, k), s_at * std::cos(beta_a), 2e-13) << z << " " << beta;
  }
}

// Values of a helical pair and an internal gear. The reference gives them in mm.
TEST(TrialGear, ThicknessIsThatOfTheReference) {
  for (const auto& pair : reference().at("mounted")) {
    const auto& in = pair.at("input");
    const double beta = number(in.at("beta_deg")) * std::acos(-1.0) / 180.0;
    const double m = number(in.at("mn"));
    for (const int i : {0, 1}) {
      const int z = in.at(i == 0 ? "z1" : "z2");
      const TrialGear g = trial_gear(SearchProblem{}, z, Angle::radians(beta), 0, i);
      const double x = number(in.at(i == 0 ? "x1" : "x2"));
      EXPECT_NEAR(tip_thickness(g, x), number(pair.at("tip_thickness_n")[i]) / m, kPrinted)
          << in.dump();
    }
  }
}

// (1) At an end of the range, the tip has the least permissible thickness or lies on the base
//     circle, or undercut is the limit.
TEST(TrialGear, AtTheEndsALimitIsMet) {
  Random random(2);
  int at_base = 0;
  int thin_below = 0;
  int undercut_ends = 0;
  for (int i = 0; i < 3000; ++i) {
    const bool ring = i % 4 == 0;
    const int z = ring ? -random.whole(25, 200) : random.whole(9, 200);
    const double beta = random.chance(0.5) ? random.uniform(-0.5, 0.5) : 0.0;
    SearchProblem p = problem_with(random.uniform(0.0, 0.5), random.uniform(0.9, 1.25));
    p.limits.undercut_margin = random.chance(0.3) ? random.uniform(-1.0, 0.2) : 0.0;
    const TrialGear g = trial_gear(p, z, Angle::radians(beta), 0, 0);
    if (g.x_min > g.x_max) continue;
    const double thin = p.limits.tip_thickness;
    const double undercut =
        leaf::undercut_limit<double>(g.edge_depth, z, g.sin_transverse, std::cos(beta)) +
        p.limits.undercut_margin;
    const auto on_base = [&](double x) {
      return std::abs(tip_radius(g, x) - std::abs(g.r_b)) < 1e-12 * (1.0 + std::abs(g.r_b));
    };
    // At radii of 100 modules, the thickness has an error of 1e-13. Near the base circle its slope
    // is finite, because inv α_a grows as the 3/2 power of the distance.
    const auto thickness_met = [&](double x) {
      return std::abs(tip_thickness(g, x) - thin) < 1e-12;
    };
    EXPECT_TRUE(thickness_met(g.x_max) || (ring && on_base(g.x_max))) << z << " " << beta;
    if (ring) {
      EXPECT_TRUE(thickness_met(g.x_min) || g.x_min == -std::abs(z) - 5.0) << z << " " << beta;
    } else if (g.x_min == undercut) {
      ++undercut_ends;
    } else if (on_base(g.x_min)) {
      ++at_base;
    } else {
      ++thin_below;
      EXPECT_TRUE(thickness_met(g.x_min)) << z << " " << beta << " " << thin;
      EXPECT_GT(g.x_min, undercut);
    }
    EXPECT_GE(tip_radius(g, g.x_min), std::abs(g.r_b));
    EXPECT_GE(tip_radius(g, g.x_max), std::abs(g.r_b));
    for (const double t : {0.01, 0.3, 0.5, 0.7, 0.99}) {
      const double x = g.x_min + t * (g.x_max - g.x_min);
      EXPECT_GE(tip_thickness(g, x), thin) << z << " " << beta << " " << x;
    }
  }
  EXPECT_GT(undercut_ends, 500);
  EXPECT_GT(thin_below, 100);
  EXPECT_GT(at_base, 3);
}

// If the tip is thick enough on the base circle and at x = 0, and the flanks intersect at great x,
// the upper limit is the only root in between, to the last bit. A search of 64 points of the range
// gives a different last bit and takes five times as long.
TEST(TrialGear, TheUpperLimitIsTheOneRoot) {
  const SearchProblem p = problem_with(0.2);
  int seen = 0;
  for (int z = 12; z <= 160; ++z) {
    const TrialGear g = trial_gear(p, z, Angle::radians(z % 2 == 0 ? 0.0 : 0.3), 0, 0);
    const auto margin = [&](double x) { return tip_thickness(g, x) - g.min_tip_thickness; };
    // Slightly beyond the base circle, and at an x beyond z, for which all tips are pointed.
    const double edge =
        g.r_b - g.r - g.addendum + 4.0 * std::numeric_limits<double>::epsilon() * (g.r + 2.0);
    const double hi = edge + (z + 5.0);
    ASSERT_LT(margin(hi), 0.0) << z;
    ASSERT_GT(margin(std::max(edge, 0.0)), 0.0) << z;
    if (margin(edge) < 0.0) continue;  // the tip of a large gear may be too thin on its base circle
    ++seen;
    EXPECT_EQ(g.x_max, find_root(margin, std::max(edge, 0.0), hi).x) << z;
  }
  EXPECT_GT(seen, 50);
}

TEST(TrialGear, FloorAndCeilingCutTheRange) {
  SearchProblem p = problem_with(0.2);
  const TrialGear free = trial_gear(p, 40, Angle(), 0, 1);
  p.limits.min_shift = -0.6;
  p.limits.max_shift = 1.0;
  const TrialGear cut = trial_gear(p, 40, Angle(), 0, 1);
  EXPECT_LT(free.x_min, -0.6);
  EXPECT_GT(free.x_max, 1.0);
  EXPECT_EQ(cut.x_min, -0.6);
  EXPECT_EQ(cut.x_max, 1.0);
  const TrialGear ring = trial_gear(p, -60, Angle(), 0, 1);
  EXPECT_EQ(ring.x_min, -0.6);
  EXPECT_LE(ring.x_max, 1.0);
}

TEST(TrialGear, MarginsRaiseTheUndercutLimit) {
  SearchProblem p = problem_with(0.2);
  const double bare = trial_gear(p, 17, Angle::radians(0.3), 0, 0).x_min;
  p.limits.undercut_margin = 0.1;
  EXPECT_NEAR(trial_gear(p, 17, Angle::radians(0.3), 0, 0).x_min, bare + 0.1, 1e-15);
}

// A tip that is shortened by −k is thicker. The greatest shift therefore grows until the tip has
// the same thickness again.
TEST(TrialGear, ShorterTipsMayShiftFarther) {
  SearchProblem p = problem_with(0.3);
  for (const double beta : {0.0, 0.4}) {
    for (const int z : {10, 17, 40, 120}) {
      const TrialGear g = trial_gear(p, z, Angle::radians(beta), 0, 0);
      EXPECT_EQ(max_shift(p, g, 0.0), g.x_max);
      double last = g.x_max;
      for (const double k : {-1e-6, -0.01, -0.1, -0.3}) {
        const double x = max_shift(p, g, k);
        EXPECT_GT(x, last) << z << " " << k;
        EXPECT_NEAR(tip_thickness(g, x, k), 0.3, 1e-12) << z << " " << k;
        last = x;
      }
    }
  }
  p.limits.max_shift = 0.2;
  const TrialGear g = trial_gear(p, 40, Angle(), 0, 0);
  EXPECT_EQ(max_shift(p, g, -0.1), 0.2);
}

// (2)
TEST(TrialGear, TablesAndHandsChangeNothing) {
  SearchProblem p = problem_with(0.25);
  p.limits.min_shift = -0.6;
  for (const double beta : {0.0, 0.35}) {
    for (const auto& [least, greatest] : {std::pair{5, 90}, {-90, -20}}) {
      const TrialGears table(p, least, greatest, Angle::radians(beta), 0, 1);
      for (int z = least; z <= greatest; ++z) {
        const TrialGear one = trial_gear(p, z, Angle::radians(-beta), 0, 1);
        EXPECT_EQ(table[z].teeth, z);
        EXPECT_EQ(table[z].x_min, one.x_min);
        EXPECT_EQ(table[z].x_max, one.x_max);
        EXPECT_EQ(table[z].r_b, one.r_b);
      }
    }
  }
}

TEST(TrialGear, EachGearHasItsOwnRack) {
  SearchProblem p = problem_with(0.2);
  p.racks[0].rack[1].addendum = 0.8;
  p.racks[0].rack[1].dedendum = 1.4;
  p.racks[0].undercut_depth = {1.0, 1.2};
  const TrialGear one = trial_gear(p, 20, Angle(), 0, 0);
  const TrialGear two = trial_gear(p, 20, Angle(), 0, 1);
  EXPECT_EQ(one.addendum, 1.0);
  EXPECT_EQ(two.addendum, 0.8);
  EXPECT_EQ(two.dedendum, 1.4);
  EXPECT_NEAR(two.x_min - one.x_min, 0.2, 1e-15);
  EXPECT_GT(two.x_max, one.x_max);  // the shorter tooth is thicker at its tip
}

}  // namespace
}  // namespace gearwright
