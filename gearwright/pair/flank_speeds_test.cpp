// Compares the speed of the contact over each flank with the velocities of the rotating gears at
// the point of contact.
#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {
namespace {

InvolutePair mounted(int z1, int z2, double beta1_deg, double beta2_deg, double more) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = z1, .module = 2.0, .beta_deg = beta1_deg, .x = 0.3, .face_width = 200.0});
  auto one = make_gear(s);
  s.teeth = z2;
  s.helix_angle = Angle::degrees(beta2_deg);
  s.profile_shift = 0.1;
  auto two = make_gear(s);
  EXPECT_TRUE(one && two);
  const auto tight = complete_place(base_pair(*one, *two), std::nullopt, std::nullopt);
  EXPECT_TRUE(tight);
  const PairSpec place{tight->center_distance + more, tight->shaft_angle};
  return testing::taken(mount_as<InvolutePair>(*one, *two, place));
}

// The contact moves along the common normal n with the speed v_n, and the material of gear i moves
// with ω_i × r. The speed over the flank is the difference. Gear 1 turns clockwise by one radian,
// and gear 2 turns about its own axis.
TEST(FlankSpeeds, are_those_of_the_contact_over_the_turning_gears) {
  struct Case {
    int z1, z2;
    double beta1, beta2, more;
  };
  for (const Case& c :
       {Case{9, 15, 51.6, 39.4, 0.0}, Case{17, 23, 20, 10, 0.05}, Case{13, 27, -45, -45, 0.1},
        Case{12, 40, 70, -5, 0.0}, Case{17, 31, 0, 0, 0.1}, Case{20, -61, 20, 10, -0.1},
        Case{18, -50, -12, 5, 0.0}, Case{24, -90, 0, -15, 0.0}}) {
    SCOPED_TRACE(::testing::Message() << c.z1 << ":" << c.z2 << " " << c.beta1 << " " << c.beta2);
    const InvolutePair p = mounted(c.z1, c.z2, c.beta1, c.beta2, c.more);
    const double sigma = p.axis_angle().rad();
    const Vec3 axis_2(0.0, std::sin(sigma), std::cos(sigma));
    const Vec3 foot_2(p.center_distance, 0.0, 0.0);
    const auto& m = p.mesh;
    const Vec3 A = p.on_line_of_action(m.rho1_A).r;
    const Vec3 n = (p.on_line_of_action(m.rho1_E).r - A).normalized();
    const double v_n = p.input.gears[0].radius * std::cos(p.input.gears[0].helix_angle);
    for (const double u : {0.0, 0.3, 0.5, 0.8, 1.0}) {
      const double rho = m.rho1_A + u * (m.rho1_E - m.rho1_A);
      const Vec3 r = p.on_line_of_action(rho).r;
      const Vec3 v1 = Vec3(0.0, 0.0, -1.0).cross(r);
      const Vec3 v2 = c.z1 / static_cast<double>(c.z2) * axis_2.cross(r - foot_2);
      EXPECT_NEAR(v1.dot(n), v_n, 1e-11 * v_n);
      EXPECT_NEAR(v2.dot(n), v_n, 1e-11 * v_n);
      const Vec3 w1 = v_n * n - v1;
      const Vec3 w2 = v_n * n - v2;
      const FlankSpeeds<double> w = flank_speeds(p.input, m, rho);
      const double scale = v1.squaredNorm();
      for (int i : {0, 1}) {
        const double square = w.across[i] * w.across[i] + w.along[i] * w.along[i];
        EXPECT_NEAR(square, (i == 0 ? w1 : w2).squaredNorm(), 1e-11 * scale) << u;  // [T4.24]
      }
      EXPECT_NEAR(w.across[0] * w.across[1] + w.along[0] * w.along[1], w1.dot(w2), 1e-11 * scale);
      // Sliding distance per mm of the contact's movement over the flank. [T4.25], and with a sign
      // [T2.22]
      const SpecificSliding<double> s = specific_sliding(p.input, m, rho);
      if (s.zeta_1 && w1.norm() > 1e-3 * v1.norm()) {
        EXPECT_NEAR(std::abs(*s.zeta_1), (v1 - v2).norm() / w1.norm(), 1e-8);
      }
      if (s.zeta_2 && w2.norm() > 1e-3 * v1.norm()) {
        EXPECT_NEAR(std::abs(*s.zeta_2), (v1 - v2).norm() / w2.norm(), 1e-8);
      }
    }
  }
}

}  // namespace
}  // namespace gearwright
