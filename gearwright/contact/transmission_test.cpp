// Curves of transmission error: handover, lost contact, number of followed touches and evaluations.
#include "gearwright/contact/transmission.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

TEST(Transmission, conjugate_flanks_have_no_error) {
  for (const int z2 : {41, -61}) {
    for (const double te : transmission_error(testing::involutes(20, z2, 12).pair(), 16))
      EXPECT_NEAR(te, 0.0, 1e-14);
  }
}

// With more backlash, gear 2 lags by half of the increase at every position. If gear 2 drives, it
// leads by this angle.
TEST(Transmission, backlash_is_a_constant) {
  auto p = testing::involutes(20, 41, 0);
  p.place.center_distance += 0.2;
  const auto pair = mount_as<ParallelPair>(p.gears[0], p.gears[1], {p.place.center_distance});
  ASSERT_TRUE(pair);
  const double half = pair->mesh.backlash.rotation[1] / 2;
  for (const double te : transmission_error(p.pair(), 9)) EXPECT_NEAR(te, -half, 1e-14);
  p.place.gear2_drives = true;
  for (const double te : transmission_error(p.pair(), 9)) EXPECT_NEAR(te, half, 1e-14);
}

// Tip relief removes edge contact from a pair with errors. At first, T of the patches in the relief
// is far below T of the other patches, and it increases from there. The curve must equal a search
// of whole flanks from scratch at each position.
TEST(Transmission, a_relieved_tip_is_followed_from_far_below) {
  auto p = testing::involutes(20, 88, 0);
  const Gear& g = p.gears[0];
  FlankModifications m;
  m.tip_relief = {0.0008, 2 * (0.25 * *g.root_form_radius() + 0.75 * g.tip_form_radius()),
                  ReliefShape::linear};
  m.profile_crowning = 0.0016;
  p.modify(1, m);
  p.place.errors.crossing = Angle::radians(-1.4e-5);
  const ContactPair pair = p.pair();
  for (const int n : {8, 64}) {
    const auto te = transmission_error(pair, n);
    for (int i = 0; i < 8; ++i) {
      Transmission cold(pair);
      const double at = pair.pitch() * (-0.5 + i / 8.0);
      EXPECT_NEAR(te[i * n / 8], cold.at(at).te(), 1e-13) << n << " " << i;
    }
  }
}

TEST(Transmission, lost_contact_is_a_fact) {
  auto p = testing::involutes(20, 41, 0);
  p.place.errors.center_distance = 3.7;  // the tips do not reach each other over part of a pitch
  const auto some = transmission_error(p.pair(), 32);
  p.place.errors.center_distance = 5.0;
  const auto none = transmission_error(p.pair(), 32);
  EXPECT_TRUE(std::all_of(none.begin(), none.end(), [](double t) { return std::isnan(t); }));
  EXPECT_TRUE(std::isnan(peak_to_peak(none)));
  EXPECT_TRUE(std::any_of(some.begin(), some.end(), [](double t) { return !std::isnan(t); }));
  const auto r = analyse_contact(p.pair(), {});
  EXPECT_TRUE(r.contact_lost);
  EXPECT_EQ(r.positions[0].kind, TouchKind::none);
  EXPECT_TRUE(r.harmonics.empty());
}

// The TE curve of misaligned circular arcs is a saw tooth. Its peak to peak and its harmonics are
// those of the values of the curve.
TEST(Transmission, numbers_of_a_curve) {
  auto p = testing::arcs();
  p.place.errors.crossing = Angle::radians(2e-4);
  ContactRequest request;
  request.positions = 64;
  const auto r = analyse_contact(p.pair(), request);
  ASSERT_EQ(r.positions.size(), 64u);
  const auto te = transmission_error(p.pair(), 64);
  for (int i = 0; i < 64; ++i) EXPECT_EQ(te[i], r.positions[i].te.rad());
  EXPECT_EQ(r.peak_to_peak.rad(), peak_to_peak(te));
  ASSERT_FALSE(r.harmonics.empty());
  double cosine = 0.0, sine = 0.0;
  for (int i = 0; i < 64; ++i) {
    const double x = 2 * std::numbers::pi * i / 64;
    cosine += te[i] * std::cos(x), sine += te[i] * std::sin(x);
  }
  EXPECT_NEAR(r.harmonics[0].rad(), 2 * std::hypot(cosine, sine) / 64, 1e-15);
  EXPECT_EQ(r.unfinished, 0);
}

// The amount of work is limited. A larger number means that the search has become slower.
TEST(Transmission, work) {
  auto arcs = testing::arcs();
  arcs.place.errors.crossing = Angle::radians(2e-4);
  auto involutes = testing::involutes(20, 41, 15);
  involutes.place.errors.crossing = Angle::radians(2e-4);
  auto crowned = involutes;
  FlankModifications m;
  m.lead_crowning = 0.01;
  crowned.modify(1, m);
  const auto work = [](const testing::SamplePair& p) {
    const ContactPair pair = p.pair();
    Transmission t(pair);
    t.over_a_pitch(-0.5 * pair.pitch(), 64);
    EXPECT_EQ(t.too_long(), 0);
    return t.count();
  };
  const TouchCount a = work(arcs), b = work(involutes), c = work(crowned);
  EXPECT_LE(a.evaluations, 130);
  EXPECT_LE(b.evaluations, 180);
  EXPECT_LE(c.evaluations, 160);
  EXPECT_LE(a.searches, 90);
  EXPECT_LE(b.searches, 140);
  EXPECT_LE(c.searches, 120);
  EXPECT_EQ(a.cold_starts, 0);  // a search from nine points finds the first touch
  EXPECT_EQ(b.cold_starts, 0);
}

}  // namespace
}  // namespace gearwright
