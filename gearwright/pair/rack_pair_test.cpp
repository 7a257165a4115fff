// Tests the laws of a pinion and a rack.
//
// (1) The differences between a pair with z2 teeth and the rack decrease like 1/z2 from 10⁴ to 10⁵
//     teeth.
// (2) If the distance increases by δ, the backlash along the line of action increases by 2 δ sin
//     α_n and both clearances increase by δ. The travel per turn does not change.
// (3) An allowance on the rack causes the same backlash as an equal allowance on the pinion.
// (4) Doubling the module doubles lengths and changes no contact ratio.
#include "gearwright/pair/rack_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/pair/drive.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {
namespace {

constexpr double kFriction = 0.1;

// The fillet of ISO53-B ends below the tip of the mating rack. The rounded fillet of ISO53-A ends
// 3e-5 modules above this tip. It would clip the path of contact with the rack, but not with a
// wheel.
Gear pinion(int teeth, double m, double x, double beta, double allowance = 0.0) {
  return testing::taken(make_gear({.teeth = teeth,
                                   .normal_module = m,
                                   .helix_angle = Angle::degrees(beta),
                                   .profile_shift = x,
                                   .thickness_allowance = allowance,
                                   .face_width = 20 * m / 2,
                                   .rack = *iso53_rack("ISO53-B")}));
}

// The differences between a pair with z2 teeth and the rack.
std::vector<double> beyond(const RackPair& rack, int z2) {
  const Gear wheel = pinion(z2, 2, 0, -rack.pinion.spec.helix_angle.deg());
  const Pair pair = testing::taken(mount(rack.pinion, wheel, {.friction = kFriction}));
  const ParallelPair& p = *pair.parallel();
  const auto at_A = rack.specific_sliding(rack.contact_start()),
             at_E = rack.specific_sliding(rack.recess);
  const auto halves = approach_and_recess(p), of_rack = rack.approach_and_recess();
  EXPECT_NEAR(p.mesh.overlap_ratio, rack.overlap_ratio, 1e-12);
  return {p.center_distance - p.gears[1].reference_diameter / 2 - rack.center_distance,
          p.mesh.rack.sides[0].transverse_angle - rack.pinion.reference().transverse_pressure_angle,
          p.transverse_contact_ratio() - rack.transverse_contact_ratio(),
          p.mesh.true_ratio - rack.true_contact_ratio(),
          halves[0] - of_rack[0],
          halves[1] - of_rack[1],
          *p.sliding_A.zeta_1 / *at_A[0] - 1,
          *p.sliding_A.zeta_2 - *at_A[1],
          *p.sliding_E.zeta_1 - *at_E[0],
          *p.sliding_E.zeta_2 - *at_E[1],
          p.tip_clearance[0] - rack.tip_clearance[0],
          p.tip_clearance[1] - rack.tip_clearance[1],
          *p.efficiency->gear1_drives - *rack.efficiency->gear1_drives,
          *p.efficiency->gear2_drives - *rack.efficiency->gear2_drives};
}

TEST(RackPair, is_the_limit_of_pairs) {
  for (const auto& [teeth, x, beta] :
       {std::tuple{17, 0.1, 0.0}, std::tuple{24, 0.0, 0.0}, std::tuple{20, 0.2, 15.0},
        std::tuple{16, 0.4, -28.0}, std::tuple{8, 0.0, 25.0}, std::tuple{10, 0.0, 0.0}}) {
    const RackPair rack =
        testing::taken(mount_rack(pinion(teeth, 2, x, beta), {}, {}, {}, kFriction));
    const std::vector<double> some = beyond(rack, 10'000), more = beyond(rack, 100'000);
    for (std::size_t i = 0; i < some.size(); ++i) {
      EXPECT_LT(std::abs(some[i]), 0.01) << i;
      // (1): with ten times the teeth, the difference is a tenth. Radii of 10⁵ mm cause rounding
      // errors of 1e-10.
      EXPECT_NEAR(more[i], some[i] / 10, 0.01 * std::abs(some[i]) + 1e-9) << i;
    }
  }
}

// An independent program computes these ratios for 8 teeth, m_n = 2, β = 25° and a fillet radius of
// 0.3 modules. The rack reaches beyond the base tangent point of the undercut pinion.
TEST(RackPair, counts_the_usable_flank_of_an_undercut_pinion) {
  const RackPair p = testing::taken(mount_rack(pinion(8, 2, 0, 25), {}));
  const auto [approach, recess] = p.approach_and_recess();
  EXPECT_NEAR(approach, 0.35896, 5e-6);
  EXPECT_NEAR(recess, 0.58922, 5e-6);
  EXPECT_NEAR(p.true_contact_ratio(), approach + recess, 1e-14);
  const auto zeta = p.specific_sliding(p.contact_start());
  ASSERT_TRUE(zeta[0].has_value());
  EXPECT_LT(*zeta[1], 1.0);  // ζ = 1 at the base tangent point of the mating gear
}

TEST(RackPair, backlash_and_clearances_follow_the_distance) {
  const Gear gear = pinion(22, 2, 0.3, 12);
  const RackPair tight = testing::taken(mount_rack(gear, {}));
  const RackPair apart = testing::taken(mount_rack(gear, {}, tight.center_distance + 0.1));
  const double alpha_n = Angle::degrees(20).rad();
  EXPECT_NEAR(tight.base_backlash(), 0.0, 1e-14);
  EXPECT_NEAR(apart.base_backlash(), 0.2 * std::sin(alpha_n), 1e-14);  // (2)
  EXPECT_NEAR(apart.normal_backlash(), 0.2 * std::tan(alpha_n), 1e-14);
  for (const std::size_t i : {0, 1})
    EXPECT_NEAR(apart.tip_clearance[i] - tight.tip_clearance[i], 0.1, 1e-13);
  EXPECT_EQ(apart.travel_per_turn, tight.travel_per_turn);
  EXPECT_LT(apart.transverse_contact_ratio(), tight.transverse_contact_ratio());
  const RackPair thin_rack = testing::taken(mount_rack(gear, {.thickness_allowance = -0.05}));
  const RackPair thin_pinion = testing::taken(mount_rack(pinion(22, 2, 0.3, 12, -0.05), {}));
  EXPECT_NEAR(thin_rack.base_backlash(), 0.05 * std::cos(alpha_n), 1e-13);  // (3)
  EXPECT_NEAR(thin_pinion.base_backlash(), thin_rack.base_backlash(), 1e-13);
}

TEST(RackPair, lengths_scale_with_the_module) {
  const RackPair one =
      testing::taken(mount_rack(pinion(19, 1, 0.2, 20), {.teeth = 30, .height = 5}));
  const RackPair two =
      testing::taken(mount_rack(pinion(19, 2, 0.2, 20), {.teeth = 30, .height = 10}));
  EXPECT_NEAR(two.center_distance, 2 * one.center_distance, 1e-12);  // (4)
  EXPECT_NEAR(*two.rack.length(), 2 * *one.rack.length(), 1e-12);
  EXPECT_NEAR(two.mounting_distance(), 2 * one.mounting_distance(), 1e-12);
  EXPECT_NEAR(two.transverse_contact_ratio(), one.transverse_contact_ratio(), 1e-12);
  EXPECT_NEAR(two.true_contact_ratio(), one.true_contact_ratio(), 1e-12);
}

TEST(RackPair, what_is_wrong_is_a_warning_and_what_cannot_be_an_error) {
  const Gear gear = pinion(22, 2, 0, 0);
  EXPECT_TRUE(testing::taken(mount_rack(gear, {.teeth = 30, .height = 9})).warnings.empty());
  EXPECT_TRUE(warns(testing::taken(mount_rack(gear, {}, 21.9)), WarningCode::negative_backlash));
  EXPECT_TRUE(warns(testing::taken(mount_rack(gear, {}, 21.4)), WarningCode::root));
  EXPECT_TRUE(warns(testing::taken(mount_rack(gear, {}, 27.0)), WarningCode::no_contact));
  EXPECT_TRUE(warns(testing::taken(mount_rack(gear, {}, 24.0)), WarningCode::contact_ratio));
  const RackPair undercut = testing::taken(mount_rack(pinion(9, 2, 0, 0), {}));
  // The rack that cuts the pinion reaches farther than the mating rack, so nothing collides.
  EXPECT_TRUE(warns(undercut, WarningCode::contact_lost_to_undercut));
  EXPECT_FALSE(warns(undercut, WarningCode::base_tangent));
  EXPECT_LT(undercut.true_contact_ratio(), undercut.transverse_contact_ratio());
  // Without backlash, the centre distance is 17.66 mm.
  const RackPair close = testing::taken(mount_rack(pinion(17, 2, 0.2, 10), {}, 10.0));
  EXPECT_TRUE(warns(close, WarningCode::negative_backlash));
  EXPECT_EQ(close.warnings.back().code, WarningCode::no_contact);
  EXPECT_NE(close.warnings.back().message.find(" A greater centre distance would help."),
            std::string::npos)
      << close.warnings.back().message;
  const Gear ring = testing::taken(make_gear({.teeth = -60, .normal_module = 2, .face_width = 20}));
  const auto refused = mount_rack(ring, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "gear1.teeth");
}

// The roots are 2.5 mm below the datum line, and the limits in modules are those of a gear.
TEST(RackPair, rejects_a_body_that_cannot_be_made) {
  const Gear gear = pinion(20, 2, 0, 0);
  for (const RackBar& bar : {RackBar{.height = 2.501}, RackBar{.height = 2e5},
                             RackBar{.face_width = 0.002}, RackBar{.face_width = 2e5}})
    EXPECT_TRUE(mount_rack(gear, bar));
  for (const auto& [bar, field, limit] :
       {std::tuple{RackBar{.height = 1.0}, "gear2.height", "2.501 mm"},
        {RackBar{.height = 2.5}, "gear2.height", "2.501 mm"},
        {RackBar{.height = 2.01e5}, "gear2.height", "200000 mm"},
        {RackBar{.face_width = 1e-9}, "gear2.face_width", "0.002 mm"},
        {RackBar{.face_width = 2.01e5}, "gear2.face_width", "200000 mm"}}) {
    const auto made = mount_rack(gear, bar);
    ASSERT_FALSE(made) << field;
    EXPECT_EQ(made.error().field, field);
    EXPECT_NE(made.error().rule.find(limit), std::string::npos) << made.error().rule;
  }
}

TEST(RackPair, names_what_removes_the_teeth_of_the_pinion) {
  const auto made = mount_rack(pinion(1, 2, 0, 0), {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "gear1.profile_shift");
  EXPECT_NE(made.error().rule.find("root_fillet"), std::string::npos) << made.error().rule;
}

}  // namespace
}  // namespace gearwright
