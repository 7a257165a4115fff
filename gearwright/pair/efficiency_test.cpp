// Compares the efficiency with the loss factor of the textbook and with plain quadrature, and tests
// the limit of self-locking.
#include "gearwright/pair/efficiency.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/pair/testing/spur_mesh.hpp"

namespace gearwright {
namespace {

using testing::kAlpha;
using testing::spur;

MeshInput<double> screws(double beta_1, double beta_2, int z1, int z2) {
  MeshInput<double> in;
  const std::array<double, 2> beta{beta_1, beta_2};
  for (int i : {0, 1}) {
    const int z = i == 0 ? z1 : z2;
    const auto g = reference_geometry<double>({z, 2.0, kAlpha, beta[i], 0.0, 0.0});
    in.gears[i] = base_gear(z, g);
    in.tip_form_radius[i] = g.reference_diameter / 2 + 2.0;
    in.center_distance += g.reference_diameter / 2;
  }
  in.face_width = {200.0, 200.0};
  in.shaft_angle = beta_1 + beta_2;
  return in;
}

// H_v = π (1/z1 + 1/z2)(1 − ε_α + ε_1² + ε_2²) is the loss to first order in μ; z2 < 0 for an
// internal gear.
TEST(Efficiency, of_a_spur_pair_is_the_textbooks) {
  for (const int z2 : {40, -60}) {
    auto in = spur(20, z2);
    if (z2 < 0) in.tip_form_radius[1] = 58.5;  // the formula requires ε_2 < 1
    const auto m = mesh_of(in);
    const double e1 = (m.rho1_E - m.rho1_C) / m.step;
    const double e2 = (m.rho1_C - m.rho1_A) / m.step;
    const double loss = kPi * (1.0 / 20 + 1.0 / z2) * (1 - e1 - e2 + e1 * e1 + e2 * e2);
    const SlidingShares s = sliding_shares(in, m);
    EXPECT_NEAR(s.first - s.second, loss, 1e-14);
    const auto e = efficiency(s, 1e-6);
    EXPECT_NEAR(1 - *e.gear1_drives, 1e-6 * loss, 1e-11);
    EXPECT_NEAR(1 - *e.gear2_drives, 1e-6 * loss, 1e-11);
    EXPECT_EQ(*efficiency(s, 0.0).gear1_drives, 1.0);
  }
}

TEST(Efficiency, closed_integrals_are_the_integrals) {
  for (const auto& in :
       {screws(0.9, 0.6, 9, 15), screws(0.3, 0.1, 17, 23), spur(17, 31), spur(17, -51)}) {
    const auto m = mesh_of(in);
    double weight = 0.0;
    std::array<double, 2> sum{};
    for (const ContactZone& z : contact_zones(m.rho1_true_begin, m.rho1_true_end, m.step)) {
      if (z.pairs == 0) continue;
      constexpr int kSteps = 20000;
      const double h = (z.end - z.begin) / kSteps;
      for (int k = 0; k < kSteps; ++k) {
        const auto w = flank_speeds(in, m, z.begin + (k + 0.5) * h);
        const double u[] = {w.across[0] - w.across[1], w.along[0] - w.along[1]};
        const double length = std::hypot(u[0], u[1]);
        if (length == 0.0) continue;
        for (int i : {0, 1})
          sum[i] += h / z.pairs * (u[0] * w.across[i] + u[1] * w.along[i]) / length;
        weight += h / z.pairs;
      }
    }
    const double v_n = in.gears[0].radius * std::cos(in.gears[0].helix_angle);
    const SlidingShares s = sliding_shares(in, m);
    // The sliding of a spur pair changes its sign at C. The midpoint rule has an error in the step
    // that contains this jump.
    const double tolerance = in.shaft_angle ? 1e-7 : 3e-5;
    EXPECT_NEAR(s.first, sum[0] / weight / v_n, tolerance);
    EXPECT_NEAR(s.second, sum[1] / weight / v_n, tolerance);
  }
}

// The result is near the screw formula of the textbook, cos(β_2 + ρ′) cos β_1/(cos(β_1 − ρ′) cos
// β_2) with tan ρ′ = μ/cos α_n, which considers the pitch point only.
TEST(Efficiency, of_screws_is_near_the_pitch_points) {
  const auto in = screws(0.9, 0.6, 9, 15);
  const auto e = efficiency(sliding_shares(in, mesh_of(in)), 0.05);
  const double rho = std::atan(0.05 / std::cos(kAlpha));
  const double textbook =
      std::cos(0.6 + rho) * std::cos(0.9) / (std::cos(0.9 - rho) * std::cos(0.6));
  EXPECT_NEAR(*e.gear1_drives, textbook, 0.005);
  EXPECT_LT(*e.gear1_drives, textbook);  // away from the pitch point there is more sliding
}

TEST(Efficiency, a_steep_worm_is_self_locking) {
  const auto in = screws(86 * kPi / 180, 4 * kPi / 180, 1, 40);
  const auto e = efficiency(sliding_shares(in, mesh_of(in)), 0.15);
  EXPECT_TRUE(e.gear1_drives);
  EXPECT_LT(*e.gear1_drives, 0.5);
  EXPECT_FALSE(e.gear2_drives);
}

}  // namespace
}  // namespace gearwright
