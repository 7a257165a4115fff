// Oracles: (1) places of planets by trial: a copy is moved around the axis of the carrier in small
// steps, and its gears are turned until all teeth mesh; (2) phases are computed from the times at
// which teeth pass the planets.
#include "gearwright/drive/assembly.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/drive/drive.hpp"
#include "gearwright/drive/phasing.hpp"
#include "gearwright/drive/rational.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {
namespace {

using M = SetMember;

DriveGraph graph(const std::vector<std::pair<M, int>>& teeth, int planets,
                 Spacing spacing = Spacing::nearest) {
  PlanetarySpec set;
  for (const auto& [member, z] : teeth) set.z(member) = z;
  set.planets = planets;
  set.spacing = spacing;
  if (teeth.size() == 2) {  // a planet in one ring has no default bodies
    set.fixed = {{"ring"}};
    set.inputs = {"carrier"};
    set.output = "planet";
  }
  const auto made = graph_of(set);
  EXPECT_TRUE(made) << made.error().message();
  return *made;
}

Assembly assembled(const DriveGraph& g) {
  return testing::taken(assemble(g, planet_groups(g).front()));
}

// Counts the places n/grid of a turn at which a stepped planet meshes with both its central gears.
// Its first gear meshes in z_p1 positions k, and its second gear must mesh in one of them.
int places_by_trying(int z_1, int z_p1, int z_2, int z_p2, int grid) {
  int count = 0;
  for (int n = 0; n < grid; ++n) {
    bool fits = false;
    for (int k = 0; k < z_p1 && !fits; ++k) {
      // With χ = (k + z_1 n/grid)/z_p1 turns, z_p2 χ − z_2 n/grid must be a whole number. The code
      // multiplies this condition by grid z_p1.
      const long long teeth = static_cast<long long>(z_p2) * (static_cast<long long>(k) * grid +
                                                              static_cast<long long>(z_1) * n) -
                              static_cast<long long>(z_2) * n * z_p1;
      fits = teeth % (static_cast<long long>(grid) * z_p1) == 0;
    }
    count += fits;
  }
  return count;
}

TEST(Assembly, PlacesAreThoseFoundByTrying) {
  std::mt19937 random(3);
  const auto pick = [&](int lo, int hi) { return std::uniform_int_distribution(lo, hi)(random); };
  for (int k = 0; k < 60; ++k) {
    const int s = pick(12, 24), p1 = pick(12, 20), p2 = pick(10, 18), r = pick(50, 66);
    const DriveGraph g =
        k % 2 ? graph({{M::sun, s}, {M::planet, p1}, {M::planet2, p2}, {M::ring2, r}}, 1)
              : graph({{M::sun, s}, {M::planet, p1}, {M::ring, r}}, 1);
    const long long places = assembly_places(g, planet_groups(g).front());
    const int second = k % 2 ? p2 : p1;
    // Every place is a multiple of 1/(z_s z_p2 + z_r z_p1), so a grid of this step contains all
    // places.
    EXPECT_EQ(places, places_by_trying(s, p1, -r, second, s * second + r * p1))
        << s << " " << p1 << " " << second << " " << r;
  }
}

TEST(Assembly, SpecialCases) {
  const auto places = [](const std::vector<std::pair<M, int>>& teeth) {
    const DriveGraph g = graph(teeth, 1);
    return assembly_places(g, planet_groups(g).front());
  };
  EXPECT_EQ(places({{M::sun, 20}, {M::planet, 25}, {M::ring, 70}}), 90);
  EXPECT_EQ(places({{M::sun, 26}, {M::idler, 17}, {M::planet, 17}, {M::ring, 80}}), 54);
  EXPECT_EQ(places({{M::planet, 21}, {M::ring, 57}, {M::ring2, 60}}), 3);
  EXPECT_EQ(places({{M::planet, 21}, {M::planet2, 16}, {M::ring, 66}, {M::ring2, 61}}), 225);
  EXPECT_EQ(places({{M::planet, 48}, {M::ring, 50}}), 0);
  EXPECT_EQ(places({{M::sun, 28}, {M::idler, 21}, {M::sun2, 32}, {M::planet, 24}, {M::ring, 80}}),
            4);
}

TEST(Assembly, EvenSetsStandInPairs) {
  const Assembly a = assembled(graph({{M::sun, 20}, {M::planet, 19}, {M::ring, 58}}, 4));
  EXPECT_FALSE(a.equal);
  for (const std::size_t i : {0u, 1u})
    EXPECT_TRUE(a.turns[i + 2] == a.turns[i] + Rational::of(1, 2));
}

// The order in which a spec lists the positions has no effect on the spacing.
TEST(Assembly, PositionsInAnyOrderAreAtEqualPitch) {
  for (const auto& [positions, equal] : {std::pair{std::vector{0.0, 120.0, 240.0}, true},
                                         {{0.0, 240.0, 120.0}, true},
                                         {{0.0, -120.0, 120.0}, true},
                                         {{120.0, 0.0, 240.0}, true},
                                         {{0.0, 100.0, 240.0}, false},
                                         {{0.0, 120.0, 120.0}, false}}) {
    DriveGraph g = graph({{M::sun, 20}, {M::planet, 25}, {M::ring, 70}}, 3);
    for (DriveBody& body : g.bodies)
      if (body.carrier) body.positions_deg = positions;
    EXPECT_EQ(assembled(g).equal, equal) << positions[1] << " " << positions[2];
    const Drive drive = testing::taken(make_drive({g, {}}));
    if (equal) {
      EXPECT_TRUE(drive.findings.empty());
      continue;
    }
    ASSERT_EQ(drive.findings.size(), 1u);
    EXPECT_NE(drive.findings.front().message.find("the given positions"), std::string::npos);
  }
}

TEST(Assembly, ClockedPlanetsMeshAnywhere) {
  const std::vector<std::pair<M, int>> teeth{
      {M::sun, 17}, {M::planet, 31}, {M::planet2, 13}, {M::ring2, 62}};
  const Assembly a = assembled(graph(teeth, 3, Spacing::equal_clocked));
  ASSERT_EQ(a.clocking.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    // If the second gear is clocked by δ, it meshes in one of the positions of the first gear. Then
    // z_p2 (χ + δ) + z_r u is a whole number.
    bool fits = false;
    for (int k = 0; k < 31; ++k) {
      const Rational chi = (Rational(k) + Rational(17) * a.turns[i]) / Rational(31);
      fits = fits || (Rational(13) * (chi + a.clocking[i]) + Rational(62) * a.turns[i]).whole();
    }
    EXPECT_TRUE(fits);
  }
}

// The time at which the next tooth of a central gear passes planet i, if the gear turns by one
// tooth per period relative to the carrier. The teeth are at k/z turns, and tooth 0 is at planet 0.
double event_after(int z, double u) {
  double least = 2.0;
  for (int k = -std::abs(z); k <= 2 * std::abs(z); ++k) {
    // A gear that turns counter-clockwise brings tooth k from k/|z| to u after (u − k/|z|)·|z|
    // periods. A ring turns in the opposite sense.
    const double t = (u - static_cast<double>(k) / std::abs(z)) * z;
    if (t > -1e-9 && t < least) least = t;
  }
  return least;
}

TEST(Phasing, PhasesAreToothEvents) {
  for (const auto& [s, p, r, n] :
       {std::array{17, 19, 55, 3}, {20, 19, 58, 4}, {19, 17, 53, 5}, {22, 16, 54, 4}}) {
    const Assembly a = assembled(graph({{M::sun, s}, {M::planet, p}, {M::ring, r}}, n));
    const auto sun = mesh_phases(s, a.turns), ring = mesh_phases(-r, a.turns);
    for (std::size_t i = 0; i < a.turns.size(); ++i) {
      EXPECT_TRUE(sun[i] == ring[i]);
      EXPECT_NEAR(std::remainder(sun[i].value() - event_after(s, a.turns[i].value()), 1.0), 0,
                  1e-9);
      EXPECT_NEAR(std::remainder(ring[i].value() - event_after(-r, a.turns[i].value()), 1.0), 0,
                  1e-9);
    }
  }
}

TEST(Phasing, EqualPitchIsPure) {
  for (int n = 3; n < 7; ++n) {
    for (int z = 12; z < 12 + 2 * n; ++z) {
      std::vector<Rational> turns;
      for (int i = 0; i < n; ++i) turns.push_back(Rational::of(i, n));
      const Phasing p = phasing(mesh_phases(z, turns), turns, 4);
      for (int k = 1; k <= 4; ++k) {
        const int m = k * z % n;
        const Resultant& r = p.resultants[static_cast<std::size_t>(k - 1)];
        EXPECT_NEAR(r.torque, m == 0, 1e-12);
        EXPECT_NEAR(r.force_forward, m == 1, 1e-12);
        EXPECT_NEAR(r.force_backward, m == n - 1, 1e-12);
      }
    }
  }
}

TEST(Rational, FractionsAreExactOrDoNotFit) {
  const Rational third = Rational::of(2, -6);
  EXPECT_EQ(*third.numerator(), -1);
  EXPECT_EQ(*third.denominator(), 3);
  EXPECT_TRUE(third.frac() == Rational::of(2, 3));
  EXPECT_TRUE(third + Rational::of(1, 3) == Rational(0));
  EXPECT_TRUE(least_common_multiple(Rational(12), Rational(45)) == Rational(180));
  Rational large = Rational::of(1'000'000'007, 998'244'353);
  for (int i = 0; i < 3; ++i) large = large * large;
  EXPECT_FALSE(large.fits());
  EXPECT_FALSE((large + third).fits());
  EXPECT_FALSE(large.numerator());
  const Rational most(9'223'372'036'854'775'807), square = most * most;  // 126 bits
  EXPECT_TRUE((square + square).fits());
  EXPECT_TRUE((square * Rational(-2)).fits());
  EXPECT_FALSE((square * Rational(4)).fits());
  EXPECT_FALSE((square + square + square).fits());
  RationalMatrix rows{{1, 2, 3}, {2, 4, 6}, {1, 0, 1}};
  EXPECT_EQ(*rank_of(rows), 2u);
  const RationalMatrix kernel = left_kernel(rows);
  ASSERT_EQ(kernel.size(), 1u);
  EXPECT_TRUE(kernel[0][0] == Rational(-2) * kernel[0][1]);
}

}  // namespace
}  // namespace gearwright
