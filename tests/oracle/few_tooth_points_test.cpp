// Tests that points with normals of gears with few teeth, computed independently with 40 digits,
// lie on the outlines of the engine: rack-cut gears with 1 to 40 teeth, pinions with circular
// fillets, and gears cut by these pinions.
//
//   foot   the point on an arc from which the vector to the given point is perpendicular to the
//          tangent. It is well defined even if the arc is a circle about the axis, which is not
//          true of the point with equal radius.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "tests/oracle/few_tooth_cases.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/oracle/pinion_cutter_cases.hpp"
#include "tests/oracle/plane_turn.hpp"

namespace gearwright::oracle {
namespace {

using testing::made;

constexpr double kOnOutline = 1e-10;  // mm
constexpr double kSameNormal = 1e-9;  // rad

Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// u of the foot of `p` on the arc, or the nearer end.
double foot(const Arc& arc, const Vec2& p) {
  const auto ahead = [&](double u) {
    const CurvePoint c = arc.at(u);
    return (c.point - p).dot(unit(c.tangent_angle)) > 0.0;
  };
  double lo = 0.0, hi = 1.0;
  if (ahead(lo)) return lo;
  if (!ahead(hi)) return hi;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (lo + hi);
    (ahead(middle) ? hi : lo) = middle;
  }
  return 0.5 * (lo + hi);
}

struct Match {
  double distance = std::numeric_limits<double>::infinity();  ///< mm
  double turn = std::numeric_limits<double>::infinity();      ///< rad, between the normals
};

/// The nearest point of the outline. If several points are equally near, the one with the best
/// normal is used, because at a corner the source gives only one of the two normals.
Match match(const Outline& outline, const Vec2& p, const Vec2& normal) {
  Match best;
  for (const Arc& arc : outline.arcs) {
    const CurvePoint c = arc.at(foot(arc, p));
    const double distance = (c.point - p).norm();
    // Followed from root to tip on the side y > 0, the outline has the material on its right.
    const Vec2 out = unit(c.tangent_angle + kPi / 2);
    const double turn =
        std::abs(std::atan2(out.x() * normal.y() - out.y() * normal.x(), out.dot(normal)));
    const bool same = distance <= kOnOutline && best.distance <= kOnOutline;
    if (same ? turn < best.turn : distance < best.distance) best = {distance, turn};
  }
  return best;
}

CylindricalSpec spec_of(const RackNumbers& n) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = n.teeth, .module = n.normal_module, .x = n.profile_shift, .face_width = 20.0});
  s.normal_pressure_angle = Angle::radians(n.normal_pressure_angle);
  s.helix_angle = Angle::radians(n.helix_angle);
  s.straight_rack().addendum =
      1.5;  // a blank so large that the rack forms the end of every tooth that is not pointed
  s.straight_rack().dedendum = n.dedendum;
  s.straight_rack().root_fillet_radius = n.root_fillet_radius;
  s.straight_rack().tip_fillet_radius = n.tip_fillet_radius;
  s.straight_rack().tool_addendum = n.tool_addendum;
  return s;
}

CylindricalSpec spec_of(const FilletedPinion& n) {
  CylindricalSpec s = testing::plain_spec({.teeth = n.teeth,
                                           .module = n.normal_module,
                                           .beta_deg = n.helix_angle_deg,
                                           .x = n.profile_shift,
                                           .face_width = 20.0});
  s.normal_pressure_angle = Angle::degrees(n.normal_pressure_angle_deg);
  s.straight_rack().dedendum = 1.0;
  s.straight_rack().root_fillet_radius = 0.0;
  const double l_F = *made(s).involute()->undercut_l;
  s.root_fillet = RootFilletSpec{n.l_C - std::max(l_F, 0.0)};
  s.tip_fillet = TipFilletSpec{TipFilletSpec::By::l, n.l_J};
  return s;
}

TEST(FewToothPoints, of_rack_cut_gears) {
  int points = 0;
  for (const FewToothCase& c : few_tooth_cases()) {
    const Gear gear = made(spec_of(c.rack));
    ASSERT_TRUE(gear.exists()) << c.name;
    for (const FewToothPoint& p : c.points) {
      const Match m = match(gear.tooth->outline, {p.x, p.y}, {p.n_x, p.n_y});
      EXPECT_LE(m.distance, kOnOutline) << c.name << " " << p.x << " " << p.y;
      EXPECT_LE(m.turn, kSameNormal) << c.name << " " << p.x << " " << p.y;
      ++points;
    }
  }
  EXPECT_EQ(points, 51);
}

// A point next to the outline, and a normal that differs from that of the outline, must be
// detected.
TEST(FewToothPoints, a_wrong_point_would_be_seen) {
  for (const FewToothCase& c : few_tooth_cases()) {
    const Gear gear = made(spec_of(c.rack));
    for (const FewToothPoint& p : c.points) {
      const Vec2 n = Vec2(p.n_x, p.n_y).normalized();
      for (const double step : {-1e-6, 1e-6}) {
        const Vec2 beside = Vec2(p.x, p.y) + step * n;
        // Next to a corner, the other arc may be nearer, but only by an amount that depends on the
        // sharpness of the corner.
        EXPECT_GT(match(gear.tooth->outline, beside, n).distance, 1e-7) << c.name;
      }
      const Vec2 tilted = turned(n, 1e-6);
      EXPECT_GT(match(gear.tooth->outline, {p.x, p.y}, tilted).turn, 1e-7) << c.name;
    }
  }
}

TEST(FewToothPoints, of_pinions_with_circular_fillets) {
  for (const PinionCutterCase& c : pinion_cutter_cases()) {
    const Gear pinion = made(spec_of(c.pinion));
    ASSERT_TRUE(pinion.tooth->root_fillet && pinion.tooth->tip_fillet) << c.name;
    EXPECT_NEAR(pinion.tooth->root_fillet->radius, c.root_fillet_radius, 1e-12) << c.name;
    EXPECT_NEAR(pinion.tooth->tip_fillet->radius, c.tip_fillet_radius, 1e-12) << c.name;
    EXPECT_NEAR(pinion.tooth->root_radius, c.root_radius, 1e-12) << c.name;
    EXPECT_NEAR(pinion.tooth->tip_radius, c.tip_radius, 1e-12) << c.name;
    const FilletedHalfTooth half = filleted_half_tooth(c.pinion);
    const auto& arcs = pinion.tooth->outline.arcs;
    ASSERT_EQ(arcs.size(), half.curves.size()) << c.name;
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      for (int i = 0; i <= 8; ++i) {  // both run by the same parameter, from root to tip
        const double u = i / 8.0;
        EXPECT_LE((arcs[k].point(u) - half.curves[k](u)).norm(), 1e-12) << c.name << " " << k;
      }
    }
  }
}

TEST(FewToothPoints, of_gears_that_such_pinions_cut) {
  int points = 0;
  for (const PinionCutterCase& c : pinion_cutter_cases()) {
    const int z = c.pinion.gear_teeth;
    const auto gear = make_pinion_cut_gear(made(spec_of(c.pinion)),
                                           {z, c.pinion.center_distance, 20.0, std::nullopt});
    ASSERT_TRUE(gear) << gear.error().message();
    const double turn = kPi / z - kPi;  // the source has space 0 on the negative x axis
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const CutGearPoint& p = c.points[i];
      const Match m =
          match(gear->tooth->outline, turned({p.x, p.y}, turn), turned({p.n_x, p.n_y}, turn));
      if (c.name[2] == '7' && i == 0) {  // the loop of this set that the root arc removes
        EXPECT_NEAR(m.distance, 4.6e-3, 1e-4) << c.name;
        continue;
      }
      EXPECT_LE(m.distance, kOnOutline) << c.name << " " << p.x << " " << p.y;
      EXPECT_LE(m.turn, kSameNormal) << c.name << " " << p.x << " " << p.y;
      ++points;
    }
  }
  EXPECT_EQ(points, 50);
}

}  // namespace
}  // namespace gearwright::oracle
