// Compares the oracle with points known to 18 digits, with a plain scan of all positions, and with
// edges rolled by the law of gearing, which the oracle does not use.
#include "tests/oracle/swept_rack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/oracle/few_tooth_cases.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/oracle/rolled_edge.hpp"
#include "tests/oracle/swept_tooth.hpp"

namespace gearwright::oracle {
namespace {

RackNumbers helical_20() {
  return {.teeth = 20,
          .normal_module = 2.0,
          .normal_pressure_angle = 20 * kDegree,
          .helix_angle = 15 * kDegree,
          .profile_shift = 0.1,
          .root_fillet_radius = 0.38};
}

RackNumbers with_protuberance() {
  RackNumbers n = helical_20();
  n.teeth = 31;
  n.dedendum = 1.4;
  n.root_fillet_radius = 0.3;
  n.protuberance = 0.05;
  n.protuberance_angle = 10 * kDegree;
  return n;
}

RackNumbers semi_topping() {
  RackNumbers n = helical_20();
  n.tool_addendum = 0.7;
  n.semi_topping_angle = 50 * kDegree;
  return n;
}

RackNumbers fully_rounded() {
  RackNumbers n = helical_20();
  n.teeth = 7;
  n.helix_angle = 0;
  n.profile_shift = 0.5;
  const double a = n.normal_pressure_angle;
  // The rounding is centred on the middle of the cutter's tooth, u = 0.
  n.root_fillet_radius = (kPi / 4 - n.dedendum * std::tan(a)) * std::cos(a) / (1 - std::sin(a));
  n.tip_fillet_radius = 0.2;  // bottom land at the addendum, tool_addendum absent
  return n;
}

std::vector<RackNumbers> cutter_numbers() {
  RackNumbers sharp = helical_20();
  sharp.root_fillet_radius = 0;
  sharp.teeth = 6;
  RackNumbers sharp_bottom = helical_20();
  sharp_bottom.tool_addendum = 0.8;
  RackNumbers rounded_protuberance = with_protuberance();
  rounded_protuberance.protuberance = 0.002;  // the rounding meets the flank before 10°
  return {helical_20(), with_protuberance(), semi_topping(),       fully_rounded(),
          sharp,        sharp_bottom,        rounded_protuberance, few_tooth_cases()[2].rack};
}

TEST(SweptRack, known_points_lie_on_the_surface) {
  for (const FewToothCase& c : few_tooth_cases()) {
    const SweptRack rack(c.rack);
    // The table has 18 digits, and the accuracy of `clearance` is 1e-12 mm.
    for (const FewToothPoint& p : c.points) {
      EXPECT_NEAR(rack.clearance({p.x, p.y}), 0.0, 1e-12) << c.name << " " << p.x << " " << p.y;
    }
  }
}

// A point moved by δ along the transverse normal moves by δ |n_t| along the spatial one, and the
// clearance is the spatial distance. The rest is δ²/2 times a curvature: δ² = 1e-10 mm², and no
// curvature radius of these surfaces is below 2 µm at the points of the table.
// Outside a fillet that a sharp corner cuts, the point enters the wedge of the corner, whose angle
// is 90° + α. On the bisector, the depth below the two sides is between sin(45° + α/2) and 1 times
// the step.
TEST(SweptRack, sees_a_point_that_is_1e_5_mm_off) {
  constexpr double kOff = 1e-5, kRest = 2.5e-8;
  for (const FewToothCase& c : few_tooth_cases()) {
    const SweptRack rack(c.rack);
    for (const FewToothPoint& p : c.points) {
      const double n_t = std::hypot(p.n_x, p.n_y), d = kOff / n_t, seen = kOff * n_t;
      const double out = rack.clearance({p.x + d * p.n_x, p.y + d * p.n_y});
      const double in = rack.clearance({p.x - d * p.n_x, p.y - d * p.n_y});
      const bool cut_by_corner =
          c.rack.root_fillet_radius == 0 && std::hypot(p.x, p.y) < c.form_radius;
      const double part =
          cut_by_corner ? std::sin(kPi / 4 + c.rack.normal_pressure_angle / 2) : 1.0;
      EXPECT_GE(out, -seen - kRest) << c.name << " " << p.x << " " << p.y;
      EXPECT_LE(out, -seen * part + kRest) << c.name << " " << p.x << " " << p.y;
      EXPECT_NEAR(in, seen, kRest) << c.name << " " << p.x << " " << p.y;
    }
  }
}

// Rolled edges of a helical gear free of undercut: rounding, flank, protuberance, ramp, lands.
TEST(SweptRack, rolled_edges_lie_on_the_surface) {
  const RackNumbers n = helical_20();
  const SweptRack rack(n);
  for (int i = 0; i <= 40; ++i) {
    const double tau = n.normal_pressure_angle + (kPi / 2 - n.normal_pressure_angle) * i / 40;
    EXPECT_NEAR(rack.clearance(rolled(n, on_tip_rounding(n, tau))), 0.0, 1e-12) << tau;
  }
  const double start = on_tip_rounding(n, n.normal_pressure_angle).h;
  for (int i = 0; i <= 40; ++i) {
    const double h = start + (1.8 - start) * i / 40;
    EXPECT_NEAR(rack.clearance(rolled(n, on_flank(n, h))), 0.0, 1e-12) << h;
  }
  // For the root land and inside the root circle, the tip land of the cutter is nearest.
  const double middle = kPi / n.teeth, r_f = rack.deepest_radius();
  for (const double depth : {0.0, 1e-9, 0.1, 3.0, r_f}) {
    EXPECT_NEAR(
        rack.clearance({(r_f - depth) * std::cos(middle), (r_f - depth) * std::sin(middle)}), depth,
        1e-13);
  }
}

TEST(SweptRack, protuberance_cuts_proud_of_the_flank) {
  // With 200 teeth there is no undercut, so the whole rounding from 10° on and the 10° line are
  // present.
  RackNumbers many = with_protuberance();
  many.teeth = 200;
  const SweptRack large(many);
  const double first = many.protuberance_angle;
  for (int i = 0; i <= 32; ++i) {
    const double tau = first + (kPi / 2 - first) * i / 32;
    EXPECT_NEAR(large.clearance(rolled(many, on_tip_rounding(many, tau))), 0.0, 1e-12) << tau;
  }
  const EdgePoint start = on_tip_rounding(many, first);
  for (int i = 0; i <= 6; ++i) {
    const double rise = 0.05 * i;
    const EdgePoint e{start.h + rise, start.u + rise * std::tan(first), first};
    EXPECT_NEAR(large.clearance(rolled(many, e)), 0.0, 1e-12) << rise;
  }
  // With 31 teeth, undercut removes the 10° line, together with the rounding below 15°. At a depth
  // of one module, this line is free of undercut only from 2/sin²10° = 66 teeth on.
  const RackNumbers n = with_protuberance();
  const SweptRack rack(n);
  for (int i = 0; i <= 30; ++i) {
    const double tau = (15 + 2.5 * i) * kDegree;
    EXPECT_NEAR(rack.clearance(rolled(n, on_tip_rounding(n, tau))), 0.0, 1e-12) << tau / kDegree;
  }
  EXPECT_LT(rack.clearance(rolled(n, on_tip_rounding(n, first))), -0.1);
  // The involute of the main flank is raised by pr at the angle α. Where only the protuberance
  // cuts, the involute is cut away by less than pr and by more than pr/2. Higher up, the flank is
  // unchanged.
  RackNumbers plain = n;
  plain.protuberance = 0;
  plain.root_fillet_radius = 0.25;
  const PlanePoint low = rolled(plain, on_flank(plain, on_tip_rounding(plain, 20 * kDegree).h));
  const double pr = n.protuberance * n.normal_module;
  EXPECT_LT(rack.clearance(low), -pr / 2);
  EXPECT_GE(rack.clearance(low), -pr);
  EXPECT_NEAR(rack.clearance(rolled(n, on_flank(n, 1.0))), 0.0, 1e-12);
}

// The involute of the ramp has the base radius r cos α_st,t. It is the surface wherever it makes
// the tooth narrower than the flank. Below this part, it lies outside the flank and is cut away. In
// this part, the involute of the flank is cut away.
TEST(SweptRack, semi_topping_ramp_cuts_a_chamfer) {
  const RackNumbers n = semi_topping();
  const SweptRack rack(n);
  const EdgePoint end = on_flank(n, *n.tool_addendum * n.normal_module);
  const double ramp = *n.semi_topping_angle;
  int chamfer = 0, swallowed = 0;
  for (int i = 1; i <= 60; ++i) {
    const double rise = 0.01 * i;
    const PlanePoint p = rolled(n, {end.h + rise, end.u + rise * std::tan(ramp), ramp});
    const double rho = std::hypot(p.x, p.y);
    const double margin = rho * (involute_half_angle(rack, rho) - std::atan2(p.y, p.x));
    if (margin > 0) {
      EXPECT_NEAR(rack.clearance(p), 0.0, 1e-12) << "rise " << rise << ", radius " << rho;
      ++chamfer;
    } else {
      EXPECT_LT(rack.clearance(p), margin / 2) << "rise " << rise << ", radius " << rho;
      ++swallowed;
    }
  }
  EXPECT_GT(chamfer, 5);
  EXPECT_GT(swallowed, 5);
  EXPECT_LT(rack.clearance(rolled(n, on_flank(n, end.h + 0.5))), -1e-3);
}

/// Evaluates all positions of one turn in steps of 2π/4000, then refines the best one. It uses only
/// the gap at a position.
double plain_scan(const SweptRack& rack, PlanePoint p) {
  constexpr int kPositions = 4000;
  constexpr double kStep = 2 * kPi / kPositions;
  std::vector<double> gap(kPositions);
  for (int k = 0; k < kPositions; ++k) gap[k] = rack.gap_at(p, -kPi + k * kStep);
  double best = *std::min_element(gap.begin(), gap.end());
  const double limit = best + 0.05;  // includes other minima that a step may have missed
  for (int k = 0; k < kPositions; ++k) {
    const double before = gap[(k + kPositions - 1) % kPositions], after = gap[(k + 1) % kPositions];
    if (gap[k] > before || gap[k] > after || gap[k] > limit) continue;
    double lo = -kPi + (k - 1) * kStep, hi = lo + 2 * kStep;
    for (int i = 0; i < 75; ++i) {
      const double a = lo + 0.382 * (hi - lo), b = hi - 0.382 * (hi - lo);
      (rack.gap_at(p, a) < rack.gap_at(p, b) ? hi : lo) =
          rack.gap_at(p, a) < rack.gap_at(p, b) ? b : a;
    }
    best = std::min(best, rack.gap_at(p, 0.5 * (lo + hi)));
  }
  return best;
}

TEST(SweptRack, agrees_with_a_plain_scan_of_all_positions) {
  std::mt19937_64 random(20240611);
  const auto uniform = [&](double a, double b) {
    return a + (b - a) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  for (const RackNumbers& n : cutter_numbers()) {
    const SweptRack rack(n);
    int standing = 0, cut = 0;
    for (int i = 0; i < 40; ++i) {
      const double rho = rack.deepest_radius() + uniform(-0.1, 2.3) * n.normal_module;
      const double angle = uniform(0, kPi / n.teeth);
      const PlanePoint p{rho * std::cos(angle), rho * std::sin(angle)};
      const double fast = rack.clearance(p), scan = plain_scan(rack, p);
      if (scan >= 0) {
        // At a smooth minimum, golden section stops within sqrt(ulp), so the value is accurate to
        // 1e-13. The value of the scan may only be higher, which happens if a minimum lies between
        // its steps.
        EXPECT_NEAR(fast, scan, 1e-11) << n.teeth << " " << p.x << " " << p.y;
        ++standing;
      } else {
        EXPECT_LT(fast, 0) << n.teeth << " " << p.x << " " << p.y;
        EXPECT_NEAR(fast, scan, 1e-8) << n.teeth << " " << p.x << " " << p.y;
        ++cut;
      }
    }
    EXPECT_GT(standing, 4) << n.teeth;
    EXPECT_GT(cut, 4) << n.teeth;
  }
}

// The edge is drawn with straight pieces of at most 2e-4 m. Distances from it have two errors: the
// sagitta of a piece, (2e-4)²/(8 ρ) = 5e-8 m for the smallest radius here (0.1 m), and the effect
// of half a piece, by which the nearest vertex may be off: sqrt(d² + (1e-4 m)²) − d < 1e-4 m.
TEST(SweptRack, cutter_distance_is_that_from_its_drawn_edge) {
  RackNumbers n = with_protuberance();
  n.tool_addendum = 0.7;
  n.tip_fillet_radius = 0.1;
  const SweptRack rack(n);
  const double m = n.normal_module, a = n.normal_pressure_angle, p = kPi * m / 2;
  std::vector<PlanePoint> edge;  // (u, h)
  const auto line = [&](double u0, double h0, double u1, double h1) {
    const int k = 1 + static_cast<int>(std::hypot(u1 - u0, h1 - h0) / (2e-4 * m));
    for (int i = 0; i <= k; ++i) edge.push_back({u0 + (u1 - u0) * i / k, h0 + (h1 - h0) * i / k});
  };
  const EdgePoint tip = on_tip_rounding(n, kPi / 2),
                  first = on_tip_rounding(n, n.protuberance_angle);
  line(0, tip.h, tip.u, tip.h);
  for (int i = 0; i <= 4000; ++i) {
    const EdgePoint e = on_tip_rounding(n, kPi / 2 + (n.protuberance_angle - kPi / 2) * i / 4000);
    edge.push_back({e.u, e.h});
  }
  double h = first.h;  // up the protuberance line until it meets the flank
  const double slope = std::tan(n.protuberance_angle);
  h = (first.u - first.h * slope - p / 2) / (std::tan(a) - slope);
  line(first.u, first.h, p / 2 + h * std::tan(a), h);
  const EdgePoint end = on_flank(n, *n.tool_addendum * m);
  line(p / 2 + h * std::tan(a), h, end.u, end.h);
  const double rho1 = n.tip_fillet_radius * m;
  for (int i = 0; i <= 2000; ++i) {
    const double t = a + (kPi / 2 - a) * i / 2000;
    edge.push_back(
        {end.u + rho1 * (std::cos(a) - std::cos(t)), end.h + rho1 * (std::sin(t) - std::sin(a))});
  }
  line(edge.back().x, edge.back().y, p, edge.back().y);

  for (int i = 0; i < 21; ++i) {
    for (int k = 0; k < 25; ++k) {
      const double u = p * i / 20, height = (-1.8 + 0.12 * k) * m;
      double drawn = 1e300;
      for (const PlanePoint& e : edge) drawn = std::min(drawn, std::hypot(e.x - u, e.y - height));
      const double d = rack.distance_to_cutter(height, p - u);
      EXPECT_NEAR(std::abs(d), drawn, 1.1e-4 * m) << u << " " << height;
      // Mirror images about the middles of tooth and space, and the next pitch.
      for (const double w : {u - p, p + u, 3 * p - u, -3 * p + u}) {
        EXPECT_NEAR(rack.distance_to_cutter(height, w), d, 1e-14 * p * 4) << w;
      }
    }
  }
  EXPECT_GT(rack.distance_to_cutter(0, 0), 0);      // middle of the cutter's space
  EXPECT_LT(rack.distance_to_cutter(0, p), 0);      // middle of its tooth
  EXPECT_LT(rack.distance_to_cutter(2 * m, 0), 0);  // its body
}

TEST(SweptRack, impossible_cutters_are_refused) {
  const auto refused = [](auto change) {
    RackNumbers n = helical_20();
    change(n);
    EXPECT_THROW(SweptRack{n}, std::invalid_argument);
  };
  refused([](RackNumbers& n) { n.teeth = 0; });
  refused([](RackNumbers& n) { n.normal_module = 0; });
  refused([](RackNumbers& n) { n.root_fillet_radius = 0.5; });
  refused([](RackNumbers& n) { n.semi_topping_angle = 45 * kDegree; });
  refused([](RackNumbers& n) { n.tool_addendum = -2.0; });
  refused([](RackNumbers& n) {
    n.protuberance = 0.05;
    n.protuberance_angle = 25 * kDegree;
  });
  EXPECT_NO_THROW(SweptRack{helical_20()});
}

}  // namespace
}  // namespace gearwright::oracle
