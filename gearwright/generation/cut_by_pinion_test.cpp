//   z_0, x_0   the cutter's teeth and shift      E   generating centre distance, module 1
#include "gearwright/generation/cut_by_pinion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/generation/testing/joined_outline.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {
namespace {

using namespace literals;
using testing::expect_joined;
using testing::names;
using enum ArcName;

constexpr double kAlpha = kPi / 9;

// A spur gear of module 1. With the default blank, the rack ends the teeth.
GeneratedTooth by_rack(int teeth, double shift, const StraightRack& rack, double blank = kInfinity,
                       const CircularFillets& fillets = {}) {
  auto edge = make_edge(rack, 1.0, 20_deg);
  EXPECT_TRUE(edge);
  return testing::taken(cut_by_rack(edge->edge, {teeth / 2.0, 1.0, shift}, teeth, blank, fillets));
}

StraightRack rounded(double addendum = 1.25, double radius = 0.25) {
  StraightRack rack;
  rack.addendum = addendum;
  rack.dedendum = 1.25;
  rack.root_fillet_radius = 0.0;
  rack.tip_fillet_radius = radius;
  return rack;
}

GeneratedTooth cutter_of(int teeth, double shift) { return by_rack(teeth, shift, rounded()); }

double no_blank(int teeth) { return teeth > 0 ? kInfinity : 0.0; }

GeneratedTooth cut(const GeneratedTooth& cutter, const PinionMotion& motion, double blank) {
  return testing::taken(cut_by_pinion(cutter, motion, blank));
}

GeneratedTooth cut(const GeneratedTooth& cutter, const PinionMotion& motion) {
  return cut(cutter, motion, no_blank(motion.teeth));
}

// The centre distance at which cutter and gear with these shifts mesh without backlash. [T6.12]
double tight_distance(int z_0, double x_0, int z, double x) {
  const double inv_w = involute(kAlpha) + 2 * std::tan(kAlpha) * (x_0 + x) / (z_0 + z);
  return std::abs(z_0 + z) / 2.0 * std::cos(kAlpha) / std::cos(inverse_involute(inv_w));
}

// The half angle of the tooth on the base circle for the profile shift x. The flank of an internal
// gear is extended to the base circle.
double base_half_angle(int z, double x) {
  const double thickness = kPi / 2 + 2 * x * std::tan(kAlpha);
  return thickness / std::abs(z) + (z > 0 ? 1.0 : -1.0) * involute(kAlpha);
}

const Involute& flank_of(const GeneratedTooth& tooth) {
  const Arc* arc = tooth.outline.find(flank);
  EXPECT_TRUE(arc);
  return curve_as<Involute>(*arc->curve);
}

struct Set {
  int z_0;
  double x_0;
  int z;
  double x;
};

std::vector<Set> sets() {
  return {{20, 0.0, 45, 0.0},  {20, 0.2, 30, -0.5}, {31, -0.1, 17, 0.4}, {40, 0.3, 90, 1.0},
          {20, 0.0, -60, 0.0}, {20, 0.1, -60, 0.3}, {25, 0.0, -90, -0.4}};
}

TEST(CutByPinion, gear_and_cutter_mesh_without_backlash) {
  for (const auto& [z_0, x_0, z, x] : sets()) {
    const double e = tight_distance(z_0, x_0, z, x);
    const GeneratedTooth tooth = cut(cutter_of(z_0, x_0), {z_0, z, e});
    expect_joined(tooth, tooth.root_radius);
    EXPECT_NEAR(flank_of(tooth).base_radius(), std::abs(z) / 2.0 * std::cos(kAlpha), 1e-13);
    EXPECT_NEAR(flank_of(tooth).base_half_angle(), base_half_angle(z, x), 1e-14) << z_0 << ":" << z;
  }
}

TEST(CutByPinion, root_and_tip_are_the_cutters_tip_and_root) {
  for (const auto& [z_0, x_0, z, x] : sets()) {
    const double e = tight_distance(z_0, x_0, z, x), side = z > 0 ? 1.0 : -1.0;
    const GeneratedTooth cutter = cutter_of(z_0, x_0);
    const GeneratedTooth tooth = cut(cutter, {z_0, z, e});
    EXPECT_EQ(tooth.root_radius, e - side * cutter.tip_radius);
    ASSERT_EQ(tooth.outline.arcs.front().name, root_land);
    const double land = cutter.outline.arcs.back().begin;
    EXPECT_NEAR(tooth.outline.arcs.front().end, kPi / std::abs(z) - land * z_0 / std::abs(z),
                1e-15);
    if (tooth.pointed) continue;
    EXPECT_NEAR(tooth.tip_radius, e - side * cutter.root_radius, 1e-14 * e);
    EXPECT_TRUE(tooth.tip_cut_by_rack);
  }
}

TEST(CutByPinion, blank_ends_the_tooth) {
  const GeneratedTooth external = cut(cutter_of(20, 0.0), {20, 45, 32.5}, 23.4);
  EXPECT_EQ(external.tip_radius, 23.4);
  EXPECT_EQ(external.tip_form_radius, 23.4);
  EXPECT_FALSE(external.tip_cut_by_rack);
  EXPECT_EQ(names(external).front(), root_land);
  EXPECT_EQ(names(external).back(), tip_land);
  EXPECT_FALSE(external.outline.find(tip_fillet));
  const GeneratedTooth ring = cut(cutter_of(20, 0.0), {20, -60, 20.0}, 29.2);
  EXPECT_EQ(ring.tip_radius, 29.2);
  EXPECT_EQ(ring.tip_form_radius, 29.2);
  EXPECT_EQ(names(ring).front(), root_land);
  EXPECT_EQ(names(ring).back(), tip_land);
  EXPECT_FALSE(ring.outline.find(tip_fillet));
}

// Distance, mm, between the arcs `name` of the two teeth, measured along the circle of radius ρ.
double apart(const GeneratedTooth& a, const GeneratedTooth& b, ArcName name, double rho) {
  const auto angle = [&](const GeneratedTooth& tooth) {
    const Arc* arc = tooth.outline.find(name);
    EXPECT_TRUE(arc && arc->begin_point.norm() <= rho && arc->end_point.norm() >= rho);
    return arc->curve->polar_angle(arc->curve->parameter_at_radius(rho, arc->begin, arc->end));
  };
  return rho * std::abs(angle(a) - angle(b));
}

// The larger the cutter, the smaller is the difference between the gear and a gear that the rack of
// the same profile cuts. All differences decrease like 1/z_0.
TEST(CutByPinion, approaches_the_rack) {
  StraightRack rack;  // has the same tip as the cutter
  rack.root_fillet_radius = 0.3;
  for (const double x : {0.2, 0.4, -0.2}) {  // the last one is undercut
    const double blank = 18.0 / 2 + 1 + x;
    const GeneratedTooth wanted = by_rack(18, x, rack, blank);
    double form_before = 0.0, fillet_before = 0.0;
    for (const int z_0 : {300, 3000, 30000}) {
      const GeneratedTooth cutter = by_rack(z_0, 0.0, rounded(1.25, 0.3));
      const GeneratedTooth tooth = cut(cutter, {z_0, 18, tight_distance(z_0, 0.0, 18, x)}, blank);
      EXPECT_EQ(names(tooth), names(wanted));
      EXPECT_NEAR(flank_of(tooth).base_half_angle(), flank_of(wanted).base_half_angle(), 1e-10);
      const double form = std::abs(*tooth.form_radius - *wanted.form_radius);
      const double rho = 0.4 * wanted.root_radius + 0.6 * *wanted.form_radius;
      const double fillet = apart(tooth, wanted, root_fillet, rho);
      if (z_0 > 300) {
        EXPECT_NEAR(form / form_before, 0.1, 0.01) << z_0 << " " << x;
        EXPECT_NEAR(fillet / fillet_before, 0.1, 0.01) << z_0 << " " << x;
      }
      form_before = form;
      fillet_before = fillet;
    }
    EXPECT_LT(form_before, 1e-4);
    EXPECT_LT(fillet_before, 1e-4);
  }
}

// At the reference distance, rack, cutter and gear roll with a common pitch point. The cutter then
// has the same effect as its counterpart rack, for any number of cutter teeth. This requires that
// the cutter has the whole edge of its rack, beginning with the end of the flank at τ = α.
TEST(CutByPinion, at_the_reference_distance_it_is_the_rack) {
  StraightRack rack;
  rack.root_fillet_radius = 0.25;
  int compared = 0;
  for (const double x : {0.0, 0.4, 0.6, 0.8}) {
    const double blank = 18.0 / 2 + 1 + x;
    const GeneratedTooth wanted = by_rack(18, x, rack, blank);
    for (const int z_0 : {40, 90, 400, 3000}) {
      const GeneratedTooth cutter = cutter_of(z_0, -x);
      if (cutter.outline.find(tip_fillet)->begin > kAlpha + 1e-12) continue;
      ++compared;
      const GeneratedTooth tooth = cut(cutter, {z_0, 18, (z_0 + 18) / 2.0}, blank);
      ASSERT_EQ(names(tooth), names(wanted)) << z_0 << " " << x;
      EXPECT_NEAR(tooth.root_radius, wanted.root_radius, 1e-15 * z_0);
      EXPECT_NEAR(*tooth.form_radius, *wanted.form_radius, 1e-14 * z_0);
      for (const double part : {0.2, 0.6, 0.9}) {
        const double rho = (1 - part) * wanted.root_radius + part * *wanted.form_radius;
        EXPECT_LT(apart(tooth, wanted, root_fillet, rho), 1e-14 * z_0) << z_0 << " " << x;
      }
    }
  }
  EXPECT_GE(compared, 6);
}

// The space of an internal gear is the tooth of an external gear with the same number of teeth and
// the opposite shift.
TEST(CutByPinion, space_of_a_ring_is_the_tooth_of_its_mirror) {
  for (const double x : {0.0, 0.3, -0.25}) {
    const GeneratedTooth ring = cut(cutter_of(20, 0.0), {20, -60, tight_distance(20, 0.0, -60, x)});
    const GeneratedTooth gear = cut(cutter_of(20, 0.0), {20, 60, tight_distance(20, 0.0, 60, -x)});
    const Involute &a = flank_of(ring), &b = flank_of(gear);
    for (const double rho : {29.2, 29.8, 30.5}) {
      const double ring_angle = a.polar_angle(-a.roll_at(rho)),
                   angle = b.polar_angle(b.roll_at(rho));
      EXPECT_NEAR(kPi / 60 - ring_angle, angle, 1e-14);
    }
  }
}

// Doubling all lengths leaves the angles unchanged.
TEST(CutByPinion, scales) {
  for (const auto& [z_0, x_0, z, x] : sets()) {
    const double e = tight_distance(z_0, x_0, z, x);
    const GeneratedTooth tooth = cut(cutter_of(z_0, x_0), {z_0, z, e});
    auto edge = make_edge(rounded(), 2.0, 20_deg);
    ASSERT_TRUE(edge);
    auto large = cut_by_rack(edge->edge, {double(z_0), 1.0, 2 * x_0}, z_0, kInfinity);
    ASSERT_TRUE(large);
    const GeneratedTooth twice = cut(*large, {z_0, z, 2 * e});
    EXPECT_EQ(names(twice), names(tooth));
    EXPECT_NEAR(twice.root_radius, 2 * tooth.root_radius, 1e-13 * e);
    EXPECT_NEAR(twice.tip_radius, 2 * tooth.tip_radius, 1e-13 * e);
    EXPECT_NEAR(*twice.form_radius, 2 * *tooth.form_radius, 1e-12 * e);
    EXPECT_NEAR(*twice.tip_form_radius, 2 * *tooth.tip_form_radius, 1e-12 * e);
  }
}

// An undercut cutter has a convex corner between flank and fillet. This corner cuts a tip fillet on
// the gear. When a point of this fillet is cut, it coincides with the corner, so both have the same
// distance from the axis of the cutter.
TEST(CutByPinion, corner_of_an_undercut_cutter) {
  StraightRack sharp;
  sharp.root_fillet_radius = 0.0;
  sharp.addendum = 1.0;
  const GeneratedTooth cutter = by_rack(8, 0.0, sharp, 5.0);
  const Arc* cutter_flank = cutter.outline.find(flank);
  ASSERT_TRUE(cutter_flank && *cutter.form_radius > flank_of(cutter).base_radius());
  const Vec2 corner = cutter_flank->begin_point;
  const PinionMotion motion{8, 30, 19.0};
  const GeneratedTooth tooth = cut(cutter, motion);
  expect_joined(tooth, tooth.root_radius);
  int fans = 0;
  for (const Arc& arc : tooth.outline.arcs) {
    if (arc.name != tip_fillet) continue;
    const PinionEnvelope fan(motion, std::make_shared<CornerFan>(corner), Walk::forward);
    for (const double u : {0.2, 0.5, 0.8}) {
      const double nu = arc.begin + u * (arc.end - arc.begin);
      if ((arc.point(u) - fan.point(nu)).norm() > 1e-13 * 19) continue;
      ++fans;
      // The gear is turned so that the pitch point lies at the angle ϑ of the cutter. E is the
      // distance of the axes.
      const double s = corner.x() * std::sin(nu) - corner.y() * std::cos(nu);
      const double turned = 8.0 / 30 * (nu - std::asin(s / motion.cutter_pitch_radius()));
      const Vec2 p = arc.point(u);
      const double angle = std::atan2(p.y(), p.x()) - kPi / 30 + turned;
      const Vec2 fixed = p.norm() * Vec2(std::cos(angle), std::sin(angle));
      EXPECT_NEAR((Vec2(19.0, 0.0) - fixed).norm(), corner.norm(), 1e-12);
    }
  }
  EXPECT_GE(fans, 3);
  // The flank of the gear ends where the corner of the cutter begins to cut. This end is nearer to
  // the root than the point that the cutter's involute would cut at its base circle.
  EXPECT_LT(*tooth.tip_form_radius, tooth.tip_radius);
}

// A pointed cutter has a corner on its centre line. The gear has no root land, and its root is one
// trochoid.
TEST(CutByPinion, pointed_cutter) {
  StraightRack rack;
  rack.root_fillet_radius = 0.0;
  const GeneratedTooth cutter = by_rack(10, 0.9, rack, 8.0);
  ASSERT_TRUE(cutter.pointed);
  for (const int z : {30, -40}) {
    const double e = tight_distance(10, 0.9, z, 0.0);
    const GeneratedTooth tooth = cut(cutter, {10, z, e});
    expect_joined(tooth, tooth.root_radius);
    EXPECT_EQ(tooth.outline.arcs.front().name, root_fillet) << z;
    EXPECT_EQ(tooth.root_radius, e - (z > 0 ? 1 : -1) * cutter.tip_radius);
    EXPECT_NEAR(tooth.outline.arcs.front().begin_point.norm(), tooth.root_radius, 1e-12);
  }
}

TEST(CutByPinion, fillets_leave_no_lands) {
  StraightRack rack;
  rack.dedendum = 1.0;
  rack.root_fillet_radius = 0.0;
  auto edge = make_edge(rack, 1.0, 20_deg);
  ASSERT_TRUE(edge);
  const Involute involute = flank_ruler(edge->edge, {4.0, 1.0, 0.3}).flank;
  const GeneratedTooth cutter = by_rack(8, 0.3, rack, kInfinity,
                                        {CircularFillet{0.05, *root_fillet_at(involute, 8, 0.05)},
                                         CircularFillet{0.99, *tip_fillet_at(involute, 0.99)}});
  ASSERT_TRUE(cutter.root_fillet && cutter.tip_fillet && cutter.rounded_tip);
  const GeneratedTooth tooth = cut(cutter, {8, 24, 16.0});
  EXPECT_EQ(names(tooth), (std::vector{root_fillet, flank, tip_fillet}));
  EXPECT_TRUE(tooth.rounded_tip);
  EXPECT_NEAR(tooth.root_radius, 16.0 - cutter.tip_fillet->end, 1e-14 * 16);
  EXPECT_NEAR(tooth.tip_radius, 16.0 - cutter.root_fillet->end, 1e-14 * 16);
  EXPECT_EQ(tooth.outline.arcs.back().end_point, Vec2(tooth.tip_radius, 0.0));
  // A smaller blank ends the tooth with a tip land, below the end of the fillet.
  const GeneratedTooth low = cut(cutter, {8, 24, 16.0}, 12.4);
  EXPECT_EQ(names(low).back(), tip_land);
  EXPECT_EQ(low.tip_radius, 12.4);
}

TEST(CutByPinion, cutter_past_the_axis_leaves_no_gear) {
  const GeneratedTooth cutter = cutter_of(40, 0.0);
  const GeneratedTooth gone = cut(cutter, {40, 2, 20.9});
  EXPECT_TRUE(gone.through_axis);
  EXPECT_TRUE(gone.outline.arcs.empty());
  EXPECT_LT(gone.root_radius, 0.0);
}

TEST(CutByPinion, a_deep_cutter_severs_the_tooth) {
  const GeneratedTooth cutter = cutter_of(40, 0.0);
  const GeneratedTooth cut_off = cut(cutter, {40, 5, 21.4});
  EXPECT_TRUE(cut_off.severed);
  EXPECT_LE(cut_off.neck_half_angle->rad(), 0.0);
  EXPECT_TRUE(cut_off.outline.arcs.empty());
}

TEST(CutByPinion, refusals) {
  const GeneratedTooth cutter = cutter_of(20, 0.0);
  const double base = 10 * std::cos(kAlpha) * (1 + 45.0 / 20);  // r_p = r_b
  const auto inside = cut_by_pinion(cutter, {20, 45, base * (1 - 1e-9)}, kInfinity);
  ASSERT_FALSE(inside);
  EXPECT_EQ(inside.error().field, "cut_by");
  EXPECT_NE(inside.error().message().find("increase the distance"), std::string::npos);
  EXPECT_TRUE(cut_by_pinion(cutter, {20, 45, base * (1 + 1e-3)}, kInfinity));
  const double root = 32.5 - cutter.tip_radius;
  const auto small = cut_by_pinion(cutter, {20, 45, 32.5}, root * (1 - 1e-12));
  ASSERT_FALSE(small);
  EXPECT_EQ(small.error().field, "tip_diameter");
  EXPECT_TRUE(cut_by_pinion(cutter, {20, 45, 32.5}, root + 0.1));
  const auto wide = cut_by_pinion(cutter, {20, -60, 20.0}, 20.0 + cutter.tip_radius + 1e-9);
  ASSERT_FALSE(wide);
  EXPECT_EQ(wide.error().field, "tip_diameter");
  EXPECT_NE(wide.error().message().find("less"), std::string::npos);
}

}  // namespace
}  // namespace gearwright
