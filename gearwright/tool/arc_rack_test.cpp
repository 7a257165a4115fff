#include "gearwright/tool/arc_rack.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/numbers.hpp"

namespace gearwright {
namespace {

using Cutter = ArcRack::Cutter;

ArcRack rack_of(Cutter cutter) {
  ArcRack rack = default_arc_rack(cutter);
  const double psi = kPi / 6;
  const double l = 0.243893 / std::sin(psi) + (cutter == Cutter::P ? 0.15 : 0.0);
  rack.arc_radius = cutter == Cutter::F ? 1.4 : 1.55;
  rack.center_a = l * std::cos(psi);
  rack.center_b = l * std::sin(psi);
  rack.pressure_angle = Angle::degrees(30);
  return rack;
}

std::string key_of(const ArcRack& rack) {
  const auto arcs = arcs_of(rack);
  if (arcs) return "made";
  EXPECT_NE(arcs.error().message().find(arcs.error().field), std::string::npos);
  EXPECT_FALSE(arcs.error().value.empty());
  return arcs.error().field;
}

// Where the two racks touch, they have a common point and a common normal, so the material of P
// begins where the material of F ends.
TEST(ArcRack, F_and_P_touch_at_the_pressure_angle) {
  const Angle psi = Angle::degrees(30);
  const RackOfArcs F = *arcs_of(rack_of(Cutter::F)), P = *arcs_of(rack_of(Cutter::P));
  const Vec2 on_F = point_at(F.arcs.back(), psi), on_P = point_at(P.arcs.back(), psi);
  // Both heights are measured from the pitch plane.
  EXPECT_NEAR(on_F.x(), -on_P.x(), 1e-15);
  // A tooth of one rack lies in a space of the other.
  EXPECT_NEAR(on_F.y(), kPi / 2 - on_P.y(), 1e-15);
  // The normals of both sides meet on the pitch plane, in the middle of the tooth.
  EXPECT_NEAR(on_F.y(), on_F.x() / std::tan(psi.rad()), 1e-15);
}

TEST(ArcRack, full_radius) {
  for (const Cutter cutter : {Cutter::F, Cutter::P}) {
    ArcRack rack = rack_of(cutter);
    rack.root_fillet_radius = full_radius(rack) * (1 - 1e-13);
    const auto arcs = arcs_of(rack);
    ASSERT_TRUE(arcs) << arcs.error().message();
    EXPECT_NEAR(arcs->arcs.front().center_offset, kPi / 2, 1e-12);
    rack.root_fillet_radius *= 1 + 1e-10;
    EXPECT_EQ(key_of(rack), "rack.root_fillet_radius");
  }
}

TEST(ArcRack, names_a_radius_only_if_it_is_possible) {
  ArcRack rack = rack_of(Cutter::F);
  rack.center_a = 1.134;
  rack.center_b = -0.329;
  rack.arc_radius = 2.516;
  rack.dedendum = -0.077;
  rack.root_fillet_radius = 0.622;
  EXPECT_EQ(key_of(rack), "rack.dedendum");
  EXPECT_LT(full_radius(rack), rack.root_fillet_radius);
  rack.root_fillet_radius = full_radius(rack);
  EXPECT_EQ(key_of(rack), "rack.dedendum");
  rack = rack_of(Cutter::F);
  rack.center_a = -1.58;  // the arcs of both sides lie beyond the middle of the cutter's tip
  EXPECT_EQ(key_of(rack), "rack.center_a");
}

// The message names the height at which both flank arcs meet, which is the greatest addendum.
TEST(ArcRack, the_limits_named_are_the_limits) {
  ArcRack F = rack_of(Cutter::F);
  const double top = std::sqrt(F.arc_radius * F.arc_radius - F.center_a * F.center_a) - F.center_b;
  F.addendum = top * (1 - 1e-14);
  EXPECT_EQ(key_of(F), "made");
  F.addendum = top * (1 + 1e-12);
  EXPECT_EQ(key_of(F), "rack.addendum");
  EXPECT_NE(arcs_of(F).error().message().find("meet in a point"), std::string::npos);
  ArcRack deep = rack_of(Cutter::F);
  deep.dedendum = deep.center_b + deep.root_fillet_radius - 1e-9;
  EXPECT_EQ(key_of(deep), "made");
  deep.dedendum += 2e-9;
  EXPECT_EQ(key_of(deep), "rack.dedendum");
  ArcRack P = rack_of(Cutter::P);
  P.root_fillet_radius = 0.0;
  P.dedendum = P.arc_radius - P.center_b + 1e-9;
  EXPECT_EQ(key_of(P), "rack.dedendum");
}

TEST(ArcRack, what_is_impossible_is_named) {
  const auto key = [](Cutter cutter, auto change) {
    ArcRack rack = rack_of(cutter);
    change(rack);
    return key_of(rack);
  };
  for (const Cutter cutter : {Cutter::F, Cutter::P}) {
    EXPECT_EQ(key(cutter, [](ArcRack&) {}), "made");
    EXPECT_EQ(key(cutter, [](ArcRack& r) { r.arc_radius = 0.0; }), "rack.arc_radius");
    EXPECT_EQ(key(cutter, [](ArcRack& r) { r.arc_radius = NAN; }), "rack.arc_radius");
    EXPECT_EQ(key(cutter, [](ArcRack& r) { r.center_a = 1e9; }), "rack.center_a");
    EXPECT_EQ(key(cutter, [](ArcRack& r) { r.center_b = NAN; }), "rack.center_b");
    EXPECT_EQ(key(cutter, [](ArcRack& r) { r.root_fillet_radius = -0.1; }),
              "rack.root_fillet_radius");
    EXPECT_EQ(key(cutter, [](ArcRack& r) { r.pressure_angle = Angle::degrees(80); }),
              "rack.pressure_angle");
  }
  EXPECT_EQ(key(Cutter::F, [](ArcRack& r) { r.center_a = 1.4; }), "rack.center_a");
  EXPECT_EQ(key(Cutter::F, [](ArcRack& r) { r.dedendum = -1.3; }), "rack.dedendum");
  EXPECT_EQ(key(Cutter::P, [](ArcRack& r) { r.root_fillet_radius = 1.6; }),
            "rack.root_fillet_radius");
  EXPECT_EQ(key(Cutter::P, [](ArcRack& r) { r.dedendum = -0.1; }), "rack.root_fillet_radius");
  EXPECT_EQ(key(Cutter::P, [](ArcRack& r) { r.root_fillet_radius = 0.7; }),
            "rack.root_fillet_radius");
  EXPECT_EQ(key(Cutter::P,
                [](ArcRack& r) {
                  r.root_fillet_radius = 0.0;
                  r.dedendum = 1.15;
                }),
            "rack.dedendum");
  EXPECT_EQ(key(Cutter::P, [](ArcRack& r) { r.addendum = 0.3; }), "rack.addendum");
}

}  // namespace
}  // namespace gearwright
