// Derivatives are compared with closed forms. tests/property/contact_laws_test.cpp verifies the
// laws over seeded pairs.
#include "gearwright/contact/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

using P = Modification;

std::vector<Sensitivity> by(const testing::SamplePair& p, const std::vector<Influence>& influences,
                            double rotation = 0.05) {
  ContactRequest request;
  request.rotations = {Angle::radians(rotation)};
  request.influences = influences;
  const auto r = analyse_contact(p.pair(), request);
  std::vector<Sensitivity> all;
  for (const auto& column : r.sensitivities) all.push_back(column[0]);
  return all;
}

// Gear 2 of a conjugate external pair lags by tan α/r_w2 per mm of centre distance; in an internal
// pair it leads by this angle. Crowning and an axial displacement have no effect if the pair
// touches in the middle of the face.
TEST(Sensitivity, of_conjugate_gears) {
  for (const int z2 : {41, -61}) {
    auto p = testing::involutes(20, z2, 0);
    FlankModifications nothing;
    nothing.lead_crowning = 1e-7;
    p.modify(1, nothing);
    p.modify(2, nothing);
    const double alpha = 20 * std::numbers::pi / 180;
    const auto s = by(p, {{ErrorKind::center_distance},
                          {ErrorKind::center_distance, 1, P::lead_crowning},
                          {ErrorKind::center_distance, 2, P::profile_slope},
                          {ErrorKind::axial}});
    EXPECT_NEAR(s[0].te, -std::tan(alpha) / z2, 1e-6);
    EXPECT_NEAR(s[1].te, 0.0, 1e-9);
    EXPECT_NEAR(s[3].te, 0.0, 1e-12);
  }
}

// The pair touches at an end of the narrower face, the face of gear 2. f_Hβ of a gear turns the
// section at the height z by κ z, where z is measured from the middle of its face. The axial
// position of the edge of gear 2 does not change.
TEST(Sensitivity, helix_slopes_at_a_face) {
  auto p = testing::involutes(20, 41, 0);
  p.place.errors.crossing = Angle::radians(1e-5);
  const auto s =
      by(p, {{ErrorKind::helix_slope1}, {ErrorKind::helix_slope2}, {ErrorKind::crossing}});
  // At z = −9 mm, κ1 z of gear 1 acts on TE through the gear ratio, and κ2 z of gear 2 acts
  // directly.
  EXPECT_NEAR(s[0].te, 9.0 / (20.0 * 20.0) * 20.0 / 41.0, 1e-7);
  EXPECT_NEAR(s[1].te, 9.0 / (41.0 * 18.0), 1e-7);
  EXPECT_NEAR(s[2].te, 9.0 / 41.0, 1e-4);
}

// If gear 2 drives, the other flanks touch, and an error has the opposite effect on TE.
TEST(Sensitivity, of_the_other_flanks) {
  for (const int z2 : {41, -61}) {
    auto p = testing::involutes(20, z2, 0);
    const auto one = by(p, {{ErrorKind::center_distance}});
    p.place.gear2_drives = true;
    const auto two = by(p, {{ErrorKind::center_distance}}, -0.05);
    EXPECT_NEAR(one[0].te, -two[0].te, 1e-12);
  }
}

}  // namespace
}  // namespace gearwright
