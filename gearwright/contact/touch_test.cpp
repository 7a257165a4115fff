// Tests the search for the greatest T: kinds of maxima, stopping conditions, amount of work.
#include "gearwright/contact/touch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

struct Search {
  ContactPair pair;
  GapField field;
  TouchSearch search;

  explicit Search(const testing::SamplePair& p, double phi = 0.0)
      : pair(p.pair()),
        field(pair.field(pair.patches(1)[0], pair.patches(2)[0])),
        search(field, pair.mesh_azimuth(), pair.reach()) {
    field.set_rotation(phi);
  }
};

// No point of a fine grid has a greater T.
TEST(TouchSearch, nothing_is_higher) {
  auto p = testing::arcs();
  p.place.errors.crossing = Angle::radians(4e-4), p.place.errors.center_distance = 0.03;
  for (const double phi : {-0.4, -0.1, 0.0, 0.2, 0.5}) {
    Search s(p, phi);
    const Touch t = s.search.cold();
    ASSERT_TRUE(t.found());
    const FlankPatch& one = s.field.one();
    double s2 = t.s2;
    for (int i = 0; i <= 60; ++i) {
      for (int k = 0; k <= 60; ++k) {
        const double a = one.s_lo + (one.s_hi - one.s_lo) * i / 60;
        const double z = one.z_lo + (one.z_hi - one.z_lo) * k / 60;
        const GapJet j = s.field.at(a, z, s2);
        bool inside = true;
        for (int b = 0; b < detail::kBounds; ++b) inside &= s.search.bound(j, a, z, b) >= 0.0;
        if (!inside || std::abs(std::arg(j.w1)) > 2.0) continue;
        EXPECT_LE(j.t.v, t.te + 1e-15);
      }
    }
  }
}

// Misaligned spur gears touch at an end of the narrower face. To first order, the transmission
// error is half the face width times Δγ, divided by the pitch radius.
TEST(TouchSearch, face_edges) {
  for (const double tilt : {1e-5, -1e-5}) {
    auto p = testing::involutes(20, 41, 0);
    p.place.errors.crossing = Angle::radians(tilt);
    const Touch t = Search(p).search.cold();
    ASSERT_TRUE(t.found());
    EXPECT_NEAR(t.te / (1e-5 * 9.0 / 41.0), 1.0, 1e-3);
    EXPECT_FALSE(t.active.inside());
    EXPECT_EQ(t.active.first, tilt > 0 ? 6 : 7);
    EXPECT_GT(t.multiplier[0], 0.0);
  }
}

TEST(TouchSearch, a_flat_ridge_is_one) {
  const Touch t = Search(testing::involutes(20, 41, 15)).search.cold();
  ASSERT_TRUE(t.found());
  EXPECT_TRUE(t.flat);
  EXPECT_NEAR(t.te, 0.0, 1e-15);
}

// If the gears are too far apart, no point of flank 1 lies opposite flank 2, and the result gives
// this reason.
TEST(TouchSearch, no_room) {
  auto p = testing::involutes(20, 41, 0);
  p.place.errors.center_distance = 5.0;
  const Touch t = Search(p).search.cold();
  EXPECT_FALSE(t.found());
  EXPECT_EQ(t.stop, Touch::Stop::no_room);
  EXPECT_EQ(Search(testing::involutes(20, 41, 0), 2.0).search.cold().stop, Touch::Stop::no_room);
}

// A search that starts at the linear extrapolation of the last two touches needs one evaluation. A
// cold start needs more.
TEST(TouchSearch, work) {
  auto p = testing::arcs();
  p.place.errors.crossing = Angle::radians(2e-4);
  Search s(p);
  const double step = s.pair.pitch() / 64;
  const Touch a = s.search.cold();
  const long cold = s.search.count().evaluations;
  EXPECT_EQ(s.search.count().cold_starts, 1);
  EXPECT_LE(cold, 110);
  s.field.set_rotation(step);
  const Touch b = s.search.from(a.s, a.z, a.s2, a.active);
  EXPECT_LE(b.evaluations, 4);
  s.field.set_rotation(2 * step);
  const Touch c = s.search.from(2 * b.s - a.s, 2 * b.z - a.z, b.s2, b.active);
  EXPECT_EQ(c.evaluations, 1);
  EXPECT_EQ(s.search.count().evaluations, cold + b.evaluations + 1);
}

// A flank with hollow lead touches at both ends of the face. T has two maxima, and the greater one
// is returned first.
TEST(TouchSearch, every_maximum) {
  auto p = testing::involutes(20, 41, 0);
  FlankModifications m;
  m.lead_crowning = -0.01;
  p.modify(1, m);
  p.place.errors.crossing = Angle::radians(1e-6);
  Search s(p);
  const auto all = s.search.every_maximum();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_GT(all[0].te, all[1].te);
  EXPECT_LT(all[0].z * all[1].z, 0.0);
}

}  // namespace
}  // namespace gearwright
