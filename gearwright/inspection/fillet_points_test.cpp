// Points of the root fillet are compared with the tip rounding of the cutter, which is rolled with
// more digits.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/inspection/nominal_points.hpp"

namespace gearwright {
namespace {

using Real = long double;
using testing::kLongPi;

struct Place {
  Real x, y;    // mm
  Real nx, ny;  // unit, out of the material
};

// The rack's tip rounding is a circle in the normal section and an ellipse in the transverse
// section. The point at the angle θ of the circle touches the gear if its normal passes through the
// pitch point [law of gearing]. The rack has then moved by t from the position in which its tooth
// is in the space at π/z.
Place rolled(const CylindricalSpec& s, Real theta) {
  const StraightRack& rack = s.straight_rack();
  const Real m = s.normal_module, beta = s.helix_angle.rad(), alpha = s.normal_pressure_angle.rad();
  const Real c = std::cos(beta), r = s.teeth * m / c / 2;
  const Real rho = rack.root_fillet_radius * m;
  const Real depth = rack.dedendum * m - rho;  // depth of the centre below the datum line
  const Real off = kLongPi * m / 4 - depth * std::tan(alpha) - rho / std::cos(alpha);
  // Position below the pitch line, and distance from the middle of the cutter tooth on the side of
  // this flank.
  const Real x_E = s.profile_shift + Real(s.thickness_allowance) / (2 * m * std::tan(alpha));
  const Real d = depth - x_E * m + rho * std::sin(theta);
  const Real y = -(off + rho * std::cos(theta)) / c;
  // The normal of the curve (−d, y), which points out of the cutter.
  Real nx = -std::sin(theta) / c, ny = -std::cos(theta);
  const Real length = std::hypot(nx, ny);
  nx /= length;
  ny /= length;
  const Real t = -d * ny / nx - y;  // for this t, the normal passes through the pitch point (r, 0)
  const Real turn = kLongPi / s.teeth - t / r;
  const Real px = r - d, py = y + t;
  const Real co = std::cos(turn), si = std::sin(turn);
  // The direction out of the cutter is the direction into the gear.
  return {co * px - si * py, si * px + co * py, -(co * nx - si * ny), -(si * nx + co * ny)};
}

// The θ at which the rolled position is nearest to the point (x, y). θ is varied from the tangent
// of the flank to the tangent of the land.
Real nearest(const CylindricalSpec& s, Real x, Real y) {
  const auto far = [&](Real theta) {
    const Place p = rolled(s, theta);
    return std::hypot(p.x - x, p.y - y);
  };
  Real lo = s.normal_pressure_angle.rad(), hi = kLongPi / 2 - 1e-12L;
  constexpr int kSteps = 400;
  int best = 0;
  for (int i = 0; i <= kSteps; ++i)
    if (far(lo + (hi - lo) * i / kSteps) < far(lo + (hi - lo) * best / kSteps)) best = i;
  const Real step = (hi - lo) / kSteps, at = lo + step * best;
  lo = std::max(lo, at - step);
  hi = std::min(hi, at + step);
  for (int i = 0; i < 200; ++i) {
    const Real a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
    (far(a) < far(b) ? hi : lo) = far(a) < far(b) ? b : a;
  }
  return (lo + hi) / 2;
}

CylindricalSpec module_3_spec(int teeth, double beta_deg, double x, double allowance = 0.0) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = teeth, .module = 3, .beta_deg = beta_deg, .x = x, .face_width = 30});
  s.thickness_allowance = allowance;
  return s;
}

TEST(FilletPoints, lie_where_the_cutters_rounding_leaves_them) {
  for (const auto& s : {module_3_spec(17, 0, 0.1), module_3_spec(40, 22, -0.2, -0.1),
                        module_3_spec(9, 0, 0.0), module_3_spec(23, -31, 0.5, -0.04)}) {
    const Gear gear = testing::taken(make_gear(s));
    const auto ranges = evaluation_ranges(gear);
    ASSERT_TRUE(ranges);
    for (const FlankSide side : {FlankSide::right, FlankSide::left}) {
      const auto points = fillet_points(gear, side, *ranges, {9, 3});
      ASSERT_EQ(points.size(), 27u);
      const double hand = side == FlankSide::left ? 1 : -1;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const NominalPoint& p = points[i];
        EXPECT_NEAR(p.diameter, 2 * p.point.head<2>().norm(), 1e-12);
        // Rotates the point back into the section in the middle of the face and to the upper side
        // of the tooth.
        const Real turn = -Real(gear.twist()) * p.height;
        const Real x = std::cos(turn) * p.point.x() - std::sin(turn) * p.point.y();
        const Real y = hand * (std::sin(turn) * p.point.x() + std::cos(turn) * p.point.y());
        const Place oracle = rolled(s, nearest(s, x, y));
        EXPECT_LT(std::hypot(oracle.x - x, oracle.y - y), 1e-9) << i;
        const Real nx = std::cos(turn) * p.normal.x() - std::sin(turn) * p.normal.y();
        const Real ny = hand * (std::sin(turn) * p.normal.x() + std::cos(turn) * p.normal.y());
        const Real flat = std::hypot(nx, ny);
        EXPECT_NEAR(p.normal.norm(), 1.0, 1e-14);
        EXPECT_LT(std::hypot(nx / flat - oracle.nx, ny / flat - oracle.ny), 1e-8) << i;
        // The normal is perpendicular to the direction of the screw along the flank.
        const Vec3 screw = gear.twist() * Vec3::UnitZ().cross(p.point) + Vec3::UnitZ();
        EXPECT_NEAR(p.normal.dot(screw), 0.0, 1e-13);
      }
      // The points reach from the land to d_Ff.
      EXPECT_NEAR(points.front().diameter, std::abs(gear.root_diameter), 1e-9);
      EXPECT_NEAR(points[8].diameter, 2 * *gear.root_form_radius(), 1e-9);
    }
  }
}

// Without undercut, flank and fillet have a common tangent plane where they meet.
TEST(FilletPoints, go_on_where_the_flank_ends_of_a_ring_too) {
  const auto ring = cut_by_default(testing::taken(make_gear(module_3_spec(-60, 12, 0.1))));
  ASSERT_TRUE(ring);
  for (const Gear& gear : {*ring, testing::taken(make_gear(module_3_spec(31, -20, 0.2)))}) {
    const auto ranges = evaluation_ranges(gear);
    ASSERT_TRUE(ranges);
    const double r0 = gear.base_radius();
    const RemovalField none = testing::taken(make_removal_field(
        {},
        {r0, ranges->root_form.diameter / 2, ranges->tip_form.diameter / 2, gear.spec.face_width}));
    for (const FlankSide side : {FlankSide::right, FlankSide::left}) {
      const auto points = fillet_points(gear, side, *ranges, {7, 2});
      ASSERT_EQ(points.size(), 14u);
      for (const std::size_t row : {0u, 1u}) {
        const NominalPoint& last = points[7 * row + 6];
        const NominalPoint flank =
            nominal_point(gear, none, side, ranges->root_form.angle, last.height);
        EXPECT_LT((last.point - flank.point).norm(), 1e-9);
        EXPECT_LT((last.normal - flank.normal).norm(), 1e-6);
        // On the root circle, the normal points towards the axis of a ring and away from the axis
        // of a gear.
        const NominalPoint& first = points[7 * row];
        const double outward = first.normal.dot(first.point) / first.point.head<2>().norm();
        EXPECT_GT(gear.internal() ? -outward : outward, 0.9);
      }
    }
  }
}

TEST(FilletPoints, are_evenly_spaced) {
  const Gear bare =
      testing::taken(make_gear(module_3_spec(-60, 12, 0.1)));  // no cutter, no outline
  const Gear gear = testing::taken(make_gear(module_3_spec(30, 0, 0.0)));
  const auto ranges = evaluation_ranges(gear);
  ASSERT_TRUE(ranges);
  EXPECT_TRUE(fillet_points(bare, FlankSide::left, *ranges, {9, 2}).empty());
  const auto points = fillet_points(gear, FlankSide::left, *ranges, {41, 2});
  const double first = (points[1].point - points[0].point).norm();
  for (std::size_t i = 1; i < 41; ++i) {
    EXPECT_NEAR((points[i].point - points[i - 1].point).norm(), first, 2e-3 * first);
    EXPECT_GT(points[i].diameter, points[i - 1].diameter);
  }
}

}  // namespace
}  // namespace gearwright
