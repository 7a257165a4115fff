// Patterns and gap maps are compared with closed forms and with the gap at single points.
#include "gearwright/contact/pattern.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

// Conjugate flanks touch at every point that lies opposite the mating flank at some position. At
// other points, the gap is infinite.
TEST(Pattern, conjugate_flanks_touch_everywhere) {
  const auto p = testing::involutes(20, 41, 15);
  const auto rasters = contact_pattern(p.pair(), 64);
  for (int g : {0, 1}) {
    const FlankRaster& r = rasters[g];
    ASSERT_EQ(r.gap.size(), 33u * 65u);
    EXPECT_EQ(r.height.front(), g == 0 ? -10.0 : -9.0);
    // The tolerances cover the gap at half a step of rotation from the contact line, and on gear 2
    // also the interpolation between the nodes of gear 1.
    for (std::size_t i = 11; i < 22; ++i)
      for (std::size_t k = 13; k < 52; ++k) EXPECT_LT(r.at(i, k), g == 0 ? 5e-5 : 5e-4);
  }
  EXPECT_TRUE(std::isinf(rasters[0].at(16, 0)));  // z = −10; the face of gear 2 ends at −9
}

// Gear 2 is narrower than gear 1 and touches up to both of its end faces.
TEST(Pattern, ends_of_gear_2_are_marked) {
  const auto r = contact_pattern(testing::involutes(20, 41, 15).pair(), 64)[1];
  for (const std::size_t k : {std::size_t{0}, std::size_t{64}}) EXPECT_LT(r.at(16, k), 1e-3);
}

// The error of the pattern is of second order in the rotation step: with a step that is four times
// finer, it is less than an eighth.
TEST(Pattern, gaps_fall_with_the_step) {
  const auto p = testing::involutes(20, 41, 15);
  double worst[2] = {};
  int i = 0;
  for (const int n : {32, 128}) {
    const auto r = contact_pattern(p.pair(), n, {7, 9})[0];
    for (std::size_t k = 2; k < 7; ++k) worst[i] = std::max(worst[i], r.at(4, k));
    ++i;
  }
  EXPECT_GT(worst[0], 0.0);
  EXPECT_LT(worst[1], worst[0] / 8);
}

// Lead crowning C_β leaves the ends without marking. The least gap there is the removed material.
TEST(Pattern, crowning_is_the_gap_at_the_ends) {
  auto p = testing::involutes(20, 41, 0);
  p.gears[1].spec.face_width = 20.0;
  FlankModifications m;
  m.lead_crowning = 0.02;
  p.modify(1, m);
  const auto r = contact_pattern(p.pair(), 256, {7, 9})[0];
  EXPECT_LT(r.at(4, 4), 2e-5);
  EXPECT_NEAR(r.at(4, 0), 0.02, 2e-5);
  EXPECT_NEAR(r.at(4, 8), 0.02, 2e-5);
  EXPECT_NEAR(r.at(4, 6), 0.02 / 4, 2e-5);
}

// The raster of gear 2 has its own frame. An edge contact at an end of its face is marked at this
// end: the lower end if gear 1 drives, and the upper end if gear 2 drives.
TEST(Pattern, heights_belong_to_their_gear) {
  for (const bool second : {false, true}) {
    auto p = testing::involutes(20, 41, 0);
    p.place.errors.crossing = Angle::radians(3e-4);
    p.place.gear2_drives = second;
    const auto r = contact_pattern(p.pair(), 64, {7, 9});
    // Δγ > 0 turns the +z end of gear 1 towards +y, which is away from gear 2 if gear 1 drives.
    const std::size_t near = second ? 8 : 0;
    EXPECT_LT(r[1].at(4, near), 1e-3);
    EXPECT_GT(r[1].at(4, 8 - near), 3e-3);
  }
}

// Without errors, the pattern of a double-arc pair consists of two bands along the face on both
// gears, because each contact point stays at a constant diameter. The case is difficult, because a
// circle about the axis of the mating gear meets the flank twice.
TEST(Pattern, of_double_arcs_is_two_bands) {
  const auto gear = [](int teeth, double helix_deg) {
    CylindricalSpec s = testing::plain_spec(
        {.teeth = teeth, .module = 4.0, .beta_deg = helix_deg, .face_width = 60.0});
    s.rack = *gbt12759_rack(4.0);
    return std::move(make_gear(s)).take();
  };
  testing::SamplePair p{{gear(18, 22), gear(50, -22)}, {}, {}};
  p.place.center_distance = (p.gears[0].reference_diameter + p.gears[1].reference_diameter) / 2;
  const auto rasters = contact_pattern(p.pair(), 64);
  constexpr double kMarking = 0.006;  // mm
  for (const FlankRaster& r : rasters) {
    int bands = 0;
    bool marked = false;
    for (std::size_t row = 0; row < r.diameter.size(); ++row) {
      const double middle = r.at(row, 32);
      const bool here = middle < kMarking;
      for (std::size_t k = 4; here && k < 61; ++k)
        EXPECT_NEAR(r.at(row, k), middle, 1e-4) << r.diameter[row] << " " << r.height[k];
      bands += here && !marked;
      marked = here;
    }
    EXPECT_EQ(bands, 2);
  }
}

TEST(Pattern, gap_map_of_one_position) {
  auto p = testing::arcs();
  p.place.errors.crossing = Angle::radians(1e-4);
  const FlankRaster r = gap_map(p.pair(), Angle::radians(0.05), 0, {41, 81});
  double least = 1e300;
  for (const double gap : r.gap) least = std::min(least, gap);
  EXPECT_GE(least, 0.0);
  EXPECT_LT(least, 5e-3);
  // Another tooth pair has a larger gap.
  const FlankRaster other = gap_map(p.pair(), Angle::radians(0.05), 3, {41, 81});
  double apart = 1e300;
  for (const double gap : other.gap) apart = std::min(apart, gap);
  EXPECT_GT(apart, least);
}

}  // namespace
}  // namespace gearwright
