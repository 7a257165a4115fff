// Tests the touching screws against themselves: strings, exchanged gears, laws over seeded pairs,
// and the parts that touch when the flanks do not.
//
//   T   angle by which gear 2 is ahead of the ratio: φ_2 − (z_1/z_2) φ_1
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/oracle/conjugate_pairs.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/oracle/touching_screws.hpp"

namespace gearwright::oracle {
namespace {

using Eigen::Vector3d;

// The flank is the end of the string. The foot of the string lies on the base circle, where the
// string is tangent. The string is as long as the arc from which it was unwound. The tooth on the
// base circle has the thickness s_bt and turns like a screw. The normal is perpendicular to the
// surface.
TEST(TouchingScrews, flank_is_an_unwound_string) {
  for (const double beta_b : {0.5, 0.0, -0.8}) {
    const Screw g{11, 20.0, 5.0, beta_b, 26.0};
    for (const int sigma : {-1, 1}) {
      for (const double z : {-3.0, 0.0, 8.0}) {
        const Vector3d start = flank_point(g, sigma, 0.0, z);
        const double azimuth = sigma * 2.5 / 20.0 + z * std::tan(beta_b) / 20.0;
        EXPECT_NEAR(start.x(), 20 * std::cos(azimuth), 1e-13);
        EXPECT_NEAR(start.y(), 20 * std::sin(azimuth), 1e-13);
        EXPECT_EQ(start.z(), z);
        for (const double u : {0.1, 0.4, 0.8}) {
          const Vector3d point = flank_point(g, sigma, u, z);
          const double foot = azimuth - sigma * u;
          const Vector3d string = point - Vector3d(20 * std::cos(foot), 20 * std::sin(foot), z);
          EXPECT_NEAR(string.norm(), 20 * u, 1e-13);
          EXPECT_NEAR(string.dot(Vector3d(std::cos(foot), std::sin(foot), 0)), 0.0, 1e-13);
          // The string points away from its start, because it was unwound and not wound up.
          EXPECT_LT(sigma * std::atan2(point.y(), point.x()), sigma * azimuth);

          const Vector3d n = flank_normal(g, sigma, u, z);
          constexpr double kStep = 1e-4;  // differences are accurate to h² ~ 1e-8
          const Vector3d by_u =
              flank_point(g, sigma, u + kStep, z) - flank_point(g, sigma, u - kStep, z);
          const Vector3d by_z =
              flank_point(g, sigma, u, z + kStep) - flank_point(g, sigma, u, z - kStep);
          EXPECT_NEAR(n.norm(), 1.0, 1e-15);
          EXPECT_NEAR(n.dot(by_u) / (2 * kStep), 0.0, 20 * kStep * kStep);
          EXPECT_NEAR(n.dot(by_z) / (2 * kStep), 0.0, 20 * kStep * kStep);
          // The normal points out of the material, which means away from the middle of the tooth.
          const double middle = z * std::tan(beta_b) / 20.0;
          EXPECT_GT(sigma * n.dot(Vector3d(-std::sin(middle), std::cos(middle), 0)), 0.0);
        }
      }
    }
  }
}

/// The same housing seen from gear 2. The tooth of gear 2 takes the place of the tooth of gear 1.
ScrewPair exchanged(const ScrewPair& p) {
  return {p.second, p.first, p.center_distance, p.shaft_angle};
}

/// Two screws with a common base pitch, at angles at which they can mesh. Some tips are too short
/// for continuous contact.
ScrewPair random_screws(std::mt19937_64& random) {
  const auto between = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  const double m = between(0.5, 5.0);
  const double alpha = between(14, 28) * kDegree;
  const double base_pitch = kPi * m * std::cos(alpha);
  ScrewPair p;
  for (Screw* g : {&p.first, &p.second}) {
    const double beta = between(-55, 55) * kDegree;
    const double x = between(-0.1, 0.4);
    g->teeth = static_cast<int>(between(12, 50));
    g->base_helix = std::asin(std::sin(beta) * std::cos(alpha));
    g->base_radius = g->teeth * base_pitch / (2 * kPi * std::cos(g->base_helix));
    const double r = g->teeth * m / (2 * std::cos(beta));
    const double alpha_t = std::acos(g->base_radius / r);
    g->base_thickness =
        2 * g->base_radius *
        ((kPi / 2 + 2 * x * std::tan(alpha)) / g->teeth + std::tan(alpha_t) - alpha_t);
    g->tip_radius = std::max(r + (x + between(0.4, 1.0)) * m, g->base_radius * 1.01);
    p.center_distance += r + x * m;
    p.shaft_angle += beta;
  }
  p.center_distance += between(-0.1, 0.2) * m;
  p.shaft_angle += between(-2.0, 2.0) * kDegree;
  return p;
}

// Laws over seeded pairs with any backlash and any mounting error.
// (1) If the gears are exchanged, they touch at the same rotations. The search then computes when
//     a flank of gear 1 passes the points of gear 2.
// (2) Half a turn about the centre line exchanges the sides: T_trailing(φ_1) = −T_leading(−φ_1).
// (3) One pitch later, the next tooth has the same contact.
// (4) While the flanks touch within their ends, T is constant.
TEST(TouchingScrews, laws_over_seeded_pairs) {
  std::mt19937_64 random(20240611);
  int meshes = 0, at_flanks = 0, at_edges = 0;
  while (meshes < 40) {
    const ScrewPair p = random_screws(random);
    // Nearly parallel axes would require hundreds of teeth. The pairs of the file include that
    // case.
    if (std::abs(p.shaft_angle) < 5 * kDegree) continue;
    ++meshes;
    SCOPED_TRACE(::testing::Message() << "pair " << meshes << ", Σ = " << p.shaft_angle / kDegree
                                      << "°, a = " << p.center_distance);
    std::vector<double> ahead;
    for (const double part : {0.0, 0.31, 0.62}) {
      const double rotation_1 = part * pitch_1(p);
      const auto t = touch(p, rotation_1, Side::leading);
      ASSERT_TRUE(t.has_value());
      ++(t->where == Where::flanks ? at_flanks : at_edges);
      if (t->where == Where::flanks) ahead.push_back(t->rotation_2 - ratio(p) * rotation_1);

      const auto back = touch(exchanged(p), kPi / p.second.teeth - t->rotation_2, Side::leading);
      ASSERT_TRUE(back.has_value());
      EXPECT_NEAR(std::remainder(back->rotation_2 + rotation_1 - kPi / p.first.teeth, pitch_1(p)),
                  0.0, kRotation * (1 + 1 / ratio(p)))
          << t->where << " and exchanged " << back->where;  // (1)

      const auto mirror = touch(p, -rotation_1, Side::trailing);
      ASSERT_TRUE(mirror.has_value());
      EXPECT_NEAR(mirror->rotation_2, -t->rotation_2, kRotation);  // (2)

      const auto next = touch(p, rotation_1 + pitch_1(p), Side::leading);
      ASSERT_TRUE(next.has_value());
      EXPECT_NEAR(next->rotation_2, t->rotation_2 + 2 * kPi / p.second.teeth, kRotation);  // (3)
    }
    for (const double t : ahead) EXPECT_NEAR(t, ahead.front(), 10 * kRotation);  // (4)
  }
  EXPECT_GT(at_flanks, 60);
  EXPECT_GT(at_edges, 10);
}

// The tips are too short for continuous contact. Between two teeth, an edge touches. Gear 2 then
// falls behind the ratio, is never ahead of it, and does not jump.
TEST(TouchingScrews, short_tips_touch_with_their_edges) {
  const ConjugatePair& pair = conjugate_pairs().front();
  ScrewPair p = mounted(pair, pair.meshes[1]);
  p.first.tip_radius -= 1.6, p.second.tip_radius -= 2.0;
  constexpr int kSteps = 60;
  int flanks = 0, tips = 0;
  double before = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double rotation_1 = i * pitch_1(p) / kSteps;
    const auto t = touch(p, rotation_1, Side::leading);
    ASSERT_TRUE(t.has_value());
    const double ahead = t->rotation_2 - ratio(p) * rotation_1;
    EXPECT_LT(ahead, kRotation);
    if (t->where == Where::flanks) {
      ++flanks;
      EXPECT_NEAR(ahead, 0.0, kRotation);
    } else {
      ++tips;
      EXPECT_TRUE(t->where == Where::tip_1 || t->where == Where::tip_2) << t->where;
      EXPECT_NEAR(t->margin, 0.0, 1e-6);
    }
    // There is no jump: T changes by less than half of the rotation of gear 2 in the step.
    if (i > 0) {
      EXPECT_LT(std::abs(ahead - before), 0.5 * ratio(p) * pitch_1(p) / kSteps);
    }
    before = ahead;
  }
  EXPECT_GT(flanks, 5);
  EXPECT_GT(tips, 5);
}

// Gear 2 reaches below the base circle of gear 1, where there is no involute. Its flank meets the
// end of gear 1's flank, or its tip edge enters the material next to it. Gear 2 is pushed ahead,
// and the solids overlap on both sides, so the pair is not accepted as a mesh.
TEST(TouchingScrews, interference_is_told) {
  const ScrewPair p = interfering_pair();
  int base = 0;
  double most = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double rotation_1 = i * pitch_1(p) / 8;
    const auto t = touch(p, rotation_1, Side::leading);
    ASSERT_TRUE(t.has_value());
    const double ahead = t->rotation_2 - ratio(p) * rotation_1;
    most = std::max(most, ahead);
    if (t->where == Where::flanks) {
      EXPECT_NEAR(ahead, 0.0, kRotation);
      continue;
    }
    EXPECT_TRUE(t->where == Where::base_1 || t->where == Where::tip_2) << t->where;
    EXPECT_NEAR(t->margin, 0.0, 1e-6);
    EXPECT_GT(ahead, 1e6 * kRotation);
    EXPECT_LT(*play(p, rotation_1), -1e6 * kRotation);
    base += t->string_1 < 1e-6;
  }
  EXPECT_GT(base, 2);
  EXPECT_GT(most * p.second.base_radius, 0.02);  // mm
}

TEST(TouchingScrews, face_ends_the_flank) {
  const ConjugatePair& pair = conjugate_pairs().front();
  ScrewPair p = mounted(pair, pair.meshes[1]);
  const auto whole = touch(p, 0.0, Side::leading);
  p.half_face = std::abs(whole->point.z()) + 1e-6;
  EXPECT_EQ(touch_of_tooth(p, 0.0, Side::leading, whole->tooth)->where, Where::flanks);
  p.half_face -= 2e-6;
  EXPECT_EQ(touch_of_tooth(p, 0.0, Side::leading, whole->tooth)->where, Where::face_1);
  p.half_face = 0.0;  // a disk
  EXPECT_EQ(touch_of_tooth(p, 0.0, Side::leading, whole->tooth)->where, Where::face_1);
}

TEST(TouchingScrews, nothing_touches_out_of_reach) {
  const ConjugatePair& pair = conjugate_pairs().front();
  ScrewPair p = mounted(pair, pair.meshes[1]);
  p.center_distance = p.first.tip_radius + p.second.tip_radius;
  EXPECT_FALSE(touch(p, 0.0, Side::leading).has_value());
  EXPECT_FALSE(play(p, 0.0).has_value());
}

TEST(TouchingScrews, wrong_numbers_are_refused) {
  const ConjugatePair& pair = conjugate_pairs().front();
  const ScrewPair good = mounted(pair, pair.meshes[1]);
  std::vector<ScrewPair> wrong(8, good);
  wrong[0].first.teeth = 0;
  wrong[1].second.base_radius = wrong[1].second.tip_radius;
  wrong[2].first.base_helix = kPi / 2;
  wrong[3].second.base_thickness = 0.1;  // the flanks meet below the tip
  wrong[4].center_distance = wrong[4].second.tip_radius;
  wrong[5].shaft_angle = kPi;
  wrong[6].shaft_angle = 0.0;  // two right hands
  wrong[7].half_face = -1.0;
  for (const ScrewPair& p : wrong) {
    EXPECT_THROW(touch(p, 0.0, Side::leading), std::invalid_argument) << &p - wrong.data();
  }
}

}  // namespace
}  // namespace gearwright::oracle
