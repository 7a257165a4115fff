// Compares the contact of involute pairs with a dense set of points on both flanks. The pairs
// include errors, modifications, internal gears and either gear driving
// (tests/oracle/brute_flanks.hpp).
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/property/contact_pairs.hpp"

namespace gearwright::property {
namespace {

// (1) The contact lies on both flanks at the computed rotation. (2) No other point of the flanks
//     touches earlier. Law (1) shows that the contact is real, and law (2) that no earlier contact
//     was missed.
void against_places(const ModifiedPair& p, const ContactResult& r) {
  const BruteContact brute(p.brute);
  const double sign = p.set.mount.gear2_drives ? -1.0 : 1.0;
  EXPECT_EQ(r.unfinished, 0);
  for (const ContactPoint& q : r.positions) {
    SCOPED_TRACE(::testing::Message()
                 << "rotation " << q.rotation1.rad() << ", " << to_string(q.kind));
    const auto t = brute.touch(q.rotation1.rad(), 4);
    ASSERT_EQ(t.has_value(), q.kind != TouchKind::none);
    if (!t) continue;
    const auto seen = brute.look(q.rotation1.rad(), q.pair, q.diameter[0] / 2, q.height[0]);
    // On a ridge that is flatter than a nanometre, the middle of the line of contact is not
    // determined.
    const double arm = std::min(p.brute.one.rho_low, p.brute.two.rho_low);
    EXPECT_NEAR(seen.te, q.te.rad(),
                q.kind == TouchKind::line ? 2 * kLineGap / arm : 1e-12);  // (1)
    EXPECT_LT(seen.outside, 1e-9 * q.diameter[1]);
    EXPECT_LT(sign * t->te, sign * q.te.rad() + 1e-12);  // (2)
  }
}

TEST(ContactPlaces, of_pairs_with_errors) {
  Wanted want;
  want.modifications = false;
  over_pairs(21, 12, want, [](const ModifiedPair& p, Random&) {
    against_places(p, over_a_pitch(p.set.pair(), 6));
  });
}
TEST(ContactPlaces, of_modified_pairs) {
  over_pairs(22, 14, {}, [](const ModifiedPair& p, Random&) {
    against_places(p, over_a_pitch(p.set.pair(), 6));
  });
}
TEST(ContactPlaces, of_hollow_flanks) {
  Wanted want;
  want.hollow = true;
  over_pairs(23, 10, want, [](const ModifiedPair& p, Random&) {
    against_places(p, over_a_pitch(p.set.pair(), 6));
  });
}
TEST(LongContactPlaces, of_modified_pairs) {
  Wanted want;
  over_pairs(24, 300, want, [](const ModifiedPair& p, Random& random) {
    against_places(p, over_a_pitch(p.set.pair(), random.chance(0.5) ? 6 : 20));
  });
}
TEST(LongContactPlaces, of_hollow_flanks) {
  Wanted want;
  want.hollow = true;
  over_pairs(25, 150, want, [](const ModifiedPair& p, Random& random) {
    against_places(p, over_a_pitch(p.set.pair(), random.chance(0.5) ? 6 : 20));
  });
}

}  // namespace
}  // namespace gearwright::property
