// Contact of flanks with form waves, whose field has a local maximum for each crest of a wave.
// Oracle: T on a dense grid of heights and rows, with no search.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/continuous.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

// The greatest T, rad, over all tooth pairs and over the part of flank 1 inside flank 2, from a
// grid and the parabola through its best rows. TE is the greatest T of the flanks, so it must be
// at least this value.
double greatest_on_a_grid(const ContactPair& pair, double phi) {
  constexpr int kHeights = 201, kRows = 161;
  double best = -std::numeric_limits<double>::infinity();
  for (const FlankPatch& a : pair.patches(1)) {
    for (const FlankPatch& b : pair.patches(2)) {
      GapField field = pair.field(a, b);
      for (int k = -3; k <= 3; ++k) {
        field.set_rotation(phi - k * pair.pitch());
        for (int i = 0; i < kHeights; ++i) {
          const double z = a.z_lo + (a.z_hi - a.z_lo) * i / (kHeights - 1);
          double s2 = 0.5 * (b.s_lo + b.s_hi);
          std::array<double, kRows> t;
          for (int r = 0; r < kRows; ++r) {
            const double s = a.s_lo + (a.s_hi - a.s_lo) * r / (kRows - 1);
            const GapJet at = field.at(s, z, s2);
            const bool inside =
                at.u.v >= b.u_lo && at.u.v <= b.u_hi && at.Z.v >= b.z_lo && at.Z.v <= b.z_hi;
            t[r] = inside ? at.t.v : -std::numeric_limits<double>::infinity();
          }
          for (int r = 1; r + 1 < kRows; ++r) {
            if (!(t[r] >= t[r - 1] && t[r] >= t[r + 1]) || !std::isfinite(t[r - 1] + t[r + 1]))
              continue;
            const double bend = t[r - 1] - 2 * t[r] + t[r + 1];
            const double slope = t[r + 1] - t[r - 1];
            best = std::max(best, bend < 0.0 ? t[r] - slope * slope / (8 * bend) : t[r]);
          }
          best = std::max(best, *std::max_element(t.begin(), t.end()));
        }
      }
    }
  }
  return best;
}

testing::SamplePair wavy(double height, int along, int across, double phase) {
  testing::SamplePair p = testing::involutes(17, 43, 15);
  for (const int which : {1, 2}) {
    FlankModifications m;
    if (which == 1) m.lead_crowning = 0.006;
    m.profile_wave = {across, phase, height};
    m.helix_wave = {along, phase + 1, height};
    p.modify(which, m);
  }
  p.place.errors.crossing = Angle::degrees(0.01);
  return p;
}

// At 9 µm and four waves over the profile, T has several maxima at the same height.
TEST(WavyContact, FollowsTheGreatestCrest) {
  for (const auto& [height, along, across, phase] :
       {std::array{0.005, 1.0, 1.0, 2.1}, std::array{0.005, 3.0, 2.0, 0.3},
        std::array{0.008, 3.0, 3.0, 0.9}, std::array{0.009, 2.0, 4.0, 1.7}}) {
    const testing::SamplePair sample =
        wavy(height, static_cast<int>(along), static_cast<int>(across), phase);
    const ContactPair pair = sample.pair();
    const int n = 32;
    const std::vector<double> te = transmission_error(pair, n);
    Transmission again(pair);
    for (int i = 2; i < n; i += 4) {
      const double phi = -0.5 * pair.pitch() + pair.pitch() * i / n;
      const double grid = greatest_on_a_grid(pair, phi);
      // Error of the parabola through the grid at a crest.
      constexpr double kParabola = 0.02 * kRadPerArcsec;
      EXPECT_GE(te[static_cast<std::size_t>(i)], grid - kParabola) << height << " position " << i;
      EXPECT_GE(again.at(phi).te(), grid - kParabola) << height << " position " << i << ", alone";
    }
  }
}

// A root relief divides flank 1 into two patches. The patch at the root begins near the base
// circle, and at most a part of it lies opposite flank 2. A relief of amount 0 changes nothing.
TEST(WavyContact, FollowsTheGreatestCrestOverTwoPatches) {
  for (const double start : {0.1, 0.2, 0.3, 0.5}) {
    for (const double amount : {0.0, 0.005}) {
      testing::SamplePair sample = wavy(0.007, 2, 3, 0.9);
      const Gear& gear = sample.gears[0];
      const double root = 2 * *gear.root_form_radius();
      FlankModifications m;
      m.lead_crowning = 0.006;
      m.profile_wave = {3, 0.9, 0.007};
      m.helix_wave = {2, 1.9, 0.007};
      m.root_relief = {amount, root + start * (2 * gear.tip_form_radius() - root)};
      sample.modify(1, m);
      const ContactPair pair = sample.pair();
      ASSERT_EQ(pair.patches(1).size(), 2u);
      const int n = 16;
      const std::vector<double> te = transmission_error(pair, n);
      const std::vector<double> plain = transmission_error(wavy(0.007, 2, 3, 0.9).pair(), n);
      for (int i = 1; i < n; i += 2) {
        const double phi = -0.5 * pair.pitch() + pair.pitch() * i / n;
        constexpr double kParabola = 0.02 * kRadPerArcsec;
        EXPECT_GE(te[static_cast<std::size_t>(i)], greatest_on_a_grid(pair, phi) - kParabola)
            << start << " " << amount << " position " << i;
        if (amount == 0.0) {
          EXPECT_NEAR(te[static_cast<std::size_t>(i)], plain[static_cast<std::size_t>(i)], 1e-11);
        }
      }
    }
  }
}

// A gear without deviations has no field of removed material. Contact is then computed from its
// base circle.
TEST(WavyContact, OneGearMayHaveNoWaves) {
  for (const std::size_t plain : {0, 1}) {
    testing::SamplePair sample = wavy(0.008, 3, 3, 0.9);
    sample.removal[plain] = nullptr;
    const ContactPair pair = sample.pair();
    Transmission transmission(pair);
    ASSERT_TRUE(transmission.wavy());
    constexpr int n = 32;
    const auto touches = one_pitch(transmission, -0.5 * pair.pitch(), n);
    EXPECT_LT(transmission.count().evaluations, 20 * n) << plain;
    for (int i = 2; i < n; i += 4) {
      const double phi = -0.5 * pair.pitch() + pair.pitch() * i / n;
      constexpr double kParabola = 0.02 * kRadPerArcsec;
      EXPECT_GE(touches[static_cast<std::size_t>(i)].te(),
                greatest_on_a_grid(pair, phi) - kParabola)
          << plain << " position " << i;
    }
  }
}

// Because the waves have a closed form, the 32 positions of the curve need on average less than 20
// evaluations each. Without the closed form, a position would need 1000. The extremes do not depend
// on the number of positions.
TEST(WavyContact, NeedsFewEvaluations) {
  const testing::SamplePair sample = wavy(0.009, 2, 4, 1.7);
  const ContactPair pair = sample.pair();
  Transmission transmission(pair);
  ASSERT_TRUE(transmission.wavy());
  const auto touches = one_pitch(transmission, -0.5 * pair.pitch(), 32);
  EXPECT_LT(transmission.count().evaluations, 20 * 32);
  const CurveExtremes extremes = continuous_extremes(transmission, touches);
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  constexpr int kMany = 1024;
  for (const PairTouch& t : one_pitch(transmission, -0.5 * pair.pitch(), kMany)) {
    ASSERT_TRUE(t.found());
    least = std::min(least, t.te());
    greatest = std::max(greatest, t.te());
  }
  EXPECT_GE(extremes.greatest, greatest - 1e-12);
  EXPECT_LE(extremes.least, least + 1e-12);
  // The extremes may lie between two of the many positions. There, TE differs from the nearest
  // position by at most its slope times half a step.
  EXPECT_NEAR(extremes.span(), greatest - least, 0.1 * kRadPerArcsec);
}

}  // namespace
}  // namespace gearwright
