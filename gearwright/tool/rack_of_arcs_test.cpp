// Tests the laws of cutter_edge.hpp for racks of every kind.
#include "gearwright/tool/rack_of_arcs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/tool/rack.hpp"

namespace gearwright {
namespace {

const EdgeCircle& circle_of(const EdgeArc& arc) { return std::get<EdgeCircle>(arc.shape); }

Vec2 on(const EdgeCircle& c, double tau) {
  return c.center + c.q * Vec2(std::sin(tau), std::cos(tau));
}

ArcRack rack_F() {
  ArcRack rack = default_arc_rack(ArcRack::Cutter::F);
  rack.center_a = 0.43;
  rack.center_b = 0.25;
  return rack;
}

ArcRack rack_P() {
  ArcRack rack = default_arc_rack(ArcRack::Cutter::P);
  rack.arc_radius = 1.55;
  rack.center_a = 0.55;
  rack.center_b = 0.32;
  return rack;
}

RackOfArcs made(const Result<RackOfArcs>& rack) {
  EXPECT_TRUE(rack) << rack.error().message();
  return *rack;
}

std::vector<RackOfArcs> racks_of_arcs() {
  ArcRack sharp_F = rack_F(), sharp_P = rack_P(), flat = rack_F();
  sharp_F.root_fillet_radius = 0.0;
  sharp_F.dedendum = 0.2;
  sharp_P.root_fillet_radius = 0.0;
  flat.arc_radius = 1.1;
  flat.center_a = -0.1;  // the arcs of both sides end at a land, at 90°
  flat.addendum = 0.8;
  ArcRack low = rack_P();
  low.center_b = -0.1;
  low.dedendum = 0.8;
  low.addendum = -0.2;
  std::vector<RackOfArcs> all{made(arcs_of(DoubleArcRack{})), made(arcs_of(*gbt12759_rack(12.0)))};
  for (const ArcRack& rack : {rack_F(), rack_P(), sharp_F, sharp_P, flat, low}) {
    all.push_back(made(arcs_of(rack)));
    EXPECT_EQ(all.back().addendum, rack.addendum);
    EXPECT_EQ(all.back().dedendum, rack.dedendum);
  }
  return all;
}

TEST(RackOfArcs, edges_obey_the_laws_of_an_edge) {
  for (const double m : {0.5, 2.0, 7.0}) {
    for (const double allowance : {0.0, -0.02}) {
      for (const RackOfArcs& rack : racks_of_arcs()) {
        const auto edge = make_edge(rack, m, allowance * m);
        ASSERT_TRUE(edge) << edge.error().message();
        EXPECT_EQ(edge->tip_depth, rack.dedendum * m);
        EXPECT_LE(edge->tip_land_end, kPi * m / 2);
        Vec2 last(-edge->tip_depth, edge->tip_land_end);
        double last_tau = kPi / 2;
        for (const EdgeArc& arc : edge->arcs) {
          ASSERT_TRUE(std::holds_alternative<EdgeCircle>(arc.shape));
          const EdgeCircle& c = circle_of(arc);
          const double begin_tau = c.begin_tau.rad(), end_tau = c.end_tau.rad();
          const Vec2 begin = on(c, begin_tau), end = on(c, end_tau);
          EXPECT_NEAR((begin - last).norm(), 0.0, 4e-15 * m);  // (1)
          EXPECT_EQ(arc.smooth_start, std::abs(begin_tau - last_tau) < 1e-12);
          if (!arc.smooth_start) {  // a convex corner has an arc
            EXPECT_GT(begin_tau, last_tau);
          }
          EXPECT_GT(end_tau, 0.0);  // (2)
          EXPECT_LE(begin_tau, kPi / 2);
          EXPECT_GE(end.x(), begin.x());  // (3)
          EXPECT_LE(end.y(), begin.y());  // (4)
          EXPECT_GE(end.y(), -1e-15 * m);
          last = end;
          last_tau = end_tau;
        }
        EXPECT_NEAR(last.x(), edge->bottom_height, 1e-15 * m);
        EXPECT_GE(edge->bottom_height, rack.addendum * m);
      }
    }
  }
}

// A thickness allowance moves each side of the tooth by half of the allowance and changes nothing
// else.
TEST(RackOfArcs, allowance_thins_the_tooth) {
  const RackOfArcs rack = *arcs_of(rack_F());
  const auto full = make_edge(rack, 2.0, 0.0);
  const auto thin = make_edge(rack, 2.0, -0.1);
  for (std::size_t i = 0; i < full->arcs.size(); ++i) {
    const Vec2 moved = circle_of(thin->arcs[i]).center - circle_of(full->arcs[i]).center;
    EXPECT_EQ(moved.x(), 0.0);
    EXPECT_NEAR(moved.y(), -0.05, 1e-15);
  }
  EXPECT_NEAR(thin->tip_land_end, full->tip_land_end - 0.05, 1e-15);
}

// Ends that differ by the rounding of a drawing are joined. Convex corners of the cutter get an arc
// of radius 0, and concave corners get no arc.
TEST(RackOfArcs, joints_and_corners) {
  const auto deg = [](double v) { return Angle::degrees(v); };
  RackOfArcs rack{0.0, 1.0, {}};
  RackArc first{ArcName::flank, 0.0, 2.0, -1.4, deg(45), deg(20), true};
  first.center_height = -1.0 + 1.4 * std::sin(deg(45).rad()) + 3e-7;
  const Vec2 end = point_at(first, deg(20));
  RackArc second{ArcName::flank, 0.0, 0.0, 1.5, deg(12), deg(50), true};
  second.center_height = end.x() - 1.5 * std::sin(deg(12).rad()) - 4e-7;
  second.center_offset = end.y() - 1.5 * std::cos(deg(12).rad()) + 4e-7;
  rack.arcs = {first, second};
  const auto edge = make_edge(rack, 1.0, 0.0);
  ASSERT_TRUE(edge) << edge.error().message();
  // The arcs are the corner of the tip from 90° to 45°, the first flank arc, the corner from 20° to
  // 12° and the second flank arc.
  ASSERT_EQ(edge->arcs.size(), 4u);
  EXPECT_EQ(circle_of(edge->arcs[0]).q, 0.0);
  EXPECT_EQ(edge->arcs[0].cuts, ArcName::root_fillet);
  EXPECT_EQ(circle_of(edge->arcs[2]).q, 0.0);
  EXPECT_NEAR(circle_of(edge->arcs[2]).begin_tau.rad(), deg(20).rad(), 1e-15);
  EXPECT_NEAR(circle_of(edge->arcs[2]).end_tau.rad(), deg(12).rad(), 1e-15);
  const Vec2 corner = circle_of(edge->arcs[2]).center;
  EXPECT_NEAR((on(circle_of(edge->arcs[3]), deg(12).rad()) - corner).norm(), 0.0, 1e-15);
  rack.arcs[1].begin = deg(25);
  rack.arcs[1].center_height = end.x() - 1.5 * std::sin(deg(25).rad());
  rack.arcs[1].center_offset = end.y() - 1.5 * std::cos(deg(25).rad());
  const auto hollow = make_edge(rack, 1.0, 0.0);
  ASSERT_TRUE(hollow) << hollow.error().message();
  EXPECT_EQ(hollow->arcs.size(), 3u);
  EXPECT_FALSE(hollow->arcs[2].smooth_start);
}

TEST(RackOfArcs, half_thickness_where_an_arc_crosses_the_datum_line) {
  // The arc crosses the datum line at the distance ρ cos θ − a, where sin θ = b/ρ. For F, this
  // distance is half the thickness. For P, it is half the width of the space, so half the thickness
  // is π/2 minus this distance.
  EXPECT_NEAR(*half_thickness_on_datum(*arcs_of(rack_F())), std::sqrt(1.4 * 1.4 - 0.0625) - 0.43,
              1e-15);
  EXPECT_NEAR(*half_thickness_on_datum(*arcs_of(rack_P())),
              kPi / 2 + 0.55 - std::sqrt(1.55 * 1.55 - 0.32 * 0.32), 1e-15);
  ArcRack low = rack_P();
  low.center_b = -0.1;
  low.dedendum = 0.8;
  low.addendum = -0.2;
  EXPECT_FALSE(half_thickness_on_datum(*arcs_of(low)));
}

TEST(RackOfArcs, what_is_no_edge_is_named) {
  const RackOfArcs sound = *arcs_of(rack_F());
  const auto key = [&](auto change) {
    RackOfArcs rack = sound;
    change(rack);
    const auto edge = make_edge(rack, 2.0, 0.0);
    if (edge) return std::string("made");
    EXPECT_NE(edge.error().message().find(edge.error().field), std::string::npos);
    return edge.error().field;
  };
  EXPECT_EQ(key([](RackOfArcs&) {}), "made");
  EXPECT_EQ(key([](RackOfArcs& r) { r.arcs.clear(); }), "rack.arcs");
  EXPECT_EQ(key([](RackOfArcs& r) { r.arcs.pop_back(); }), "rack.arcs");
  EXPECT_EQ(key([](RackOfArcs& r) { r.addendum = 1.2; }), "rack.addendum");
  EXPECT_EQ(key([](RackOfArcs& r) { r.dedendum = -1.0; }), "rack.dedendum");
  EXPECT_EQ(key([](RackOfArcs& r) { r.dedendum += 0.1; }), "rack.arcs[1]");
  EXPECT_EQ(key([](RackOfArcs& r) { r.arcs[1].center_height += 1e-3; }), "rack.arcs[2]");
  EXPECT_EQ(key([](RackOfArcs& r) { r.arcs[1].radius = -1.4; }), "rack.arcs[2]");
  EXPECT_EQ(key([](RackOfArcs& r) { r.arcs[1].end = Angle::degrees(100); }), "rack.arcs[2]");
  EXPECT_EQ(key([](RackOfArcs& r) { r.arcs[0].begin = Angle::degrees(0); }), "rack.arcs[1]");
  EXPECT_EQ(key([](RackOfArcs& r) { r.arcs[0].radius = 1e300; }), "rack.arcs[1]");
  // The two sides overlap, once at the cutter's tip and once in the gear's tooth.
  EXPECT_EQ(key([](RackOfArcs& r) {
              for (RackArc& arc : r.arcs) arc.center_offset += 0.5;
            }),
            "rack.dedendum");
  EXPECT_EQ(key([](RackOfArcs& r) {
              for (RackArc& arc : r.arcs) arc.center_offset -= 0.5;
            }),
            "rack.addendum");
}

}  // namespace
}  // namespace gearwright
