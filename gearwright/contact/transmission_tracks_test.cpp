// The touches of relieved flanks over a pitch. The oracle searches all pairs of patches of all
// tooth pairs from scratch at each position.
#include <gtest/gtest.h>

#include <random>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/continuous.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"
#include "gearwright/contact/transmission.hpp"

namespace gearwright {
namespace {

class Draw {
 public:
  explicit Draw(unsigned seed) : seeded_(seed) {}
  double between(double lo, double hi) { return std::uniform_real_distribution<>(lo, hi)(seeded_); }
  bool half() { return between(0, 1) < 0.5; }

  // Draws modifications of usual sizes. Every flank has a tip relief. About half of the flanks have
  // each of the other modifications.
  FlankModifications flank(const Gear& g) {
    FlankModifications m;
    const auto relief = [&](double at_0, double at_1) {
      const double part = between(0.1, 0.45);
      return Relief{between(0.0, 0.03), at_0 + part * (at_1 - at_0),
                    half() ? ReliefShape::linear : ReliefShape::parabolic};
    };
    const double root = 2 * *g.root_form_radius(), tip = 2 * g.tip_form_radius();
    m.tip_relief = relief(tip, root);
    if (half()) m.root_relief = relief(root, tip);
    if (half()) m.end_relief = relief(0.0, g.spec.face_width);
    if (half()) m.profile_crowning = between(0.0, 0.006);
    if (half()) m.lead_crowning = between(0.0, 0.010);
    if (half()) m.profile_slope = between(-0.008, 0.008);
    if (half()) m.lead_slope = between(-0.008, 0.008);
    return m;
  }

 private:
  std::mt19937 seeded_;
};

testing::SamplePair relieved(Draw& draw, int i) {
  constexpr std::array<std::array<int, 3>, 6> kPairs{
      {{20, 41, 0}, {17, 43, 15}, {23, 61, -20}, {20, -61, 12}, {19, -70, 0}, {31, 24, 28}}};
  const auto& [z1, z2, helix] = kPairs[static_cast<std::size_t>(i) % kPairs.size()];
  auto p = testing::involutes(z1, z2, helix);
  for (const int gear : {1, 2})
    if (gear == 1 + i % 2 || draw.half()) p.modify(gear, draw.flank(p.gears[gear - 1]));
  const double wide = i % 3 == 0 ? 0.1 : 1.0;
  p.place.errors.center_distance = wide * draw.between(-0.03, 0.03);
  p.place.errors.crossing = Angle::degrees(wide * draw.between(-0.04, 0.04));
  p.place.errors.intersecting = Angle::degrees(wide * draw.between(-0.04, 0.04));
  p.place.gear2_drives = draw.half();
  return p;
}

// Every fourth position of a pitch, from the position i % 4 on, is searched again from scratch.
void expect_greatest_touches(const testing::SamplePair& p, int i) {
  constexpr int kPositions = 32;
  const ContactPair pair = p.pair();
  Transmission followed(pair), scan(pair);
  const double first = -0.5 * pair.pitch();
  const auto touches = followed.over_a_pitch(first, kPositions);
  EXPECT_EQ(followed.too_long(), 0);
  for (int m = i % 4; m < kPositions; m += 4) {
    const PairTouch& t = touches[static_cast<std::size_t>(m)];
    const PairTouch cold = scan.at(first + m * pair.pitch() / kPositions);
    ASSERT_EQ(t.found(), cold.found());
    // Both searches end within rounding of the greatest T.
    if (!cold.found()) continue;
    EXPECT_NEAR(t.te(), cold.te(), 5e-15) << i << " " << m;
  }
}

TEST(TransmissionTracks, relieved_flanks_have_the_greatest_touch_of_all_patches) {
  Draw draw(11);
  for (int i = 0; i < 60; ++i) expect_greatest_touches(relieved(draw, i), i);
}

// The tips of these rings reach beyond the point at which the line of action touches the base
// circle of the pinion, so T has a maximum at the tip as well.
TEST(TransmissionTracks, tips_of_rings_beyond_the_line_of_action) {
  Draw draw(12);
  for (int i = 0; i < 24; ++i) {
    auto p = testing::involutes(10 + i % 4, -(38 + 2 * (i % 5)), i % 2 ? 12.3 : 0.0);
    if (i >= 8)
      for (const int gear : {1, 2})
        if (draw.half()) p.modify(gear, draw.flank(p.gears[gear - 1]));
    p.place.errors.center_distance = draw.between(-0.05, 0.05);
    p.place.errors.crossing = Angle::degrees(draw.between(-0.04, 0.04));
    p.place.errors.intersecting = Angle::degrees(draw.between(-0.04, 0.04));
    p.place.gear2_drives = draw.half();
    expect_greatest_touches(p, i);
  }
}

// Relieved flanks need at most three times the evaluations of plain flanks.
TEST(TransmissionTracks, relief_needs_little_more_work) {
  auto p = testing::involutes(17, 43, 15);
  p.place.errors.crossing = Angle::degrees(0.01);
  const auto evaluations = [&] {
    const ContactPair pair = p.pair();
    Transmission t(pair);
    t.over_a_pitch(-0.5 * pair.pitch(), 32);
    return t.count().evaluations;
  };
  const long plain = evaluations();
  for (const int gear : {1, 2}) {
    const double tip = 2 * p.gears[gear - 1].tip_form_radius();
    FlankModifications m;
    m.tip_relief = {0.015, tip - 1.2, ReliefShape::linear};
    m.lead_crowning = 0.006;
    p.modify(gear, m);
  }
  EXPECT_LE(evaluations(), 3 * plain);
}

}  // namespace
}  // namespace gearwright
