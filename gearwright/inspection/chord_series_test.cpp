#include "gearwright/inspection/chord_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <string>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/inspection/chordal_thickness.hpp"

namespace gearwright {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;
using testing::kDegree;

struct Three {
  double theta, chord, height;
};
struct Spur {
  double chord, height, chord_error, height_error;
};
struct GoldenSeries {
  const char* tooth;
  double psi_deg, diameter, theta_t, base_deg;
  Three series[3];
  Spur spur;
  double base_chord, base_height;
};
// These values were computed with 40 digits.
const GoldenSeries kGoldenSeries[] = {
    {"crossed 9, 51.6°",
     51.576509202864735,
     43.44544689997543,
     0.13788404781676722,
     47.408,
     {{0.05331589424006917, 3.7221896625908544, 0.03086701813517964},
      {0.05331607432936298, 3.7221882802022055, 0.030867234844178262},
      {0.05331607501206161, 3.722188276195857, 0.030867235723164514}},
     {3.722189699810759, 0.03079999638645649, -1.41960952426516e-06, 6.702185137560652e-05},
     3.7219135666005707,
     0.0365242958049173},
    {"left hand 47.2°",
     -47.2445963484087,
     29.827164466275352,
     0.1013184075409523,
     -41.64114326790979,
     {{0.046730647005669756, 2.05122925076589, 0.016280828697480168},
      {0.046730717077456664, 2.0512287833712133, 0.016280878433241126},
      {0.04673071725040209, 2.0512287824810054, 0.01628087856430009}},
     {2.0512292680277704, 0.016256939285615668, -4.84656970092356e-07, 2.3889457463745014e-05},
     2.0510683091355686,
     0.0196998559747752},
    {"35°",
     35.0,
     36.623237662843685,
     0.11442562803342517,
     32.61460714830659,
     {{0.07688002580494352, 3.430505619632913, 0.05408915557116362},
      {0.07688029384483816, 3.4305007998836823, 0.054089490734238264},
      {0.07688029469145732, 3.430500787055816, 0.05408949181544692}},
     {3.4305060672326904, 0.05395830038250024, -5.2673911672817905e-06, 0.00013085753470495825},
     3.430239128951267,
     0.05705075712553476},
    {"two-thread worm",
     81.4558782000464,
     27.035081932574535,
     0.4153638263136973,
     67.73125550470311,
     {{0.009168967724743104, 1.6683617080147388, 0.0005682056443101849},
      {0.009168967798905968, 1.668361707963891, 0.0005682056543466546},
      {0.00916896779892044, 1.6683617079638835, 0.0005682056543487552}},
     {1.6683617080147868, 0.0005681472634385729, -5.0895710160375185e-11, 5.838087161749116e-08},
     1.6683403867673825,
     0.0036962146322336133},
    {"spur 17",
     0.0,
     51.0,
     0.10952779495340344,
     0.0,
     {{0.10952779495340344, 5.574749116933493, 0.1528004011789066},
      {0.10952779495340344, 5.574755815943894, 0.15280046232289304},
      {0.10952779495340344, 5.574755814030475, 0.15280046230979477}},
     {5.574755814030794, 0.15280046230979652, 0.0, 0.0},
     5.574755814030794,
     0.15280046230979652},
};

TEST(ChordSeries, golden_values) {
  for (const GoldenSeries& g : kGoldenSeries) {
    const double psi = g.psi_deg * kDegree;
    const double r = g.diameter / 2;
    for (int n = 1; n <= 3; ++n) {
      const auto c = chord_by_series(g.theta_t, psi, r, n);
      const Three& e = g.series[n - 1];
      EXPECT_NEAR(c.half_angle, e.theta, 2e-14 * e.theta) << g.tooth << n;
      EXPECT_NEAR(c.chord, e.chord, 2e-14 * e.chord) << g.tooth << n;
      EXPECT_NEAR(c.height, e.height, 4e-14 * e.height) << g.tooth << n;
    }
    const auto spur = virtual_spur(g.theta_t, psi, r).chord();
    EXPECT_NEAR(spur.chord, g.spur.chord, 2e-14 * g.spur.chord) << g.tooth;
    EXPECT_NEAR(spur.height, g.spur.height, 1e-13 * g.spur.height) << g.tooth;
    EXPECT_NEAR(virtual_spur_chord_error(g.theta_t, psi, r), g.spur.chord_error,
                1e-12 * std::abs(g.spur.chord_error))
        << g.tooth;
    EXPECT_NEAR(virtual_spur_height_error(g.theta_t, psi, r), g.spur.height_error,
                1e-12 * std::abs(g.spur.height_error))
        << g.tooth;
    const auto other = virtual_spur_on_base_helix(g.theta_t, psi, g.base_deg * kDegree, r).chord();
    EXPECT_NEAR(other.chord, g.base_chord, 1e-13 * g.base_chord) << g.tooth;
    EXPECT_NEAR(other.height, g.base_height, 1e-13 * g.base_height) << g.tooth;
  }
}

// Finds the shortest chord by bisection with 50 digits. The condition is that the derivative of
// sin² θ + (θ_t − θ)²/tan² ψ is 0.
ApproximateChord<Exact> by_halving(const Exact& theta_t, const Exact& psi, const Exact& r) {
  const Exact t2 = tan(psi) * tan(psi);
  Exact lo = 0, hi = theta_t;
  for (int i = 0; i < 160; ++i) {
    const Exact x = (lo + hi) / 2;
    (sin(x) * cos(x) * t2 < theta_t - x ? lo : hi) = x;
  }
  const Exact zeta = (theta_t - lo) / tan(psi);
  return {lo, 2 * r * sqrt(sin(lo) * sin(lo) + zeta * zeta), r * (1 - cos(lo))};
}

double order(const Exact& coarse, const Exact& fine) {
  return static_cast<double>(log(abs(coarse / fine)) / log(Exact(2)));
}

// If θ_t is halved, the error of n corrections is divided by 2^(2n + 3) for θ* and k, and by 2^(2n
// + 4) for Δh. At θ_t = 1e-3, the next term changes these exponents by about (1 + 24 T) 1e-6.
TEST(ChordSeries, errors_fall_with_the_right_power) {
  const Exact r = 20;
  for (const double psi : {10.0, 35.0, 51.6, -70.0}) {
    const Exact p = Exact(psi) * Exact(kDegree);
    const Exact theta[] = {Exact(1) / 1000, Exact(1) / 2000};
    const ApproximateChord<Exact> exact[] = {by_halving(theta[0], p, r),
                                             by_halving(theta[1], p, r)};
    for (int n = 0; n <= 3; ++n) {
      Exact angle[2], chord[2], height[2];
      for (int i : {0, 1}) {
        const auto c = chord_by_series(theta[i], p, r, n);
        angle[i] = c.half_angle - exact[i].half_angle;
        chord[i] = c.chord - exact[i].chord;
        height[i] = c.height - exact[i].height;
      }
      EXPECT_NEAR(order(angle[0], angle[1]), 2 * n + 3, 1e-3) << psi << " " << n;
      EXPECT_NEAR(order(chord[0], chord[1]), 2 * n + 3, 1e-3) << psi << " " << n;
      EXPECT_NEAR(order(height[0], height[1]), 2 * n + 4, 1e-3) << psi << " " << n;
    }
  }
}

// The errors of chord and height of the virtual spur gear, computed by their formulas, agree with
// the actual errors to leading order.
TEST(ChordSeries, virtual_spur_errors_are_the_leading_ones) {
  const Exact r = 20;
  for (const double psi : {5.0, 35.0, 51.6, -70.0}) {
    const Exact p = Exact(psi) * Exact(kDegree);
    const Exact theta = Exact(1) / 2000;
    const auto exact = by_halving(theta, p, r);
    const auto spur = virtual_spur(theta, p, r).chord();
    EXPECT_NEAR(
        static_cast<double>((exact.chord - spur.chord) / virtual_spur_chord_error(theta, p, r)),
        1.0, 2e-5)
        << psi;
    EXPECT_NEAR(
        static_cast<double>((exact.height - spur.height) / virtual_spur_height_error(theta, p, r)),
        1.0, 2e-5)
        << psi;
    // With z/(cos ψ cos² β_b) teeth, only the first term of the chord is correct, so the error of
    // the chord is much greater.
    const Exact base = asin(sin(p) * cos(Exact(20) * Exact(kDegree)));
    const auto other = virtual_spur_on_base_helix(theta, p, base, r).chord();
    EXPECT_GT(abs(exact.chord - other.chord), 1000 * abs(exact.chord - spur.chord)) << psi;
  }
}

// Greatest relative errors over all ψ from 0 to 88°, as in the table of
// docs/theory/05-approximations.md. As long as the first omitted term dominates, the error is
// greatest at sin² ψ = 1/3 [T5.11].
TEST(ChordSeries, greatest_errors_over_all_helix_angles) {
  struct Row {
    double theta_t, chord[3], height[3];
  };
  const Row rows[] = {{0.1, {1.1e-6, 1.8e-9, 3.7e-12}, {4.0e-6, 1.1e-8, 3.4e-11}},
                      {0.2, {1.8e-5, 1.1e-7, 9.5e-10}, {6.4e-5, 7.2e-7, 8.8e-9}},
                      {0.4, {2.9e-4, 7.5e-6, 2.5e-7}, {1.0e-3, 4.7e-5, 2.3e-6}}};
  for (const Row& row : rows) {
    for (int n = 1; n <= 3; ++n) {
      double chord = 0.0, height = 0.0, worst_psi = 0.0;
      for (int i = 0; i <= 352; ++i) {
        const double psi = 0.25 * i * kDegree;
        const auto exact = shortest_chord(ToothArc<double>{row.theta_t, psi, 1.0, 1.0});
        const auto by_hand = chord_by_series(row.theta_t, psi, 1.0, n);
        const double error = std::abs(by_hand.chord / exact.chord - 1.0);
        if (error > chord) chord = error, worst_psi = psi / kDegree;
        height = std::max(height, std::abs(by_hand.height / exact.height - 1.0));
      }
      // The theory page prints two digits.
      EXPECT_NEAR(chord / row.chord[n - 1], 1.0, 0.05) << row.theta_t << " " << n;
      EXPECT_NEAR(height / row.height[n - 1], 1.0, 0.05) << row.theta_t << " " << n;
      if (n > 1) {
        EXPECT_NEAR(worst_psi, 35.3, 5.0) << row.theta_t << " " << n;
      }
    }
  }
}

// At ψ = 0, the series give the closed forms of a spur gear.
TEST(ChordSeries, of_a_spur_gear) {
  const double theta = 0.1;
  const auto c = chord_by_series(theta, 0.0, 10.0, 3);
  EXPECT_EQ(c.half_angle, theta);
  // The first omitted terms are θ⁹/9! for the chord and θ¹⁰/10! for the height.
  EXPECT_NEAR(c.chord, 20 * std::sin(theta), 20 * std::pow(theta, 9) / 362880 * 1.1 + 4e-16);
  EXPECT_NEAR(c.height, 10 * (1 - std::cos(theta)), 1e-15);
  EXPECT_EQ(virtual_spur(theta, 0.0, 10.0).chord().chord, 20 * std::sin(theta));
}

}  // namespace
}  // namespace gearwright
