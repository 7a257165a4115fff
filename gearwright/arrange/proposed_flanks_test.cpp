#include "gearwright/arrange/proposed_flanks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/math/involute.hpp"

namespace gearwright {
namespace {

Arranged arranged_pair(double beta_deg) {
  GivenPair given;
  for (const int which : {1, 2}) {
    given.gears[static_cast<std::size_t>(which - 1)].emplace();
    GearInput& g = given.gear(which);
    g.cylindrical.teeth = which == 1 ? 23 : 41;
    g.cylindrical.normal_module = 3.0;
    g.cylindrical.helix_angle = Angle::degrees(which == 1 ? beta_deg : -beta_deg);
    g.helix_given = true;
    g.cylindrical.face_width = 20.0;
    g.face_width_given = true;
    g.cylindrical.rack = *iso53_rack("ISO53-A");
    g.bore = Bore{.diameter = 25.0};
  }
  return std::move(arrange(given)).take();
}

// If a root relief of gear 1 replaces a tip relief of gear 2, it removes the same amount at each
// contact, [T12.30], for both hands and both driving gears. A steep relief shifts the contact
// point, which changes the gap by a term of second order, so the amounts here are small.
TEST(ProposedFlanks, RootReliefOfGear1ReplacesTheTipReliefOfGear2) {
  for (const double beta : {0.0, 18.0, -18.0})
    for (const int driver : {1, 2}) {
      const Arranged arranged = arranged_pair(beta);
      LoadInput load;
      load.torques = {5};
      load.driver = driver;
      load.positions = 6;
      load.slices = 8;
      load.accuracy = ComplianceAccuracy::draft;
      std::vector<Warning> warnings;
      auto made = load_task(arranged, {}, load, warnings);
      ASSERT_TRUE(made) << made.error().message();
      LoadTask task = std::move(made).take();
      task.request.root_stress = false;
      const auto compliance = task.compliance();
      ASSERT_TRUE(compliance);
      const auto relief = propose_relief(arranged, task, *compliance, ReliefLength::long_relief);
      ASSERT_TRUE(relief && *relief);
      const ReliefProposal& p = **relief;
      // With this amount, the tip carries no load before the start of the path of contact. A root
      // relief would continue beyond this start.
      const double amount = 1.2 * p.deflection[1];
      const auto loaded_with = [&](const PairModifications& m) {
        LoadTask own = task;
        own.setup = std::move(task.setup.with_modifications(m)).take();
        return own.contact(*compliance).torques[0];
      };
      PairModifications tip, root;
      for (const std::size_t side : {0, 1}) {
        tip[1][side].tip_relief = {amount, p.tip_start[1], ReliefShape::linear};
        root[0][side].root_relief = {amount * p.root_factor, p.root_start, ReliefShape::linear};
      }
      const LoadedTorque by_tip = loaded_with(tip);
      const LoadedTorque by_root = loaded_with(root);
      const LoadedTorque plain = loaded_with({});
      // The second-order term is R C'²/2 at the first contact, where the slope C' along the flank
      // is greatest; R < ρ_A.
      const double r_b = arranged.gear(1).base_radius();
      const double rho = arranged.pair->involute()->mesh.rho1_true_begin;
      const double slope = amount / (roll_length(p.root_start / 2, r_b) - rho) * r_b / rho;
      const double gain = rho / 2 * slope * slope / arranged.gear(2).base_radius();
      ASSERT_LT(gain, 0.05 * plain.peak_to_peak.rad());
      ASSERT_GT(std::abs(plain.peak_to_peak.rad() - by_tip.peak_to_peak.rad()),
                0.1 * plain.peak_to_peak.rad());
      for (std::size_t i = 0; i < plain.positions.size(); ++i)
        EXPECT_NEAR(by_root.positions[i].te.rad(), by_tip.positions[i].te.rad(), gain)
            << beta << driver << i;
    }
}

TEST(ProposedFlanks, SlopeIsTheDeflectionOnAWiderFace) {
  const LeadProposal same = propose_lead({0.012, 0.0}, 0.0, 30, 30);
  EXPECT_DOUBLE_EQ(same.slope, 0.012);
  EXPECT_EQ(same.crowning, 0.0);
  EXPECT_DOUBLE_EQ(propose_lead({-0.012, 0.0}, 0.0, 45, 30).slope, -0.018);
  EXPECT_FALSE(propose_lead({}, 0.0, 30, 30).any());
}

// [T12.32]: if a mating plane is inclined by F over the face width b, a flank with the crowning C
// touches it at the distance F b/(8 C) from the middle. With the proposed crowning, this distance
// is a quarter of the face width.
TEST(ProposedFlanks, CrowningKeepsTheContactInTheMiddleHalf) {
  constexpr double kF = 0.016;
  constexpr double kFace = 40.0;
  const LeadProposal p = propose_lead({}, kF, kFace, kFace);
  EXPECT_DOUBLE_EQ(p.crowning, 0.008);
  double nearest = 0.0;
  double least = 1e9;
  for (double z = -kFace / 2; z <= kFace / 2; z += 0.01) {
    const double gap = 4 * p.crowning * (z / kFace) * (z / kFace) - kF * z / kFace;
    if (gap < least) {
      least = gap;
      nearest = z;
    }
  }
  EXPECT_NEAR(nearest, kFace / 4, 0.011);
  // A bow that opens the gap in the middle of the face adds to the crowning. The opposite bow
  // reduces it.
  EXPECT_DOUBLE_EQ(propose_lead({0.0, -0.004}, kF, kFace, kFace).crowning, 0.012);
  EXPECT_DOUBLE_EQ(propose_lead({0.0, 0.005}, kF, kFace, kFace).crowning, 0.003);
  EXPECT_EQ(propose_lead({0.0, 0.02}, kF, kFace, kFace).crowning, 0.0);
  EXPECT_DOUBLE_EQ(propose_lead({}, kF, 2 * kFace, kFace).crowning, 0.032);
}

}  // namespace
}  // namespace gearwright
