// The helix modifications follow from the deflection of the shafts and from the tolerances.
#include "gearwright/arrange/proposed_flanks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

namespace gearwright {
namespace {

RatedPair rated(double beta_deg) {
  const auto gear = [&](int z, double beta) {
    CylindricalSpec s =
        testing::plain_spec({.teeth = z, .module = 4.0, .beta_deg = beta, .face_width = 50.0});
    s.rack = *iso53_rack("ISO53-A");
    return std::move(make_gear(s)).take();
  };
  const auto pair = mount(gear(21, beta_deg), gear(68, -beta_deg));
  EXPECT_TRUE(pair);
  return std::move(rated_pair(*pair)).take();
}

MeshShafts shafts_of(double left, double right) {
  Shaft shaft;
  shaft.bearings = {left, right};
  shaft.diameters = {40.0};
  return {.of = {shaft, std::nullopt}, .hand1 = 1.0};
}

TEST(ProposedFlanks, DeflectionIsTheNearestParabola) {
  constexpr double kTorque = 5e5;
  for (const double beta : {0.0, 15.0}) {
    const RatedPair pair = rated(beta);
    const MeshShafts shafts = shafts_of(-60, 90);
    const FaceDeflection d = face_deflection(pair, shafts, kTorque);
    const auto f = shaft_deviation(pair, shafts, 2 * kTorque / pair.gears[0].reference_diameter);
    // What is left of the approach −f cos β_b, less its constant part.
    double least = 1e9;
    double greatest = -1e9;
    for (std::size_t k = 0; k < f.size(); ++k) {
      const double x = static_cast<double>(k) / static_cast<double>(f.size() - 1) - 0.5;
      const double rest =
          -f[k] * std::cos(pair.beta_b) - kUmPerMm * (d.slope * x + d.bow * (1 - 4 * x * x));
      least = std::min(least, rest);
      greatest = std::max(greatest, rest);
    }
    EXPECT_LT(greatest - least, 0.05 * std::abs(d.slope) * kUmPerMm) << beta;
    EXPECT_GT(std::abs(d.slope), 1e-3);
    EXPECT_LT(d.bow, 0.0);  // the middle of the face yields most between the bearings
  }
}

TEST(ProposedFlanks, DeflectionIsLinearInTheTorqueAndZeroWithoutIt) {
  const RatedPair pair = rated(0.0);
  const MeshShafts shafts = shafts_of(-60, 90);
  const FaceDeflection one = face_deflection(pair, shafts, 3e5);
  const FaceDeflection two = face_deflection(pair, shafts, 6e5);
  EXPECT_NEAR(two.slope, 2 * one.slope, 1e-12 * std::abs(two.slope));
  EXPECT_NEAR(two.bow, 2 * one.bow, 1e-12 * std::abs(two.bow));
  const FaceDeflection none = face_deflection(pair, shafts, 0.0);
  EXPECT_EQ(none.slope, 0.0);
  EXPECT_EQ(none.bow, 0.0);
}

TEST(ProposedFlanks, SlopeIsTheDeflectionOnAWiderFace) {
  const LeadProposal same = propose_lead({0.012, 0.0}, 0.0, 30, 30);
  EXPECT_DOUBLE_EQ(same.slope, 0.012);
  EXPECT_EQ(same.crowning, 0.0);
  EXPECT_DOUBLE_EQ(propose_lead({-0.012, 0.0}, 0.0, 45, 30).slope, -0.018);
  EXPECT_FALSE(propose_lead({}, 0.0, 30, 30).any());
}

// [T12.32]: a flank with crowning C touches a plane that is askew by F over the face at the height
// F b/(8 C), which is a quarter of the face off its middle.
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
  // A bow of the shafts that opens the gap in the middle needs as much more, the opposite less.
  EXPECT_DOUBLE_EQ(propose_lead({0.0, -0.004}, kF, kFace, kFace).crowning, 0.012);
  EXPECT_DOUBLE_EQ(propose_lead({0.0, 0.005}, kF, kFace, kFace).crowning, 0.003);
  EXPECT_EQ(propose_lead({0.0, 0.02}, kF, kFace, kFace).crowning, 0.0);
  EXPECT_DOUBLE_EQ(propose_lead({}, kF, 2 * kFace, kFace).crowning, 0.032);
}

}  // namespace
}  // namespace gearwright
