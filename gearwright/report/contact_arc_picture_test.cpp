#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/report/pair_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/report/testing/chain_distance.hpp"
#include "gearwright/tool/double_arc_rack.hpp"

namespace gearwright {
namespace {

Gear arc_gear(int teeth, double module, double helix_deg, const Rack& rack, double face) {
  CylindricalSpec spec = testing::plain_spec(
      {.teeth = teeth, .module = module, .beta_deg = helix_deg, .face_width = face});
  spec.rack = rack;
  auto gear = make_gear(spec);
  GW_EXPECTS(static_cast<bool>(gear));
  return std::move(gear).take();
}

ArcPair litvin_tsay_pair() {
  ArcRack F = default_arc_rack(ArcRack::Cutter::F);
  F.cutter = ArcRack::Cutter::F;
  F.arc_radius = 1.4;
  F.center_a = 0.4224355652982141;
  F.center_b = 0.24389328734019564;
  ArcRack P = default_arc_rack(ArcRack::Cutter::P);
  P.cutter = ArcRack::Cutter::P;
  P.arc_radius = 1.55;
  P.center_a = 0.5523393758658799;
  P.center_b = 0.31889328734019567;
  auto pair =
      mount_arcs(arc_gear(12, 12.7, 15, F, 180), arc_gear(94, 12.7, -15, P, 180), std::nullopt);
  GW_EXPECTS(static_cast<bool>(pair));
  return std::move(pair).take();
}

// M = (0.456106, 0.79) modules lies on both racks of the paper.
TEST(ArcPicture, BothRacksPassTheirContactPoint) {
  const ArcPair pair = litvin_tsay_pair();
  const double m = 12.7;
  const Vec2 M(0.45610671265980433 * m, 0.79 * m);
  // Arcs with a radius of 1.4 modules are divided into 32 chords, which deviate by less than 3e-4
  // modules.
  EXPECT_LT(testing::chain_distance(rack_half_tooth(pair.gears[0]), M), 3e-4 * m);
  const double half_pitch = 3.14159265358979323846 * m / 2;
  EXPECT_LT(testing::chain_distance(rack_half_tooth(pair.gears[1]), {-M.x(), half_pitch - M.y()}),
            3e-4 * m);
}

TEST(ArcPicture, ARackReachesFromItsDedendumToItsAddendum) {
  const ArcPair pair = litvin_tsay_pair();
  for (const Gear& gear : pair.gears) {
    const auto half = rack_half_tooth(gear);
    const double m = gear.spec.normal_module;
    EXPECT_NEAR(half.front().x(), -dedendum_of(gear.spec.rack) * m, 1e-12);
    EXPECT_NEAR(half.front().y(), 3.14159265358979323846 * m / 2, 1e-12);
    EXPECT_NEAR(half.back().x(), addendum_of(gear.spec.rack) * m, 1e-12);
    EXPECT_EQ(half.back().y(), 0.0);
    for (std::size_t i = 1; i < half.size(); ++i) EXPECT_GE(half[i].x(), half[i - 1].x() - 1e-9);
  }
}

// The plane of the picture contains the contact point. Both sections therefore pass through this
// point, where they are tangent to each other. A point on the normal slightly beyond the contact
// lies outside one section and has not yet reached the other section.
TEST(ArcPicture, BothTeethPassTheContactPointInTheNormalSection) {
  std::vector<ArcPair> pairs{litvin_tsay_pair()};
  const auto rack = gbt12759_rack(4.0);
  ASSERT_TRUE(static_cast<bool>(rack));
  auto made =
      mount_arcs(arc_gear(18, 4, -20, *rack, 60), arc_gear(50, 4, 20, *rack, 60), std::nullopt);
  ASSERT_TRUE(static_cast<bool>(made));
  pairs.push_back(*made);
  for (const ArcPair& pair : pairs) {
    for (const ArcPairContact& contact : pair.contacts) {
      const double m = pair.gears[0].spec.normal_module;
      const NormalPlane plane = normal_plane(pair, contact);
      EXPECT_NEAR(plane.along.dot(contact.at.normal), 0.0, 1e-9);
      for (const std::size_t i : {0u, 1u})
        EXPECT_LT(testing::chain_distance(normal_section(pair, contact, i, 1), Vec2::Zero()),
                  2e-4 * m)
            << i;
    }
  }
}

TEST(ArcPicture, TwoFiguresThatNameThePressureAngle) {
  const std::vector<Figure> figures = arc_contact_figures(litvin_tsay_pair());
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_NE(figures[0].caption.find("30.000°"), std::string::npos);
  EXPECT_EQ(figures[0].id, "racks");
  EXPECT_EQ(figures[1].id, "arc-teeth");
}

}  // namespace
}  // namespace gearwright
