// The field is compared with its definition, and its derivatives with differences.
#include "gearwright/contact/gap_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

testing::SamplePair wrong_everywhere(testing::SamplePair p) {
  auto& e = p.place.errors;
  e.center_distance = 0.05, e.crossing = Angle::radians(1e-3),
  e.intersecting = Angle::radians(-2e-3), e.axial = 0.7;
  e.helix_twist = {2e-5, -1e-5};
  FlankModifications m;
  m.profile_crowning = 0.02, m.lead_crowning = 0.03, m.lead_slope = 0.01, m.profile_slope = 0.01;
  for (int g : {1, 2}) p.modify(g, m);
  return p;
}

std::vector<testing::SamplePair> samples() {
  std::vector<testing::SamplePair> all{testing::involutes(20, 41, 15),
                                       testing::involutes(20, -61, 10), testing::arcs()};
  for (int i : {0, 1, 2}) all.push_back(wrong_everywhere(all[i]));
  all[4].place.gear2_drives = true;
  return all;
}

// φ2* by its definition: the azimuth of the point about axis 2, minus the azimuth of flank 2 at the
// same radius and height.
TEST(GapField, is_the_rotation_at_which_flank_2_passes) {
  const auto p = testing::involutes(20, 41, 15);
  const ContactPair pair = p.pair();
  const FlankPatch &one = pair.patches(1)[0], &two = pair.patches(2)[0];
  GapField field = pair.field(one, two);
  for (const double phi : {-0.11, 0.0, 0.07}) {
    field.set_rotation(phi);
    const double s = 0.5 * (one.s_lo + one.s_hi), z = 3.0;
    double s2 = 0.3;
    const GapJet j = field.at(s, z, s2);
    const PolarJet w1 = one.profile.at(s);
    const Complex r1 = w1.factor * std::polar(1.0, w1.phase + one.twist * z - phi);
    const Complex r2 = r1 - p.place.center_distance;
    EXPECT_LT(std::abs(j.w - r2), 1e-13);
    EXPECT_NEAR(j.u.v, std::log(std::abs(r2)), 1e-14);
    EXPECT_EQ(j.Z.v, z);
    const double r_b = p.gears[1].base_radius(), rho = std::abs(r2);
    const double alpha = std::acos(r_b / rho);
    const double half = p.gears[1].reference().base_tooth_thickness / (2 * r_b);
    const double theta = two.center - (half - (std::tan(alpha) - alpha)) + two.twist * z;
    const double want = std::arg(r2) - theta - pair.ratio() * phi;
    EXPECT_NEAR(std::remainder(j.t.v - want, 2 * std::numbers::pi), 0.0, 1e-14);
  }
}

TEST(GapField, derivatives) {
  const auto all = samples();
  int inside = 0;
  for (const auto& p : all) {
    const ContactPair pair = p.pair();
    const FlankPatch &one = pair.patches(1)[0], &two = pair.patches(2)[0];
    GapField field = pair.field(one, two);
    field.set_rotation(0.03);
    for (const double x : {0.3, 0.7}) {
      SCOPED_TRACE(::testing::Message() << "sample " << &p - &all[0] << " at " << x);
      const double s = one.s_lo + x * (one.s_hi - one.s_lo),
                   z = one.z_lo + x * (one.z_hi - one.z_lo);
      double s2 = 0.5 * (two.s_lo + two.s_hi);
      const auto at = [&](double ds, double dz) {
        double own = s2;
        // The second evaluation starts with the parameter that the first evaluation found.
        field.at(s + ds, z + dz, own);
        return field.at(s + ds, z + dz, own);
      };
      const GapJet j = at(0, 0);
      if (j.u.v < two.u_lo || j.u.v > two.u_hi) continue;  // outside flank 2, a series is used
      ++inside;
      const double h = 1e-6 * (one.s_hi - one.s_lo), g = 1e-6 * (one.z_hi - one.z_lo);
      const auto check = [](double got, double plus, double minus, double step, double scale) {
        EXPECT_NEAR(got, (plus - minus) / (2 * step), 1e-7 * scale);
      };
      const GapJet s_p = at(h, 0), s_m = at(-h, 0), z_p = at(0, g), z_m = at(0, -g);
      const auto slope = [&](Jet2 GapJet::*q) {
        const double scale = 1 + std::abs((j.*q).s) + std::abs((j.*q).ss) + std::abs((j.*q).sz);
        check((j.*q).s, (s_p.*q).v, (s_m.*q).v, h, scale);
        check((j.*q).z, (z_p.*q).v, (z_m.*q).v, g, scale);
        check((j.*q).ss, (s_p.*q).s, (s_m.*q).s, h, scale);
        check((j.*q).sz, (z_p.*q).s, (z_m.*q).s, g, scale);
        check((j.*q).sz, (s_p.*q).z, (s_m.*q).z, h, scale);
        check((j.*q).zz, (z_p.*q).z, (z_m.*q).z, g, scale);
      };
      slope(&GapJet::t);
      slope(&GapJet::u);
      slope(&GapJet::Z);
    }
  }
  EXPECT_GE(inside, 8);
}

// A flank that turns by dφ moves by arm · dφ along its normal. For an involute, arm = r_b cos β_b.
TEST(GapField, arm_of_an_involute) {
  const auto p = testing::involutes(20, 41, 15);
  const ContactPair pair = p.pair();
  const GapField field(pair.patches(1)[0], pair.patches(2)[0], pair.mount(), pair.ratio(), -1.0);
  double s2 = 0.3;
  const double r_b = p.gears[1].base_radius(), twist = p.gears[1].twist();
  for (const double s : {0.3, 0.4, 0.5})
    EXPECT_NEAR(GapField::arm(field.at(s, 1.0, s2)), r_b / std::hypot(1.0, r_b * twist), 1e-11);
}

}  // namespace
}  // namespace gearwright
