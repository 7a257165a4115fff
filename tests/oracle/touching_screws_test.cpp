// Compares the touching screws with the closed formulas of conjugate action: no backlash at the
// correct distance, the ratio z_1/z_2 at every rotation, and contact exactly on the lines from A to
// B and from A' to B'.
//
//   T   angle by which gear 2 is ahead of the ratio: φ_2 − (z_1/z_2) φ_1
//   ε   contact ratio: rotation over which one tooth touches, in pitches
#include "tests/oracle/touching_screws.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "tests/oracle/conjugate_pairs.hpp"
#include "tests/oracle/numbers.hpp"

namespace gearwright::oracle {
namespace {

using Eigen::Vector3d;

constexpr std::array kSides = {Side::leading, Side::trailing};

/// Rounding errors of 1e-14 mm in both surfaces move the contact point in the direction of the
/// tangent plane in which the gap has the lowest curvature. This curvature is about sin² Σ divided
/// by a radius. Gears on parallel axes touch along a line.
double point_tolerance(const ScrewPair& p) {
  const double s = p.shaft_angle == 0.0 ? 1.0 : std::sin(p.shaft_angle);
  return 1e-12 / (s * s);
}

/// The end A or B of the line of contact for the flanks of a side. On parallel axes, every section
/// has its own line, so the lines are viewed along the axis.
Vector3d end_of_line(const ScrewPair& p, const ConjugateMesh& mesh, Side side,
                     const Vector3d& end) {
  const bool leading = side == Side::leading;
  Vector3d e = housing(mesh, leading ? end : Vector3d(-end.x(), end.y(), -end.z()));
  if (p.shaft_angle == 0.0) e.z() = 0;
  return e;
}

Vector3d contact_point(const ScrewPair& p, const Touch& t) {
  return p.shaft_angle == 0.0 ? Vector3d(t.point.x(), t.point.y(), 0) : t.point;
}

class ConjugateScrews : public ::testing::TestWithParam<ConjugatePair> {};
INSTANTIATE_TEST_SUITE_P(Pairs, ConjugateScrews, ::testing::ValuesIn(conjugate_pairs()),
                         [](const auto& info) { return std::string(info.param.name); });

// At this Σ, the formulas give no backlash. Both flanks touch on their lines at the rotation given
// by the ratio, and the search agrees with the tangency.
TEST_P(ConjugateScrews, no_backlash_one_ratio_one_line) {
  for (const ConjugateMesh& mesh : GetParam().meshes) {
    const ScrewPair p = mounted(GetParam(), mesh);
    SCOPED_TRACE(mesh.center_distance);
    for (const double part : {-0.37, -0.1, 0.0, 0.25, 0.5, 0.83, 7.4}) {
      const double rotation_1 = part * pitch_1(p);
      for (const Side side : kSides) {
        SCOPED_TRACE(::testing::Message() << part << " pitches, side " << static_cast<int>(side));
        const auto t = touch(p, rotation_1, side);
        ASSERT_TRUE(t.has_value());
        EXPECT_EQ(t->where, Where::flanks);
        EXPECT_GT(t->margin, 0.0);
        EXPECT_NEAR(t->rotation_2, ratio(p) * rotation_1, kRotation);
        EXPECT_NEAR(t->searched_2, t->rotation_2, kRotation);
        EXPECT_LT(t->residual, 1e-14 * std::abs(t->point.norm() + p.center_distance));

        const Vector3d a = end_of_line(p, mesh, side, mesh.a),
                       b = end_of_line(p, mesh, side, mesh.b);
        const Vector3d along = (b - a).normalized(), from_a = contact_point(p, *t) - a;
        const double s = along.dot(from_a);
        EXPECT_NEAR((from_a - s * along).norm(), 0.0, point_tolerance(p));
        EXPECT_GT(s, -point_tolerance(p));
        EXPECT_LT(s, (b - a).norm() + point_tolerance(p));
      }
      const auto free = play(p, rotation_1);
      ASSERT_TRUE(free.has_value());
      EXPECT_NEAR(*free * p.second.base_radius, 0.0, 2 * kRotation * p.second.base_radius);
    }
  }
}

// One tooth is followed in both directions until an edge takes over: the leading flanks from A, at
// the tip of gear 2, to B, at the tip of gear 1; the trailing flanks from B' to A'. The rotation
// between these points is ε pitches. For parallel helical gears, the section z = 0 is used.
TEST_P(ConjugateScrews, path_of_one_tooth_ends_at_the_tips) {
  for (const ConjugateMesh& mesh : GetParam().meshes) {
    ScrewPair p = mounted(GetParam(), mesh);
    if (p.shaft_angle == 0.0) p.half_face = 0.0;
    SCOPED_TRACE(mesh.center_distance);
    for (const Side side : kSides) {
      const auto middle = touch(p, 0.1 * pitch_1(p), side);
      ASSERT_TRUE(middle.has_value());
      const auto at = [&](double rotation_1) {
        return touch_of_tooth(p, rotation_1, side, middle->tooth);
      };
      std::array<double, 2> ends{};
      for (const int way : {-1, 1}) {
        double in = 0.1 * pitch_1(p), out = in;
        for (auto t = middle; t && t->where == Where::flanks; t = at(out)) {
          in = out, out += way * 0.21 * pitch_1(p);
        }
        for (int i = 0; i < 40; ++i) {  // to 1e-13 of a pitch
          const double half = 0.5 * (in + out);
          const auto t = at(half);
          (t && t->where == Where::flanks ? in : out) = half;
        }
        const bool at_b = (way > 0) == (side == Side::leading);
        const auto last = at(in), edge = at(out);
        ASSERT_TRUE(last.has_value());
        ASSERT_TRUE(edge.has_value());
        EXPECT_EQ(edge->where, at_b ? Where::tip_1 : Where::tip_2);
        const Vector3d end = end_of_line(p, mesh, side, at_b ? mesh.b : mesh.a);
        // The bisection contains the rounding errors of the point and of the strings of both gears.
        EXPECT_NEAR((contact_point(p, *last) - end).norm(), 0.0, 10 * point_tolerance(p));
        ends[way > 0] = in;
      }
      // On the line of contact, the flank of gear 1 advances by r_b1 cos β_b1 per radian. On
      // parallel axes it advances by r_b1 within the section.
      const double arm =
          p.first.base_radius * (p.shaft_angle == 0.0 ? 1.0 : std::cos(p.first.base_helix));
      const double length =
          (end_of_line(p, mesh, side, mesh.b) - end_of_line(p, mesh, side, mesh.a)).norm();
      EXPECT_NEAR((ends[1] - ends[0]) * arm, length, 20 * point_tolerance(p));
    }
  }
}

// At other centre distances, the backlash equals the value of the formulas, which is negative if
// the teeth are too thick. It is equal for both flanks, because a half turn about the centre line
// exchanges them.
TEST_P(ConjugateScrews, play_at_other_centre_distances) {
  for (const ConjugatePlay& wanted : GetParam().plays) {
    ConjugateMesh mesh{};
    mesh.shaft_angle_deg = wanted.shaft_angle_deg, mesh.center_distance = wanted.center_distance;
    const ScrewPair p = mounted(GetParam(), mesh);
    SCOPED_TRACE(mesh.center_distance);
    for (const double part : {0.0, 0.43}) {
      const double rotation_1 = part * pitch_1(p);
      const auto behind = touch(p, rotation_1, Side::leading);
      ASSERT_TRUE(behind.has_value());
      EXPECT_EQ(behind->where, Where::flanks);
      const double half = wanted.turn_2_deg * kDegree / 2;
      EXPECT_NEAR(behind->rotation_2, ratio(p) * rotation_1 - half, kRotation);
      EXPECT_NEAR(*play(p, rotation_1), 2 * half, 2 * kRotation);
    }
  }
}

}  // namespace
}  // namespace gearwright::oracle
