// Tests rounded tip corners, and internal gears cut by a cutter with such corners. The root of
// these gears is compared with the region that the cutter sweeps, computed by brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/named_limit.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/curve/basic_curves.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

namespace gearwright {
namespace {

using testing::made;

CylindricalSpec cutter_spec(int teeth, double module, double radius, double x = 0.0) {
  CylindricalSpec s =
      testing::plain_spec({.teeth = teeth, .module = module, .x = x, .face_width = 20.0});
  s.straight_rack().addendum = 1.25;
  if (radius > 0.0) s.tip_fillet = TipFilletSpec{TipFilletSpec::By::corner, radius};
  return s;
}

// (1) the corner ends on the tip circle, tangent to it   (2) it begins on the flank, tangent to it
// (3) its curvature is 1/radius                          (4) the land is the rest of the tip
TEST(TipCorner, touches_flank_and_tip_circle) {
  for (const int teeth : {20, 25, 80}) {
    for (const double x : {-0.1, 0.0, 0.2}) {
      for (const double radius : {0.05, 0.2, 0.5}) {
        const Gear gear = made(cutter_spec(teeth, 2.5, radius, x));
        const auto& arcs = gear.tooth->outline.arcs;
        ASSERT_GE(arcs.size(), 3u);
        const Arc& land = arcs[arcs.size() - 1];
        const Arc& corner = arcs[arcs.size() - 2];
        const Arc& flank = arcs[arcs.size() - 3];
        ASSERT_EQ(land.name, ArcName::tip_land);
        ASSERT_EQ(corner.name, ArcName::tip_fillet);
        ASSERT_EQ(flank.name, ArcName::flank);
        const double r_a = gear.tip_diameter / 2;
        EXPECT_NEAR(corner.end_point.norm(), r_a, 1e-13 * r_a);  // (1)
        const CurvePoint end = corner.at(1.0);
        EXPECT_NEAR(std::cos(end.tangent_angle - std::atan2(end.point.y(), end.point.x())), 0.0,
                    1e-12);
        EXPECT_LT((corner.begin_point - flank.end_point).norm(), 1e-13 * r_a);  // (2)
        EXPECT_LT((corner.at(0.0).point - flank.at(1.0).point).norm(), 1e-12 * r_a);
        EXPECT_NEAR(std::sin(corner.at(0.0).tangent_angle - flank.at(1.0).tangent_angle), 0.0,
                    1e-12);
        EXPECT_NEAR(std::abs(end.curvature), 1 / radius, 1e-12 / radius);    // (3)
        EXPECT_NEAR(land.begin, gear.tooth->tip_fillet->land.rad(), 1e-14);  // (4)
        EXPECT_GT(land.begin, 0.0);
        EXPECT_FALSE(gear.tooth->rounded_tip || gear.tooth->pointed || gear.tooth->tip_cut_by_rack);
        EXPECT_LT(gear.tip_form_radius(), r_a);
        EXPECT_DOUBLE_EQ(gear.tooth->tip_fillet->radius, radius);
      }
    }
  }
}

// The greatest radius leaves no land. It is the circular tip fillet with its centre on the centre
// line of the tooth.
TEST(TipCorner, is_refused_where_it_does_not_fit) {
  const CylindricalSpec big = cutter_spec(25, 2.5, 3.0);
  const auto gear = make_gear(big);
  ASSERT_FALSE(gear);
  EXPECT_EQ(gear.error().field, "tip_fillet.corner_radius");
  const double greatest = number_after(gear.error().rule, "less than ");
  const Gear nearly = made(cutter_spec(25, 2.5, greatest * 0.99999));
  EXPECT_LT(nearly.tooth->tip_fillet->land.rad(), 1e-5);
  CylindricalSpec pointed = cutter_spec(12, 2.5, 0.2, 1.2);
  EXPECT_EQ(make_gear(pointed).error().field, "tip_fillet.corner_radius");
}

// Half of the outline of a cutter's tooth, computed without the library: tip circle, arc and
// involute.
std::vector<Vec2> cutter_points(int teeth, double m, double x, double r_a, double rho) {
  const double alpha = 20.0 / 180 * kPi, r = teeth * m / 2, r_b = r * std::cos(alpha);
  const double psi_b = (kPi / 2 + 2 * x * std::tan(alpha)) / teeth + std::tan(alpha) - alpha;
  const auto involute = [&](double xi) {
    const double t = psi_b - xi;
    return Vec2(r_b * (std::cos(t) - xi * std::sin(t)), r_b * (std::sin(t) + xi * std::cos(t)));
  };
  // A circle of the radius ρ touches the flank from inside at the roll angle ξ. Bisection finds the
  // ξ at which the point of the circle that is farthest from the axis lies on the tip circle.
  const auto center = [&](double xi) {
    const double t = psi_b - xi;  // the normal points to the base circle's tangent point
    const Vec2 foot(r_b * std::cos(t), r_b * std::sin(t));
    return Vec2(involute(xi) + (foot - involute(xi)).normalized() * rho);
  };
  double lo = std::tan(alpha) * 0.5, hi = std::sqrt(r_a * r_a / (r_b * r_b) - 1);
  for (int i = 0; i < 100; ++i) {
    const double middle = (lo + hi) / 2;
    (center(middle).norm() + rho < r_a ? lo : hi) = middle;
  }
  const Vec2 c = center(lo);
  const double gamma = std::atan2(c.y(), c.x());
  const double start = std::atan2((involute(lo) - c).y(), (involute(lo) - c).x());
  std::vector<Vec2> points;
  constexpr int kMany = 600;
  for (int i = 0; i <= kMany / 4; ++i) {
    const double t = gamma * i / (kMany / 4.0);
    points.emplace_back(r_a * std::cos(t), r_a * std::sin(t));
  }
  for (int i = 0; i <= kMany; ++i) {
    const double t = gamma + (start - gamma) * i / kMany;
    points.push_back(c + rho * Vec2(std::cos(t), std::sin(t)));
  }
  for (int i = 0; i <= kMany; ++i) {
    const double xi = lo + (0.2 * lo - lo) * i / kMany;
    points.push_back(involute(xi));
  }
  return points;
}

// The greatest polar angle that a tooth of the cutter reaches on the circle of the radius ρ about
// the axis of the ring while the tooth passes through the space on the x axis.
double swept_angle(const std::vector<Vec2>& cutter, double distance, double ratio, double rho) {
  double best = -1e300;
  // Tests are not optimised, so the loop works on plain doubles and computes angles only where the
  // outline crosses the circle.
  std::vector<double> coordinates;
  for (const Vec2& p : cutter) coordinates.insert(coordinates.end(), {p.x(), p.y()});
  const double* const first = coordinates.data();
  const double* const end = first + coordinates.size();
  const auto reach =
      [&](double turned) {  // rotation of the ring; the cutter rotates `ratio` times as far
        const double c = std::cos(turned * ratio), s = std::sin(turned * ratio);
        double angle = -1e300, x_before = 0.0, y_before = 0.0, before = 0.0;
        for (const double* q = first; q != end; q += 2) {
          const double x = distance + c * q[0] - s * q[1], y = s * q[0] + c * q[1];
          const double r = std::sqrt(x * x + y * y);
          if (q != first && (r - rho) * (before - rho) <= 0.0 && r != before) {
            const double from = std::atan2(y_before, x_before), to = std::atan2(y, x);
            angle = std::max(angle, from + (to - from) * (rho - before) / (r - before) - turned);
          }
          x_before = x, y_before = y, before = r;
        }
        return angle;
      };
  constexpr int kSteps = 1500;
  double at = 0.0;
  const double far = 0.25;  // rad of the ring
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double turned = far * i / kSteps;
    if (const double a = reach(turned); a > best) best = a, at = turned;
  }
  for (double step = far / kSteps; step > 1e-9; step /= 2)
    for (const double turned : {at - step, at + step})
      if (const double a = reach(turned); a > best) best = a, at = turned;
  return best;
}

TEST(TipCorner, cuts_the_root_of_a_ring_as_a_swept_outline_does) {
  struct Case {
    int z_0, z;
    double x_0, x, rho;  // ρ in modules
  };
  for (const Case& k : {Case{25, -66, 0.0, -0.35, 0.2}, Case{30, -93, 0.0, 0.1171, 0.3},
                        Case{18, -50, 0.3, 0.2, 0.1}, Case{31, -62, -0.1, 0.0, 0.35}}) {
    constexpr double m = 2.0;
    const Gear cutter = made(cutter_spec(k.z_0, m, k.rho * m, k.x_0));
    const double e = testing::taken(generating_distance(cutter, k.z, k.x));
    const double tip = 2 * (-k.z * m / 2 - 0.8 * m);
    const Gear ring = testing::taken(make_pinion_cut_gear(cutter, {k.z, e, 20.0, tip}));
    EXPECT_DOUBLE_EQ(ring.cut_by->tip_rounding, k.rho * m);
    const auto points = cutter_points(k.z_0, m, k.x_0, cutter.tip_diameter / 2, k.rho * m);
    int compared = 0;
    for (const Arc& arc : ring.tooth->outline.arcs) {
      if (arc.name != ArcName::root_fillet && arc.name != ArcName::flank) continue;
      for (int i = 0; i <= 12; ++i) {
        const Vec2 p = arc.at(0.02 + 0.96 * i / 12).point;
        const double theta = std::atan2(p.y(), p.x());
        const double swept = swept_angle(points, e, -static_cast<double>(k.z) / k.z_0, p.norm());
        EXPECT_NEAR((kPi / -k.z - swept - theta) * p.norm(), 0.0, 3e-5 * m)
            << k.z << " " << static_cast<int>(arc.name) << " at " << p.norm();
        ++compared;
      }
    }
    EXPECT_GE(compared, 26);
    // The flank of the ring begins where the rounding of the cutter begins. If the corners of the
    // cutter are sharp, the flank begins nearer to the root.
    const Gear sharp = made(cutter_spec(k.z_0, m, 0.0, k.x_0));
    const Gear deeper = testing::taken(make_pinion_cut_gear(sharp, {k.z, e, 20.0, tip}));
    EXPECT_GT(*deeper.tooth->form_radius, *ring.tooth->form_radius);
    EXPECT_EQ(deeper.cut_by->tip_rounding, 0.0);
  }
}

}  // namespace
}  // namespace gearwright
