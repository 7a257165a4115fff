#include "gearwright/generation/rack_envelope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {
namespace {

using testing::kEps;

constexpr Angle kRightAngle = Angle::radians(kPi / 2);
constexpr Angle k20Degrees = Angle::radians(kPi / 9);

const RackMotion kSpur{20.0, 1.0, 0.4};
const RackMotion kHelical{17.0, std::cos(kPi / 7), -0.9};
const EdgeCircle kTip{{-1.74, 2.4}, -0.76, kRightAngle, k20Degrees};
const EdgeCircle kCorner{{-2.5, 2.4}, 0.0, kRightAngle, k20Degrees};
const EdgeCircle kBottom{{1.4, 0.5}, 0.5, k20Degrees, kRightAngle};

struct Envelope {
  RackMotion motion;
  EdgeCircle circle;
};

std::vector<Envelope> envelopes() {
  std::vector<Envelope> all;
  for (const RackMotion& motion : {kSpur, kHelical}) {
    for (const EdgeCircle& circle : {kTip, kCorner, kBottom}) all.push_back({motion, circle});
  }
  return all;
}

// A point of the envelope is the point of the cutter's edge in the frame of the gear, at the
// rotation at which the normal of the edge passes through the pitch point.
TEST(RackTrochoid, points_are_cut_when_the_normal_meets_the_pitch_point) {
  for (const auto& [motion, circle] : envelopes()) {
    const RackTrochoid curve(motion, circle);
    for (const double tau : {0.4, 0.8, 1.2, 1.5}) {
      const double x = circle.center.x() + motion.shift + circle.q * std::sin(tau);
      const double y = (circle.center.y() + circle.q * std::cos(tau)) / motion.cos_beta;
      // In the transverse section, the normal of the edge is (sin τ, cos β cos τ), and the vector
      // from the pitch point to the contact is (x, k).
      const double k = x * motion.cos_beta * std::cos(tau) / std::sin(tau);
      const double phi = (y - k) / motion.pitch_radius;
      const Vec2 p = curve.point(tau);
      // Turned back by φ, the vector is (r + x, k) again.
      const double c = std::cos(phi), s = std::sin(phi);
      EXPECT_NEAR(p.x() * c + p.y() * s, motion.pitch_radius + x, 1e-13);
      EXPECT_NEAR(p.y() * c - p.x() * s, k, 1e-13);
      EXPECT_NEAR(curve.polar_angle(tau), std::atan2(p.y(), p.x()), 8 * kEps);
    }
  }
}

// Law (1): d|W|²/dτ = 2 F cos τ/sin³τ.
TEST(RackTrochoid, cusp_polynomial_is_the_slope_of_the_radius) {
  for (const auto& [motion, circle] : envelopes()) {
    const RackTrochoid curve(motion, circle);
    for (const double tau : {0.3, 0.7, 1.1, 1.45}) {
      const double h = 1e-5;
      const double slope =
          (curve.point(tau + h).squaredNorm() - curve.point(tau - h).squaredNorm()) / (2 * h);
      const double s = std::sin(tau);
      const double f = evaluate_polynomial(curve.cusp_polynomial(), s);
      const double law = 2 * f * std::cos(tau) / (s * s * s);
      EXPECT_NEAR(slope, law, 1e-6 * (1 + std::abs(law)));
    }
  }
}

// Law (2): dθ/d|W| at the same normal angle and the same x does not depend on q.
TEST(RackTrochoid, slope_does_not_depend_on_the_radius) {
  const double tau = 0.8, x = -1.5;
  const auto slope = [&](double q) {
    const EdgeCircle circle{
        {x - q * std::sin(tau), 2.0 - q * std::cos(tau)}, q, kRightAngle, Angle::radians(0.3)};
    const RackTrochoid curve({20.0, 1.0, 0.0}, circle);
    const double h = 1e-5;
    return (curve.polar_angle(tau + h) - curve.polar_angle(tau - h)) /
           (curve.point(tau + h).norm() - curve.point(tau - h).norm());
  };
  EXPECT_NEAR(slope(-0.7), slope(0.0), 1e-6 * std::abs(slope(0.0)));
  EXPECT_NEAR(slope(0.4), slope(0.0), 1e-6 * std::abs(slope(0.0)));
}

TEST(RackTrochoid, neck_is_where_the_half_angle_is_least) {
  const RackMotion motion{6.0, 1.0, 0.0};  // six teeth of module 2
  const RackTrochoid curve(motion, kTip);
  const std::vector<double> necks = curve.neck_angles(kTip.end_tau.rad(), kTip.begin_tau.rad());
  ASSERT_EQ(necks.size(), 1u);
  const double least = curve.polar_angle(necks[0]);
  for (const double d : {1e-3, 1e-2, 0.1}) {
    EXPECT_GT(curve.polar_angle(necks[0] - d), least);
    EXPECT_GT(curve.polar_angle(necks[0] + d), least);
  }
  EXPECT_TRUE(RackTrochoid({200.0, 1.0, 0.0}, kTip)
                  .neck_angles(kTip.end_tau.rad(), kTip.begin_tau.rad())
                  .empty());
}

// The involute of the rack's flank has the base circle r cos α_t. Its half thickness on the pitch
// circle is half of the thickness that the rack leaves there.
TEST(RackInvolute, base_circle_and_thickness) {
  for (const RackMotion& motion : {kSpur, kHelical}) {
    const EdgeLine flank{k20Degrees, 1.57, -2.0, 3.0};
    const Involute curve = rack_involute(motion, flank);
    const double tan_t = std::tan(kPi / 9) / motion.cos_beta;
    EXPECT_NEAR(curve.base_radius(), motion.pitch_radius * std::cos(std::atan(tan_t)), 1e-14 * 20);
    const double half_thickness = (1.57 + motion.shift * std::tan(kPi / 9)) / motion.cos_beta;
    EXPECT_NEAR(curve.polar_angle(curve.roll_at(motion.pitch_radius)),
                half_thickness / motion.pitch_radius, 4 * kEps);
  }
}

// Every point of a line cuts the same point of the gear as a sharp corner with the same
// coordinates.
TEST(RackInvolute, roll_angle_finds_the_point_of_the_edge) {
  for (const RackMotion& motion : {kSpur, kHelical}) {
    const EdgeLine flank{k20Degrees, 1.57, -2.0, 3.0};
    const Involute curve = rack_involute(motion, flank);
    for (const double height : {-1.0, 0.0, 1.5}) {
      const EdgeCircle corner{
          {height, 1.57 - height * std::tan(kPi / 9)}, 0.0, kRightAngle, k20Degrees};
      const Vec2 wanted = RackTrochoid(motion, corner).point(kPi / 9);
      const Vec2 found = curve.point(rack_involute_roll(motion, flank, height + motion.shift));
      EXPECT_LE((wanted - found).norm(), 1e-13);
    }
    const double s = std::sin(std::atan(std::tan(kPi / 9) / motion.cos_beta));
    EXPECT_NEAR(rack_involute_roll(motion, flank, -motion.pitch_radius * s * s), 0.0, kEps);
  }
}

}  // namespace
}  // namespace gearwright
