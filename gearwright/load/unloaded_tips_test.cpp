// The least reliefs are compared with loaded contact at many rotations, which does not use the
// positions at which tips begin and end contact.
#include "gearwright/load/unloaded_tips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/load/testing/drive.hpp"

namespace gearwright {
namespace {

struct TipTeeth {
  int z1, z2;
  double beta_deg;
};

Pair tip_pair(const TipTeeth& t) {
  const auto gear = [&](int z, double beta) {
    CylindricalSpec s =
        testing::plain_spec({.teeth = z, .module = 3.0, .beta_deg = beta, .face_width = 30.0});
    s.rack = *iso53_rack("ISO53-A");
    return std::move(make_gear(s)).take();
  };
  return testing::taken(mount(gear(t.z1, t.beta_deg), gear(t.z2, -t.beta_deg)));
}

LoadRequest tip_request(double torque) {
  LoadRequest r;
  r.torques = {torque};
  r.bodies = {ElasticBody{36, 0.3, testing::kE}, ElasticBody{36, 0.3, testing::kE}};
  r.accuracy = ComplianceAccuracy::draft;
  r.slices = {12, 12};
  r.positions = 100;
  r.root_stress = false;
  return r;
}

// Short reliefs, half as long as the part of the path of contact that exceeds one base pitch.
TipPath tip_path(const Pair& pair) {
  const InvolutePair& p = *pair.involute();
  const Mesh<double>& m = p.mesh;
  const double length = (m.rho1_true_end - m.rho1_true_begin - m.step) / 2;
  return {m.rho1_true_begin,
          m.rho1_true_end,
          {2 * std::hypot(p.input.gears[0].radius, m.rho1_true_end - length),
           2 * std::hypot(p.input.gears[1].radius, m.rho2(m.rho1_true_begin + length))}};
}

struct TipCase {
  Pair pair;
  TipPath path;
  ContactSetup setup;
  PairCompliance compliance;

  explicit TipCase(const TipTeeth& teeth)
      : pair(tip_pair(teeth)),
        path(tip_path(pair)),
        setup(std::move(ContactSetup::of(pair, {})).take()),
        compliance(
            std::move(pair_compliance(pair.gear(1), pair.gear(2), tip_request(1.0))).take()) {}

  UnloadedTips at(double torque, bool gear2_drives = false) const {
    return testing::taken(
        unloaded_tips(setup, path, compliance, tip_request(torque), gear2_drives));
  }

  // True if an edge carries load at any position of the pitch.
  bool edge_carries(const std::array<double, 2>& amount, double torque) const {
    PairModifications m;
    for (std::size_t g = 0; g < 2; ++g)
      for (auto& flank : m[g]) flank.tip_relief = {amount[g], path.start_diameter[g]};
    const auto relieved = setup.with_modifications(m);
    EXPECT_TRUE(relieved);
    const ContactPair contact = relieved->pair(false);
    return loaded_contact(contact, setup.gear(1), setup.gear(2), compliance, tip_request(torque))
        .torques[0]
        .edge_carries;
  }
};

TEST(UnloadedTips, AreTheLeastReliefsWithoutLoadOnEdges) {
  constexpr double kTorque = 2e5;
  constexpr double kMore = 0.2 * kMmPerUm;
  // Just before the first point of contact, a tip with a linear relief is nearer to the flank than
  // at the first point of contact. The difference is C² R/l², which is some tenths of a micron.
  constexpr double kLess = 1.5 * kMmPerUm;
  for (const TipTeeth& teeth : {TipTeeth{25, 25, 0}, TipTeeth{20, 43, 0}, TipTeeth{23, 41, 14}}) {
    const TipCase c(teeth);
    const UnloadedTips found = c.at(kTorque);
    const auto [one, two] = found.amount;
    EXPECT_TRUE(found.unloaded[0] && found.unloaded[1]);
    EXPECT_FALSE(c.edge_carries({one + kMore, two + kMore}, kTorque)) << teeth.z2;
    EXPECT_TRUE(c.edge_carries({one - kLess, two + kMore}, kTorque)) << teeth.z2;
    EXPECT_TRUE(c.edge_carries({one + kMore, two - kLess}, kTorque)) << teeth.z2;
  }
}

TEST(UnloadedTips, AreLessThanTheApproachOfASinglePair) {
  // The deformation of the neighbouring teeth and of the body also moves the tip, so the overlap of
  // the tip is less than the approach.
  const TipCase c({25, 25, 0});
  LoadRequest r = tip_request(2e5);
  const ContactPair pair = c.setup.pair(false);
  const LoadedContact plain =
      loaded_contact(pair, c.setup.gear(1), c.setup.gear(2), c.compliance, r);
  double greatest = 0.0;
  for (const LoadedPosition& p : plain.torques[0].positions)
    greatest = std::max(greatest, p.approach);
  for (const double amount : c.at(2e5).amount) {
    EXPECT_LT(amount, greatest);
    EXPECT_GT(amount, 0.6 * greatest);
  }
}

TEST(UnloadedTips, GrowWithTheTorqueFromZero) {
  for (const TipTeeth& teeth : {TipTeeth{25, 25, 0}, TipTeeth{23, 41, 14}}) {
    const TipCase c(teeth);
    double last = -1.0;
    for (const double torque : {1e-3, 1e5, 3e5}) {
      const UnloadedTips found = c.at(torque);
      EXPECT_GT(found.amount[0], last);
      last = found.amount[0];
      if (torque == 1e-3) {
        EXPECT_LT(last, 0.01 * kMmPerUm);
      }
    }
  }
}

// Equal gears have equal amounts within the accuracy of the tables of neighbouring teeth. If the
// gears are exchanged, the amounts are exchanged. If gear 2 drives, the amounts are the same,
// because half a turn maps the pair to itself.
TEST(UnloadedTips, AreSymmetric) {
  const UnloadedTips equal = TipCase({25, 25, 0}).at(2e5);
  EXPECT_NEAR(equal.amount[0], equal.amount[1], 0.01 * equal.amount[0]);
  const UnloadedTips there = TipCase({20, 43, 0}).at(2e5);
  const UnloadedTips back = TipCase({43, 20, 0}).at(2e5 * 43 / 20);
  EXPECT_NEAR(there.amount[0], back.amount[1], 0.01 * there.amount[0]);
  EXPECT_NEAR(there.amount[1], back.amount[0], 0.01 * there.amount[1]);
  const TipCase c({20, 31, 14});
  const UnloadedTips one = c.at(2e5);
  const UnloadedTips two = c.at(2e5, true);
  for (const std::size_t g : {0, 1})
    EXPECT_NEAR(one.amount[g], two.amount[g], 1e-3 * one.amount[g]);
}

TEST(UnloadedTips, ReportTipsThatStillCarry) {
  const UnloadedTips found = TipCase({25, 25, 0}).at(2e7);
  EXPECT_FALSE(found.unloaded[0]);
  EXPECT_NEAR(found.amount[0], 3.0 / 40, 1e-12);
}

}  // namespace
}  // namespace gearwright
