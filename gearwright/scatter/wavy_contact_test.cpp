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
#include "gearwright/contact/testing/sample_pairs.hpp"
#include "gearwright/scatter/uneven_teeth.hpp"

namespace gearwright {
namespace {

// T over flank 1 inside flank 2, for every tooth pair, by a grid and the parabola through its best rows,
// rad. Every touch has a T of the field, so the greatest is at least this one.
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
    const Gear& g = p.gears[which - 1];
    FlankModifications m;
    if (which == 1) m.lead_crowning = 0.006;
    std::array<FlankModifications, 2> flanks{m, m};
    const FlankExtent extent = flank_extent(g);
    add_wave(flanks, extent, {false, across, phase, height});
    add_wave(flanks, extent, {true, along, phase + 1, height});
    p.modify(which, flanks[0]);
  }
  p.place.errors.crossing = Angle::degrees(0.01);
  return p;
}

TEST(WavyContact, FollowsTheGreatestCrest) {
  for (const auto& [height, along, across, phase] :
       {std::array{0.005, 1.0, 1.0, 2.1}, std::array{0.005, 3.0, 2.0, 0.3},
        std::array{0.008, 3.0, 3.0, 0.9}}) {
    const testing::SamplePair sample =
        wavy(height, static_cast<int>(along), static_cast<int>(across), phase);
    const ContactPair pair = sample.pair();
    const int n = 32;
    const std::vector<double> te = transmission_error(pair, n);
    Transmission again(pair);
    for (int i = 2; i < n; i += 4) {
      const double phi = -0.5 * pair.pitch() + pair.pitch() * i / n;
      const double grid = greatest_on_a_grid(pair, phi);
      constexpr double kParabola = 0.02 * kRadPerArcsec;  // error of the grid at a crest
      EXPECT_GE(te[static_cast<std::size_t>(i)], grid - kParabola) << height << " position " << i;
      EXPECT_GE(again.at(phi).te(), grid - kParabola) << height << " position " << i << ", alone";
    }
  }
}

}  // namespace
}  // namespace gearwright
