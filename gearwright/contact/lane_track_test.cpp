// Compares the search in lanes with the search of one position after the other. Laws: (1) a step in
// lanes returns the bits of its scalar instance   (2) the touches of a pitch are those of
// over_a_pitch()   (3) the extremes are those of continuous_extremes()   (4) arm and slope are
// those of the field at the touch.
#include "gearwright/contact/lane_track.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"
#include "gearwright/math/sobol.hpp"

namespace gearwright {
namespace {

using detail::LaneTrack;

// Pair number `k` of a family with many kinds of teeth, modifications and errors.
testing::SamplePair sample(std::uint64_t k) {
  std::uint64_t next = 0;
  const auto draw = [&](double lo, double hi) { return lo + (hi - lo) * random_unit(k, next++); };
  const std::array<std::array<int, 2>, 4> teeth{{{17, 43}, {23, 88}, {20, -61}, {31, 30}}};
  const auto& [z1, z2] = teeth[k % teeth.size()];
  testing::SamplePair p = testing::involutes(z1, z2, k % 5 == 0 ? 0.0 : draw(-28, 28));
  for (const int gear : {1, 2}) {
    const Gear& g = p.gears[gear - 1];
    FlankModifications m;
    if (k % 3 == 1) m.lead_crowning = draw(0.001, 0.012);
    if (k % 3 == 1) m.profile_crowning = draw(0.0, 0.006);
    if (k % 3 == 2) m.profile_slope = draw(-0.004, 0.004);
    if (k % 3 == 2) m.lead_slope = draw(-0.004, 0.004);
    const double root = *g.root_form_radius(), tip = g.tip_form_radius();
    const auto shape = k % 2 == 0 ? ReliefShape::linear : ReliefShape::parabolic;
    if (k % 4 >= 2) m.tip_relief = {draw(0.003, 0.02), 2 * (0.3 * root + 0.7 * tip), shape};
    if (k % 8 >= 5) m.root_relief = {draw(0.003, 0.01), 2 * (0.7 * root + 0.3 * tip), shape};
    if (k % 7 == 3) m.end_relief = {draw(0.003, 0.01), draw(1.0, 4.0), shape};
    if (k % 6 != 0) p.modify(gear, m);
  }
  p.place.errors = {.center_distance = draw(-0.02, 0.05),
                    .crossing = Angle::degrees(draw(-0.04, 0.04)),
                    .intersecting = Angle::degrees(draw(-0.06, 0.06)),
                    .axial = draw(-0.5, 0.5)};
  p.place.errors.helix_twist = {draw(-4e-6, 4e-6), draw(-2e-6, 2e-6)};
  p.place.gear2_drives = k % 2 == 1;
  return p;
}

TEST(LaneTrack, TouchesAndExtremesAreThoseOfOneSearchAfterTheOther) {
  int tracks = 0, spans = 0;
  constexpr int kPairs = 300;
  for (std::uint64_t k = 0; k < kPairs; ++k) {
    const testing::SamplePair p = sample(k);
    const ContactPair pair = p.pair();
    Transmission transmission(pair);
    const double first = -0.5 * pair.pitch();
    const int n = k % 9 == 0 ? 128 : 32;
    std::optional<LaneTrack> track;
    const auto lanes = one_pitch(transmission, first, n, &track);
    if (!track) continue;
    ++tracks;
    const auto exact = one_pitch(transmission, first, n);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      ASSERT_TRUE(exact[i].found() && lanes[i].found()) << k << " " << i;
      EXPECT_NEAR(lanes[i].te(), exact[i].te(), 1e-14) << k << " " << i;
      if (lanes[i].touch.arm == 0.0) continue;
      const GapJet jet = transmission.jet_at(lanes[i], lanes[i].touch.s, lanes[i].touch.z);
      EXPECT_NEAR(lanes[i].touch.arm, GapField::arm(jet), 1e-5);
      EXPECT_NEAR(lanes[i].touch.slope, rotation_slope(transmission, lanes[i]), 1e-6);
    }
    const auto found = track->extremes();
    if (!found) continue;
    ++spans;
    const auto extremes = continuous_extremes(transmission, exact);
    EXPECT_NEAR(found->least, extremes.least, 2e-12) << k;
    // Where the bounds of the touch change, continuous_extremes() finds a maximum only to 1e-10
    // rad. The search of whole flanks at the same rotation confirms the value of the track.
    EXPECT_NEAR(found->greatest, extremes.greatest, 1e-10) << k;
    const double top = found->top.phi + found->top.pair * pair.pitch();
    EXPECT_NEAR(transmission.at(top).te(), found->greatest, 2e-12) << k;
  }
  EXPECT_GT(tracks, kPairs / 2);
  EXPECT_GT(spans, kPairs / 2);
}

// On parallel axes, unmodified flanks touch along lines. Flanks of spur gears with a modified
// profile also touch along lines. If only the centre distance varies in such a family, all its
// members touch along lines.
TEST(LaneTrack, LinesOfContactAreSearchedInLanes) {
  int compared = 0;
  for (std::uint64_t k = 0; k < 60; ++k) {
    testing::SamplePair p = testing::involutes(20, k % 3 == 1 ? -61 : 43, k % 3 ? 15.0 : 0.0);
    p.place.errors.center_distance = 0.02 * random_unit(k, 0);
    p.place.gear2_drives = k % 4 < 2;
    FlankModifications m;
    if (k % 3 == 0) m.profile_slope = 0.004 * random_unit(k, 1);
    if (k % 6 == 0) m.tip_relief = {0.01, 2 * p.gears[0].tip_form_radius() - 1.0};
    if (k % 3 == 0) p.modify(1, m);
    const ContactPair pair = p.pair();
    Transmission transmission(pair);
    std::optional<LaneTrack> track;
    const auto lanes = one_pitch(transmission, -0.5 * pair.pitch(), 32, &track);
    ASSERT_TRUE(track) << k;
    const auto exact = one_pitch(transmission, -0.5 * pair.pitch(), 32);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      EXPECT_NEAR(lanes[i].te(), exact[i].te(), 1e-14) << k << " " << i;
      EXPECT_EQ(lanes[i].touch.flat, exact[i].touch.flat) << k << " " << i;
      EXPECT_EQ(on_edge(transmission, lanes[i]), on_edge(transmission, exact[i])) << k;
    }
    const auto found = track->extremes();
    if (!found) continue;
    EXPECT_NEAR(found->span(), continuous_extremes(transmission, exact).span(), 4e-12) << k;
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

// Three branches meet within a step: two patches of one tooth pair and the next pair. The handover
// between two of them lies 0.8 µrad below the curve.
TEST(LaneTrack, TheLeastValueIsOnTheCurve) {
  const testing::SamplePair p = sample(287);
  const ContactPair pair = p.pair();
  Transmission transmission(pair);
  double least = 1.0;
  for (const PairTouch& t : one_pitch(transmission, -0.5 * pair.pitch(), 8192))
    least = std::min(least, t.te());
  const auto extremes =
      continuous_extremes(transmission, one_pitch(transmission, -0.5 * pair.pitch(), 32));
  EXPECT_LE(extremes.least, least);
  EXPECT_GT(extremes.least, least - 3e-7);
}

TEST(LaneTrack, VectorsReturnTheBitsOfTheScalarTwin) {
  for (std::uint64_t k = 0; k < 100; ++k) {
    detail::LaneBlock a;
    for (std::size_t c = 0; c < detail::kLaneIn; ++c)
      for (std::size_t i = 0; i < detail::kLaneBlock; ++i)
        a.in[c][i] = 4.0 * random_unit(k, c * detail::kLaneBlock + i) - 2.0;
    detail::LaneBlock b = a;
    detail::touch_step(a);
    detail::touch_step_scalar(b);
    for (std::size_t c = 0; c < detail::kLaneOut; ++c) {
      for (std::size_t i = 0; i < detail::kLaneBlock; ++i) {
        using O = detail::LaneOut;
        const auto is = [&](O k) { return b.out[static_cast<std::size_t>(k)][i] > 0.0; };
        if (c >= static_cast<std::size_t>(O::te) && c <= static_cast<std::size_t>(O::by_n) &&
            !is(O::last))
          continue;
        if (c >= static_cast<std::size_t>(O::sigma) && is(O::holds)) continue;
        const double x = a.out[c][i], y = b.out[c][i];
        EXPECT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << c << " " << i;
      }
    }
  }
}

TEST(LaneTrack, OtherFlanksAreSearchedAlone) {
  const auto none = [](const testing::SamplePair& p) {
    const ContactPair pair = p.pair();
    Transmission transmission(pair);
    return !LaneTrack::of(transmission, 0.0, 32);
  };
  EXPECT_TRUE(none(testing::arcs()));
  auto wavy = testing::involutes(20, 41, 15);
  EXPECT_FALSE(none(wavy));
  FlankModifications m;
  m.profile_wave = {3, 0.0, 0.002};
  wavy.modify(1, m);
  EXPECT_TRUE(none(wavy));
  auto hollow = testing::involutes(20, 41, 15);
  m = {};
  m.lead_crowning = -0.005;
  hollow.modify(2, m);
  EXPECT_TRUE(none(hollow));
}

}  // namespace
}  // namespace gearwright
