// Laws of uneven pitches. TE over the long period is compared with its definition, which searches
// every tooth pair at every rotation independently.
#include "gearwright/scatter/uneven_teeth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "gearwright/contact/contact.hpp"
#include "gearwright/scatter/member.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {
namespace {

double range_of(const std::vector<double>& v) {
  return *std::max_element(v.begin(), v.end()) - *std::min_element(v.begin(), v.end());
}

double step_of(const std::vector<double>& v) {
  double step = 0.0;
  for (std::size_t k = 0; k < v.size(); ++k)
    step = std::max(step, std::abs(v[(k + 1) % v.size()] - v[k]));
  return step;
}

TEST(UnevenPitch, StaysWithinBothLimits) {
  const ContactSetup setup = testing::crowned_helical_pair().setup();
  const Gear& gear = setup.gear(2);
  const double r = gear.reference_diameter / 2;
  int at_total = 0;
  int at_single = 0;
  for (int i = 0; i < 40; ++i) {
    const VaryingPitch tolerance{2, 0.030, i < 20 ? 0.003 : 0.020};
    const double share = 0.1 + 0.9 * (i % 20) / 19.0;
    const auto e = uneven_pitch(gear, tolerance, share, 0.3 * i, (i % 10) / 9.0);
    ASSERT_EQ(e.size(), 43u);
    EXPECT_NEAR(std::accumulate(e.begin(), e.end(), 0.0), 0.0, 1e-15);
    const double total = r * range_of(e) / (share * tolerance.total);
    const double single = r * step_of(e) / tolerance.single;
    EXPECT_NEAR(std::max(total, single), 1.0, 1e-12);
    at_total += total > single ? 1 : 0;
    at_single += total > single ? 0 : 1;
    EXPECT_EQ(e, uneven_pitch(gear, tolerance, share, 0.3 * i, (i % 10) / 9.0));
  }
  EXPECT_GT(at_total, 5);
  EXPECT_GT(at_single, 2);
  // An eccentricity alone is a sine.
  const auto sine = uneven_pitch(gear, {2, 0.03, 1.0}, 1.0, 0.7, 1.0);
  const double half = 0.5 * range_of(sine);
  for (std::size_t k = 0; k < sine.size(); ++k)
    EXPECT_NEAR(sine[k], half * std::sin(2 * std::numbers::pi * k / 43.0 + 0.7), 1e-2 * half);
}

// [T14.22] is evaluated as printed, for every tooth pair separately.
double by_definition(const ContactPair& pair, int n, const std::array<int, 2>& teeth,
                     const std::array<std::vector<double>, 2>& pitch) {
  Transmission transmission(pair);
  const double step = pair.turned() * pair.pitch() / n;
  const double first = pair.to_world(-0.5 * pair.pitch());
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  const int period = std::lcm(teeth[0], teeth[1]);
  for (int p = 0; p < period; ++p) {
    for (int i = 0; i < n; ++i) {
      double te = -std::numeric_limits<double>::infinity();
      for (int k = p - 4; k <= p + 4; ++k) {
        const PairTouch t = transmission.of_pair_0(first + (i + (p - k) * n) * step);
        if (!t.found()) continue;
        const auto of = [&](std::size_t g) {
          return pitch[g].empty() ? 0.0
                                  : pitch[g][static_cast<std::size_t>((k + 4 * period) % teeth[g])];
        };
        te = std::max(te, t.te() + pair.ratio() * of(0) - of(1));
      }
      least = std::min(least, te);
      greatest = std::max(greatest, te);
    }
  }
  return greatest - least;
}

TEST(LongPeriod, IsTheDefinition) {
  auto drawn = testing::spur_pair(true);
  drawn.gears[0].teeth = 12;
  drawn.gears[1].teeth = 16;
  drawn.gears[0].profile_shift = 0.4;
  drawn.center_distance = 29.0;
  drawn.errors.crossing = Angle::degrees(0.02);
  const ContactSetup setup = drawn.setup();
  const std::array<std::vector<double>, 2> pitch{
      uneven_pitch(setup.gear(1), {1, 0.02, 0.006}, 0.9, 0.5, 0.3),
      uneven_pitch(setup.gear(2), {2, 0.03, 0.007}, 1.0, 1.5, 0.6)};
  for (const bool gear2_drives : {false, true}) {
    const ContactPair pair = setup.pair(gear2_drives);
    Transmission transmission(pair);
    const auto touches = one_pitch(transmission, -0.5 * pair.pitch(), 6);
    const double found = long_period_span(transmission, touches, {12, 16}, pitch);
    EXPECT_NEAR(found, by_definition(pair, 6, {12, 16}, pitch), 1e-11);
    // Laws (1) and (2) of long_period_span().
    const double alike = long_period_span(transmission, touches, {12, 16}, {});
    std::vector<double> te;
    for (const PairTouch& t : touches) te.push_back(t.te());
    EXPECT_NEAR(alike, peak_to_peak(te), 1e-14);
    EXPECT_GT(found, alike);
    EXPECT_LE(found, alike + pair.ratio() * range_of(pitch[0]) + range_of(pitch[1]) + 1e-14);
  }
}

TEST(GradedFlank, SlopesReachOverTheWholeFlank) {
  const ContactSetup setup = testing::crowned_helical_pair().setup();
  const auto g = graded_flank(setup.gear(1), FlankTolerances::iso_2013, 6);
  ASSERT_TRUE(g);
  // By hand, [T10.16] and [T10.17] give 7.1 and 8.6 µm for d = 44.0, m_n = 2.5, b = 25 and grade 6,
  // before rounding to 0.5 µm.
  EXPECT_NEAR(g->helix_slope, 0.0085 * 25 / 22.5, 0.0006);
  EXPECT_GT(g->profile_slope, 0.0065);
  EXPECT_LT(g->profile_slope, 0.0090);
  const GradedAxes axes = graded_axes(0.013, 25);
  EXPECT_DOUBLE_EQ(axes.crossing, 0.5 * 0.013 / 25);
  EXPECT_DOUBLE_EQ(axes.intersecting, 2 * axes.crossing);
}

TEST(Member, PitchesChangeTheLongPeriodAlone) {
  const ContactSetup setup = testing::plain_helical_pair().setup();
  const Distribution share = Distribution::of({{0, 1}}).value();
  const std::vector<ScatterTolerance> pitch{
      {"gear1.pitch", 1.0, share, VaryingPitch{1, 0.02, 0.006}},
      {"gear2.pitch", 1.0, share, VaryingPitch{2, 0.03, 0.007}}};
  const MemberRequest request{16, false, {}};
  const FamilyMember drawn = member_at(setup, deviation_at(setup, {}, {}), request);
  const FamilyMember uneven = member_at(
      setup, deviation_at(setup, pitch, std::vector{0.8, 20.0, 0.4, 0.9, 200.0, 0.7}), request);
  using Q = ScatterQuantity;
  EXPECT_FALSE(drawn[Q::long_period]);
  EXPECT_GT(uneven[Q::long_period], 10 * *uneven[Q::peak_to_peak]);
  for (const Q q : {Q::peak_to_peak, Q::harmonic1, Q::mean, Q::least_play})
    EXPECT_EQ(uneven[q], drawn[q]);
  const FamilyMember even = member_at(
      setup, deviation_at(setup, pitch, std::vector{0.0, 20.0, 0.4, 0.0, 200.0, 0.7}), request);
  ASSERT_TRUE(even[Q::long_period]);
  EXPECT_LE(*even[Q::long_period], *drawn[Q::peak_to_peak] + 1e-15);
}

}  // namespace
}  // namespace gearwright
