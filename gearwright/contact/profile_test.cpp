// Pieces of a profile are compared with their own curve and with differences.
#include "gearwright/contact/profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

Arc flank_of(const Gear& gear) { return *gear.tooth->outline.find(ArcName::flank); }

// An arc that is not cut by a rack. The parameter of its profile is therefore u = ln ρ.
Arc round_arc() {
  const auto curve = std::make_shared<OffsetCircle>(20.0, 0.05, 4.0);
  return {ArcName::flank, curve, 0.9, 0.3, curve->point(0.9), curve->point(0.3)};
}

struct Named {
  const char* name;
  Arc arc;
  double twist;
};

std::vector<Named> arcs_of_all_kinds() {
  const auto external = testing::involutes(20, 41, 15), ring = testing::involutes(20, -61, 0);
  const auto wildhaber = testing::arcs();
  return {{"involute", flank_of(external.gears[0]), external.gears[0].twist()},
          {"ring", flank_of(ring.gears[1]), 0.0},
          {"rack F", flank_of(wildhaber.gears[0]), wildhaber.gears[0].twist()},
          {"rack P", flank_of(wildhaber.gears[1]), wildhaber.gears[1].twist()},
          {"round", round_arc(), 0.01}};
}

Complex point(const PolarJet& j) { return j.factor * std::polar(1.0, j.phase); }

// (1) the piece is the arc, and its other side is the mirror image    (2) ℓ′ and ℓ″ are derivatives
// (3) evaluation by radius gives the same curve    (4) θ′ and θ″ are derivatives
TEST(Profile, is_its_arc) {
  for (const Named& n : arcs_of_all_kinds()) {
    SCOPED_TRACE(n.name);
    for (const double side : {1.0, -1.0}) {
      const Profile p(n.arc, side, n.twist);
      EXPECT_LT(p.s_lo(), p.s_hi());
      for (int i = 1; i < 10; ++i) {
        const double s = p.s_lo() + (p.s_hi() - p.s_lo()) * i / 10;
        const PolarJet j = p.at(s);
        const Complex w = point(j);
        const double rho = std::abs(w);
        const bool rises = n.arc.begin_point.norm() < n.arc.end_point.norm();
        const Vec2 on_arc = n.arc.curve->point(n.arc.curve->parameter_at_radius(
            rho, rises ? n.arc.begin : n.arc.end, rises ? n.arc.end : n.arc.begin));
        EXPECT_NEAR(w.real(), on_arc.x(), 1e-12 * rho);  // (1)
        EXPECT_NEAR(w.imag(), side * on_arc.y(), 1e-12 * rho);
        const double h = 1e-5 * (p.s_hi() - p.s_lo());
        const auto log_at = [&](double t) {
          const PolarJet q = p.at(t);
          return std::log(q.factor) + Complex(0, q.phase);
        };
        const Complex d1 = (log_at(s + h) - log_at(s - h)) / (2 * h);
        const Complex d2 = (p.at(s + h).d1 - p.at(s - h).d1) / (2 * h);
        EXPECT_LT(std::abs(d1 - j.d1), 1e-7 * (1 + std::abs(j.d1)));  // (2)
        EXPECT_LT(std::abs(d2 - j.d2), 1e-7 * (1 + std::abs(j.d2)));
        const double u = std::log(rho);
        double s2 = 0.5 * (p.s_lo() + p.s_hi());
        const RadialJet r = p.at_radius(u, s2);
        const double theta = std::arg(r.factor) + r.phase;
        EXPECT_NEAR(std::remainder(theta - std::arg(w), 2 * std::numbers::pi), 0.0, 1e-13);  // (3)
        EXPECT_NEAR(p.s_of(u), s, 1e-12 * (1 + std::abs(s)));
        const double g = 1e-6;
        const auto angle = [&](double v) {
          const RadialJet q = p.at_radius(v, s2);
          return std::arg(q.factor) + q.phase;
        };
        EXPECT_NEAR((angle(u + g) - angle(u - g)) / (2 * g), r.d1, 1e-6 * (1 + std::abs(r.d1)));
        EXPECT_NEAR((p.at_radius(u + g, s2).d1 - p.at_radius(u - g, s2).d1) / (2 * g), r.d2,
                    1e-5 * (1 + std::abs(r.d2)));  // (4)
      }
    }
  }
}

// Beyond its ends a piece continues without a jump of value or slope.
TEST(Profile, goes_on_beyond_its_ends) {
  for (const Named& n : arcs_of_all_kinds()) {
    SCOPED_TRACE(n.name);
    const Profile p(n.arc, -1.0, n.twist);
    double s = 0.5 * (p.s_lo() + p.s_hi());
    for (const double end : {p.u_lo(), p.u_hi()}) {
      const double out = end == p.u_lo() ? -1e-7 : 1e-7;
      const RadialJet a = p.at_radius(end - out, s), b = p.at_radius(end + out, s);
      const double a_theta = std::arg(a.factor) + a.phase, b_theta = std::arg(b.factor) + b.phase;
      EXPECT_NEAR(b_theta - a_theta, 2 * out * a.d1, 3 * out * out * (1 + std::abs(a.d2)));
      EXPECT_NEAR(b.d1 - a.d1, 2 * out * a.d2, 1e-9 * (1 + std::abs(a.d2)));
    }
  }
}

// A flank turns by k = 1/arm per mm removed. For all kinds of profile, k² = (1 + θ′²)/ρ² + twist².
TEST(Profile, turn_per_removal) {
  for (const Named& n : arcs_of_all_kinds()) {
    SCOPED_TRACE(n.name);
    const Profile p(n.arc, -1.0, n.twist);
    for (int i = 1; i < 8; ++i) {
      const double s = p.s_lo() + (p.s_hi() - p.s_lo()) * i / 8;
      const double rho = std::abs(p.at(s).factor), u = std::log(rho);
      double s2 = s;
      const double d1 = p.at_radius(u, s2).d1;
      const TurnPerRemoval k = p.turn_per_removal(s);
      EXPECT_NEAR(k.k, std::sqrt((1 + d1 * d1) / (rho * rho) + n.twist * n.twist), 1e-11 * k.k);
      if (n.arc.name != ArcName::flank || std::string(n.name) == "round") continue;
      const double h = 1e-5;
      const auto at = [&](double v) { return p.turn_per_removal(p.s_of(v)); };
      EXPECT_NEAR((at(u + h).k - at(u - h).k) / (2 * h), k.d1, 1e-6 * (k.k + std::abs(k.d1)));
      EXPECT_NEAR((at(u + h).d1 - at(u - h).d1) / (2 * h), k.d2, 1e-6 * (k.k + std::abs(k.d2)));
    }
  }
}

// The flank of a rack is a straight line, also beyond its ends, and its parameter is the height.
TEST(Profile, flank_of_a_rack_is_straight) {
  const Profile::RackFlank flank{-0.1, 0.05, 0.08, 0.36};
  for (const double side : {1.0, -1.0}) {
    const Profile p(flank, side);
    for (const double u : {-0.3, -0.1, 0.01, 0.05, 0.2}) {
      double s = 0.0;
      const RadialJet r = p.at_radius(u, s);
      EXPECT_EQ(r.factor, Complex(1.0));
      EXPECT_EQ(r.phase, side * (0.08 - 0.36 * u));
      EXPECT_EQ(r.d1, side * -0.36);
      EXPECT_EQ(r.d2, 0.0);
      EXPECT_EQ(p.s_of(u), std::clamp(u, -0.1, 0.05));
    }
    EXPECT_EQ(p.involute(), nullptr);
    EXPECT_FALSE(p.rack_angle(0.0));
    EXPECT_THROW(p.at(0.0), ContractViolation);
    EXPECT_THROW(p.turn_per_removal(0.0), ContractViolation);
  }
}

TEST(Profile, rack_angle_is_the_parameter_of_rack_circles) {
  const auto all = arcs_of_all_kinds();
  EXPECT_FALSE(Profile(all[0].arc, -1.0, 0.0).rack_angle(0.3));
  EXPECT_EQ(Profile(all[2].arc, -1.0, 0.0).rack_angle(0.4), 0.4);
}

}  // namespace
}  // namespace gearwright
