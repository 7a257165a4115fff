#include "gearwright/pair/arc_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/outline_gap.hpp"

namespace gearwright {
namespace {

using testing::made;

using Complex = std::complex<double>;
using Cutter = ArcRack::Cutter;

CylindricalSpec spec_of(Rack rack, int teeth, double beta_deg) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = teeth, .module = 4.0, .beta_deg = beta_deg, .face_width = 60.0});
  s.rack = std::move(rack);
  return s;
}

ArcRack rack_of(Cutter cutter) {
  const double l = cutter == Cutter::F ? 0.487786 : 0.637786;  // θ = 30°, and both centres lie on
                                                               // the normal
  ArcRack rack = default_arc_rack(cutter);
  rack.arc_radius = cutter == Cutter::F ? 1.4 : 1.55;
  rack.center_a = l * std::cos(kPi / 6);
  rack.center_b = l * std::sin(kPi / 6);
  return rack;
}

ArcPair mounted(const CylindricalSpec& s_1, const CylindricalSpec& s_2,
                std::optional<double> a = std::nullopt) {
  return testing::taken(mount_arcs(made(s_1), made(s_2), a));
}

// The distance between a contact, given in the housing frame, and the point with the normal angle θ
// on the leading flanks of gear i. The gear is rotated by `turned`, and the nearest tooth is used.
double distance_to_flank(const ArcPair& pair, std::size_t i, const ArcPairContact& contact,
                         double turned) {
  const Gear& gear = pair.gears[i];
  const bool convex = contact.convex_gear == static_cast<int>(i) + 1;
  const Eigen::Isometry3d pose = i == 0 ? pair.pose_1().isometry() : pair.pose_2().isometry();
  const Vec3 own = pose.inverse() * contact.at.point;
  const Complex at =
      Complex(own.x(), own.y()) * std::polar(1.0, -turned - gear.twist() * contact.at.point.z());
  const double pitch = 2 * kPi / gear.spec.teeth;
  double least = 1e9;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    if (arc.name != ArcName::flank) continue;
    const auto& cut = curve_as<RackTrochoid>(*arc.curve);
    if ((cut.circle().q > 0.0) != convex) continue;
    const Vec2 w = cut.point(contact.at.theta.rad());
    // Seen from +z, gear 1 turns clockwise. Its leading flank is the side y < 0 of the tooth, and
    // gear 2 is also touched on the side y < 0 of its tooth.
    const Complex flank(w.x(), -w.y());
    for (int k = 0; k < gear.spec.teeth; ++k)
      least = std::min(least, std::abs(flank * std::polar(1.0, pitch * k) - at));
  }
  return least;
}

void expect_touching(const ArcPair& pair) {
  ASSERT_FALSE(pair.contacts.empty());
  for (const ArcPairContact& c : pair.contacts) {
    const bool first = c.convex_gear == 1;
    EXPECT_NEAR(distance_to_flank(pair, 0, c, first ? 0.0 : c.at.rotation_offset.rad()), 0.0,
                1e-11);
    EXPECT_NEAR(distance_to_flank(pair, 1, c, first ? c.at.rotation_offset.rad() : 0.0), 0.0,
                1e-11);
    EXPECT_GT(c.at.gap[0], 0.0);
    EXPECT_LT(c.at.normal.y(), 0.0);  // the direction in which gear 1 pushes gear 2
  }
}

TEST(ArcPair, contacts_lie_on_both_gears) {
  for (const double hand : {1.0, -1.0}) {
    for (const double change : {0.0, 0.08, -0.05}) {
      const double beta = 18 * hand;
      const auto F = spec_of(rack_of(Cutter::F), 15, beta);
      const auto P = spec_of(rack_of(Cutter::P), 40, -beta);
      const double a = (15 + 40) * 2.0 / std::cos(18 * kPi / 180) + change;
      expect_touching(mounted(F, P, a));
      // The racks are exchanged. F cuts gear 2, and P cuts gear 1.
      const auto F_2 = spec_of(rack_of(Cutter::F), 40, -beta);
      const auto P_1 = spec_of(rack_of(Cutter::P), 15, beta);
      const ArcPair swapped = mounted(P_1, F_2, a);
      expect_touching(swapped);
      EXPECT_EQ(swapped.contacts.front().convex_gear, 2);
      const ArcPair both = mounted(spec_of(*gbt12759_rack(4.0), 15, beta),
                                   spec_of(*gbt12759_rack(4.0), 40, -beta), a);
      EXPECT_EQ(both.contacts.size(), 2u);
      expect_touching(both);
    }
  }
}

TEST(ArcPair, numbers_of_the_pair) {
  const ArcPair pair =
      mounted(spec_of(rack_of(Cutter::F), 15, 18), spec_of(rack_of(Cutter::P), 40, -18));
  EXPECT_EQ(pair.center_distance, pair.reference_center_distance);
  EXPECT_DOUBLE_EQ(pair.center_distance, 55 * 2.0 / std::cos(18 * kPi / 180));
  EXPECT_DOUBLE_EQ(pair.gear_ratio(), 40.0 / 15);
  const double p_x = kPi * 4.0 / std::sin(18 * kPi / 180);
  EXPECT_DOUBLE_EQ(pair.overlap_ratio, 60.0 / p_x);
  EXPECT_EQ(pair.contact_ratio(), pair.overlap_ratio);
  EXPECT_NEAR(pair.face_for_contact, p_x, 1e-12);
  EXPECT_NEAR(pair.tip_clearance[0], 0.15 * 4, 1e-12);
  EXPECT_NEAR(pair.tip_clearance[1], 0.30 * 4, 1e-12);
  EXPECT_NEAR(pair.base_backlash, 0.0, 1e-12);
  EXPECT_TRUE(pair.warnings.empty());
  // Thinner teeth cause backlash. It is the sum of the allowances along the datum line, projected
  // on the normal at θ.
  auto F = spec_of(rack_of(Cutter::F), 15, 18);
  auto P = spec_of(rack_of(Cutter::P), 40, -18);
  F.thickness_allowance = -0.06;
  P.thickness_allowance = -0.04;
  EXPECT_NEAR(mounted(F, P).base_backlash, 0.10 * std::cos(kPi / 6), 1e-5);
}

// Teeth with two contact points have continuous contact on a face narrower than the axial pitch.
TEST(ArcPair, double_arcs_need_less_face) {
  const DoubleArcRack rack = *gbt12759_rack(4.0);
  auto s_1 = spec_of(rack, 18, 22), s_2 = spec_of(rack, 50, -22);
  const double p_x = kPi * 4.0 / std::sin(22 * kPi / 180);
  const ArcPair pair = mounted(s_1, s_2);
  EXPECT_LT(pair.face_for_contact, p_x);
  EXPECT_GT(pair.face_for_contact, p_x / 2);
  EXPECT_DOUBLE_EQ(pair.contact_ratio(), 2 * pair.overlap_ratio);
  // The backlash of the standard is e_f − S_a along the datum line, which is 0.06 m_n.
  EXPECT_NEAR(pair.base_backlash, (1.1773 - 1.1174) * 4 * std::cos(24 * kPi / 180), 2e-3);
  s_1.face_width = s_2.face_width = pair.face_for_contact * 0.99;
  EXPECT_TRUE(warns(mounted(s_1, s_2), WarningCode::contact_ratio));
  s_1.face_width = s_2.face_width = pair.face_for_contact * 1.01;
  EXPECT_FALSE(warns(mounted(s_1, s_2), WarningCode::contact_ratio));
}

TEST(ArcPair, warnings_say_what_is_amiss) {
  auto F = spec_of(rack_of(Cutter::F), 15, 18), P = spec_of(rack_of(Cutter::P), 40, -18);
  const double a_d = mounted(F, P).center_distance;
  std::get<ArcRack>(F.rack).pressure_angle = Angle::degrees(25);
  EXPECT_TRUE(warns(mounted(F, P), WarningCode::pressure_angle));
  std::get<ArcRack>(F.rack).pressure_angle = Angle::degrees(30.01);
  EXPECT_FALSE(warns(mounted(F, P), WarningCode::pressure_angle));
  EXPECT_TRUE(warns(mounted(F, P, a_d + 0.25), WarningCode::contact_off_flank));
  EXPECT_FALSE(warns(mounted(F, P, a_d + 0.05), WarningCode::contact_off_flank));
  EXPECT_TRUE(warns(mounted(F, P, a_d - 0.05), WarningCode::negative_backlash));
  P.tip_diameter = made(P).reference_diameter + 4.0;
  std::get<ArcRack>(F.rack).dedendum = 0.1;
  EXPECT_TRUE(warns(mounted(F, P), WarningCode::root));
  auto other = spec_of(rack_of(Cutter::P), 40, -18.1);
  const ArcPair unequal = mounted(F, other);
  EXPECT_TRUE(warns(unequal, WarningCode::unequal_lead));
  EXPECT_TRUE(unequal.contacts.empty());
  EXPECT_FALSE(unequal.backlash_rotation);
}

TEST(ArcPair, errors_name_the_key_and_the_numbers) {
  const auto F = spec_of(rack_of(Cutter::F), 15, 18), P = spec_of(rack_of(Cutter::P), 40, -18);
  const auto key = [&](const CylindricalSpec& s_1, const CylindricalSpec& s_2,
                       std::optional<double> a = std::nullopt) {
    const auto pair = mount_arcs(made(s_1), made(s_2), a);
    if (pair) return std::string("mounted");
    EXPECT_NE(pair.error().message().find(pair.error().field), std::string::npos);
    return pair.error().field;
  };
  EXPECT_EQ(key(F, P), "mounted");
  auto involute = spec_of(rack_of(Cutter::P), 40, -18);
  involute.rack = StraightRack{};
  EXPECT_EQ(key(F, involute), "gear2.rack");
  EXPECT_EQ(key(F, spec_of(rack_of(Cutter::F), 40, -18)), "gear2.rack");
  EXPECT_EQ(key(F, spec_of(rack_of(Cutter::P), 40, 18)), "gear2.helix_angle");
  EXPECT_EQ(key(spec_of(rack_of(Cutter::F), 15, 0), spec_of(rack_of(Cutter::P), 40, 0)),
            "gear1.helix_angle");
  auto coarse = P;
  coarse.normal_module = 5.0;
  EXPECT_EQ(key(F, coarse), "gear2.normal_module");
  auto wide = F;
  std::get<ArcRack>(wide.rack).arc_radius = 1.56;
  EXPECT_EQ(key(wide, P), "gear2.rack.arc_radius");
  DoubleArcRack thick;
  thick.convex_radius = 1.43;
  thick.convex_offset = 0.75;
  EXPECT_EQ(key(spec_of(thick, 15, 18), spec_of(thick, 40, -18)), "gear1.rack.concave_radius");
  const double a_d = mounted(F, P).center_distance;
  EXPECT_EQ(key(F, P, a_d + 2.0), "pair.center_distance");
  auto severed = F;
  severed.teeth = 1;
  std::get<ArcRack>(severed.rack).dedendum = 0.56;
  const auto none = make_gear(severed);
  if (none && !none->exists()) {
    EXPECT_EQ(key(severed, P), "gear1.rack.dedendum");
  }
}

TEST(ArcPair, the_range_of_centre_distances_named_is_the_range) {
  const auto F = spec_of(rack_of(Cutter::F), 15, 18), P = spec_of(rack_of(Cutter::P), 40, -18);
  const double a_d = mounted(F, P).center_distance;
  const double to_end = (1.55 - 1.4) * 4 * 0.5;  // from θ = 30° to 90°; the distance to 0° is equal
  EXPECT_TRUE(mount_arcs(made(F), made(P), a_d - to_end + 1e-3));
  EXPECT_FALSE(mount_arcs(made(F), made(P), a_d - to_end - 1e-3));
  EXPECT_TRUE(mount_arcs(made(F), made(P), a_d + to_end - 1e-3));
  EXPECT_FALSE(mount_arcs(made(F), made(P), a_d + to_end + 1e-3));
}

// If the gears have equal leads, the least gap of their sections is the gap at the contact point,
// which has a closed form.
TEST(ArcPair, gap_of_the_outlines_is_half_the_backlash) {
  for (const double more : {-0.02, 0.0, 0.01, 0.03}) {
    CylindricalSpec one = spec_of(rack_of(Cutter::F), 12, 15.0);
    CylindricalSpec two = spec_of(rack_of(Cutter::P), 40, -15.0);
    two.thickness_allowance = -0.1;
    const double a = mounted(one, two).center_distance;
    const ArcPair pair = mounted(one, two, a + more);
    const OutlineGap gap = outline_gap(pair.gears[0].tooth->outline, pair.gears[1].tooth->outline,
                                       pair.center_distance);
    const auto& flanks = gap.of(ArcName::flank, ArcName::flank);
    ASSERT_TRUE(flanks) << more;
    EXPECT_NEAR(flanks->gap, pair.backlash_rotation->at(1).rad() / 2, 1e-11) << more;
    ASSERT_TRUE(pair.overlap && pair.free_play) << more;
    EXPECT_EQ(pair.overlap->empty(), pair.free_play->rad() >= 0.0) << more;
  }
}

// If a tip enters the mating fillet above the root circle, only the warning `overlap` explains the
// collision.
TEST(ArcPair, an_overlap_is_said) {
  int overlaps = 0;
  for (double longer = 0.0; longer < 4.0; longer += 0.05) {
    CylindricalSpec one = spec_of(rack_of(Cutter::F), 12, 15.0);
    one.tip_diameter = made(one).tip_diameter + longer;
    const ArcPair pair = mounted(one, spec_of(rack_of(Cutter::P), 40, -15.0));
    ASSERT_TRUE(pair.overlap);
    if (pair.overlap->empty()) continue;
    const CollisionCause cause = pair.overlap->front().cause;
    if (cause == CollisionCause::root || cause == CollisionCause::negative_backlash) continue;
    ++overlaps;
    EXPECT_TRUE(warns(pair, WarningCode::overlap)) << to_string(cause);
  }
  EXPECT_GT(overlaps, 0);
}

}  // namespace
}  // namespace gearwright
