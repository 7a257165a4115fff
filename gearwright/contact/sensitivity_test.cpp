// Derivatives with closed forms; the laws over seeded pairs: tests/property/contact_laws_test.cpp.
#include "gearwright/contact/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

using P = RemovalField::Parameter;

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

// Gear 2 of a conjugate pair lags by tan α/r_w2 per mm of distance, and by 1/r_b2 for a tooth of
// either gear that is thinner by 1 mm along its normal.
TEST(Sensitivity, of_conjugate_gears) {
  auto p = testing::involutes(20, 41, 0);
  FlankModifications nothing;
  nothing.lead_crowning = 1e-7;
  p.modify(1, nothing);
  p.modify(2, nothing);
  const double alpha = 20 * std::numbers::pi / 180;
  const auto s = by(p, {{ErrorKind::center_distance},
                        {ErrorKind::center_distance, 1, P::lead_crowning},
                        {ErrorKind::center_distance, 2, P::profile_slope},
                        {ErrorKind::axial}});
  EXPECT_NEAR(s[0].te, -std::tan(alpha) / 41.0, 1e-6);
  EXPECT_NEAR(s[1].te, 0.0, 1e-9);  // touches in the middle of the face
  EXPECT_NEAR(s[3].te, 0.0, 1e-12);
}

// An end of a face touches. f_Hβ of either gear tilts its flank relative to the other one about the
// middle of the face, on the reference cylinder. The narrower face counts, and the edge of gear 2
// does not move.
TEST(Sensitivity, helix_slopes_at_a_face) {
  auto p = testing::involutes(20, 41, 0);
  p.place.errors.crossing = Angle::radians(1e-5);
  const auto s =
      by(p, {{ErrorKind::helix_slope1}, {ErrorKind::helix_slope2}, {ErrorKind::crossing}});
  // At z = −9 mm: κ z of gear 1 counts through the ratio, κ2 Z directly.
  EXPECT_NEAR(s[0].te, 9.0 / (20.0 * 20.0) * 20.0 / 41.0, 1e-7);
  EXPECT_NEAR(s[1].te, 9.0 / (41.0 * 18.0), 1e-7);
  EXPECT_NEAR(s[2].te, 9.0 / 41.0, 1e-4);
}

// With the other driver, rotations have the same sign, and errors have the opposite effect.
TEST(Sensitivity, of_the_other_flanks) {
  auto p = testing::involutes(20, 41, 0);
  const auto one = by(p, {{ErrorKind::center_distance}});
  p.place.gear2_drives = true;
  const auto two = by(p, {{ErrorKind::center_distance}}, -0.05);
  EXPECT_NEAR(one[0].te, -two[0].te, 1e-12);
}

}  // namespace
}  // namespace gearwright
