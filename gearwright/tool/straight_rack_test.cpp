// Tests the laws of cutter_edge.hpp for many racks that are given by their numbers.
#include "gearwright/tool/straight_rack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "gearwright/base/numbers.hpp"

namespace gearwright {
namespace {

using namespace literals;

struct EdgeEnd {
  double x, y, tau;
};

EdgeEnd begin_of(const EdgeArc& arc) {
  if (const auto* line = std::get_if<EdgeLine>(&arc.shape)) {
    const double tau = line->tau.rad();
    return {line->begin_height, line->y_datum - line->begin_height * std::tan(tau), tau};
  }
  const auto& c = std::get<EdgeCircle>(arc.shape);
  const double tau = c.begin_tau.rad();
  return {c.center.x() + c.q * std::sin(tau), c.center.y() + c.q * std::cos(tau), tau};
}

EdgeEnd end_of(const EdgeArc& arc) {
  if (const auto* line = std::get_if<EdgeLine>(&arc.shape)) {
    const double tau = line->tau.rad();
    return {line->end_height, line->y_datum - line->end_height * std::tan(tau), tau};
  }
  const auto& c = std::get<EdgeCircle>(arc.shape);
  const double tau = c.end_tau.rad();
  return {c.center.x() + c.q * std::sin(tau), c.center.y() + c.q * std::cos(tau), tau};
}

std::vector<StraightRack> straight_racks() {
  StraightRack sharp, round, chamfer, proud, slightly_proud, land;
  sharp.root_fillet_radius = 0.0;
  round.tip_fillet_radius = 0.2;
  chamfer.tool_addendum = 0.7;
  chamfer.semi_topping_angle = 45_deg;
  proud.dedendum = 1.4;
  proud.root_fillet_radius = 0.3;
  proud.protuberance = 0.05;
  slightly_proud = proud;
  slightly_proud.protuberance = 0.002;
  land.tool_addendum = 0.9;
  StraightRack full = proud;
  full.root_fillet_radius = full_radius(full, 20_deg);
  return {*iso53_rack("ISO53-A"),
          *iso53_rack("ISO53-D"),
          sharp,
          round,
          chamfer,
          proud,
          slightly_proud,
          land,
          full};
}

TEST(StraightRack, edges_obey_the_laws_of_an_edge) {
  for (const double m : {0.5, 2.0, 7.0}) {
    for (const StraightRack& rack : straight_racks()) {
      const auto made = make_edge(rack, m, 20_deg);
      ASSERT_TRUE(made) << made.error().message();
      const CutterEdge& edge = made->edge;
      EXPECT_EQ(edge.tip_depth, rack.dedendum * m);
      EdgeEnd last{-edge.tip_depth, edge.tip_land_end, kPi / 2};
      EXPECT_LE(last.y, kPi * m / 2);
      for (const EdgeArc& arc : edge.arcs) {
        const EdgeEnd begin = begin_of(arc), end = end_of(arc);
        EXPECT_NEAR(begin.x, last.x, 1e-14 * m);  // (1)
        EXPECT_NEAR(begin.y, last.y, 1e-14 * m);
        EXPECT_EQ(arc.smooth_start, std::abs(begin.tau - last.tau) < 1e-12);
        EXPECT_GT(end.tau, 0.0);  // (2)
        EXPECT_LE(end.tau, kPi / 2);
        EXPECT_GE(end.x, begin.x);  // (3)
        if (std::isfinite(end.x)) {
          EXPECT_GE(end.y, -1e-15 * m);  // (4)
          EXPECT_LE(end.y, begin.y);
        }
        last = end;
      }
      if (std::isfinite(edge.bottom_height)) {
        EXPECT_NEAR(last.x, edge.bottom_height, 1e-14 * m);
      }
    }
  }
}

TEST(StraightRack, flank_starts_where_iso_says) {
  for (const char* name : {"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D"}) {
    const StraightRack rack = *iso53_rack(name);
    const auto edge = make_edge(rack, 2.0, 20_deg);
    ASSERT_TRUE(edge);
    EXPECT_FALSE(edge->became_full_radius);
    const double h_Ff = rack.dedendum - rack.root_fillet_radius * (1 - std::sin(kPi / 9));
    EXPECT_NEAR(edge->edge.flank_begin_depth, 2 * h_Ff, 1e-15);
    EXPECT_NEAR(begin_of(edge->edge.arcs.back()).y, kPi / 2 + 2 * h_Ff * std::tan(kPi / 9), 4e-15);
  }
  EXPECT_FALSE(iso53_rack("ISO53-E"));
  EXPECT_FALSE(iso53_rack("iso53-a"));
}

// The rounding is a full radius if its centre is in the middle of the cutter's tooth. Dedendum,
// pressure angle and radius are then related by the known formula, and a slightly smaller radius
// leaves a tip land.
TEST(StraightRack, full_radius) {
  StraightRack rack;
  const double full = full_radius(rack, 20_deg);
  const double a = kPi / 9;
  EXPECT_NEAR(full, (kPi / 4 - 1.25 * std::tan(a)) * std::cos(a) / (1 - std::sin(a)), 1e-15);
  rack.root_fillet_radius = full;
  EXPECT_EQ(make_edge(rack, 3.0, 20_deg)->edge.tip_land_end, kPi * 3.0 / 2);
  rack.root_fillet_radius = full - 1e-3;
  EXPECT_LT(make_edge(rack, 3.0, 20_deg)->edge.tip_land_end, kPi * 3.0 / 2 - 1e-3);
}

TEST(StraightRack, a_named_radius_that_does_not_fit_becomes_full) {
  const StraightRack rack = *iso53_rack("ISO53-A");
  ASSERT_LT(full_radius(rack, 30_deg), 0.38);
  const auto made = make_edge(rack, 1.0, 30_deg);
  ASSERT_TRUE(made);
  EXPECT_TRUE(made->became_full_radius);
  EXPECT_EQ(made->edge.tip_land_end, kPi / 2);
}

// Where the normal of the protuberance is parallel to the normal of the flank, the protuberance
// projects by pr beyond the extended flank. This holds for a protuberance with a straight line and
// for one that consists of the rounding only.
TEST(StraightRack, protuberance_stands_proud) {
  for (const double pr : {0.002, 0.05}) {
    StraightRack rack;
    rack.dedendum = 1.4;
    rack.root_fillet_radius = 0.3;
    rack.protuberance = pr;
    const auto made = make_edge(rack, 1.0, 20_deg);
    ASSERT_TRUE(made);
    const auto& tip = std::get<EdgeCircle>(made->edge.arcs.front().shape);
    const auto& flank = std::get<EdgeLine>(made->edge.arcs.back().shape);
    const double a = kPi / 9;
    const double beyond = (tip.center.y() + tip.q * std::cos(a) - flank.y_datum) * std::cos(a) +
                          (tip.center.x() + tip.q * std::sin(a)) * std::sin(a);
    EXPECT_NEAR(beyond, -pr, 1e-15);
    EXPECT_EQ(made->edge.arcs.size(), pr < 0.01 ? 2u : 3u);
    if (pr < 0.01) {
      EXPECT_GT(tip.end_tau, rack.protuberance_angle);
    }
  }
}

TEST(StraightRack, what_is_impossible_is_named) {
  const auto key = [](auto change, Angle alpha = 20_deg) {
    StraightRack rack;
    change(rack);
    const auto made = make_edge(rack, 2.0, alpha);
    if (made) return std::string("made");
    EXPECT_NE(made.error().message().find(made.error().field), std::string::npos);
    EXPECT_FALSE(made.error().value.empty());
    return made.error().field;
  };
  EXPECT_EQ(key([](StraightRack&) {}), "made");
  EXPECT_EQ(key([](StraightRack& r) { r.addendum = -0.1; }), "rack.addendum");
  EXPECT_EQ(key([](StraightRack& r) { r.dedendum = 0.0; }), "rack.dedendum");
  EXPECT_EQ(key([](StraightRack& r) { r.dedendum = 3.0; }), "rack.dedendum");
  EXPECT_EQ(key([](StraightRack& r) { r.root_fillet_radius = -1.0; }), "rack.root_fillet_radius");
  EXPECT_EQ(key([](StraightRack& r) { r.root_fillet_radius = 0.6; }), "rack.root_fillet_radius");
  EXPECT_EQ(key([](StraightRack& r) { r.tip_fillet_radius = -1.0; }), "rack.tip_fillet_radius");
  EXPECT_EQ(key([](StraightRack& r) { r.tip_fillet_radius = 1.0; }), "rack.tip_fillet_radius");
  EXPECT_EQ(key([](StraightRack& r) { r.tool_addendum = 2.5; }), "rack.tool_addendum");
  EXPECT_EQ(key([](StraightRack& r) { r.tool_addendum = -1.3; }), "rack.tool_addendum");
  EXPECT_EQ(key([](StraightRack& r) { r.protuberance = -0.1; }), "rack.protuberance");
  EXPECT_EQ(key([](StraightRack& r) {
              r.protuberance = 0.1;
              r.protuberance_angle = 25_deg;
            }),
            "rack.protuberance_angle");
  // If the angle of the protuberance is close to the pressure angle of the flank, the line of the
  // protuberance extends past the end of the flank.
  EXPECT_EQ(key([](StraightRack& r) {
              r.protuberance = 0.1;
              r.protuberance_angle = 19.5_deg;
            }),
            "rack.protuberance");
  EXPECT_EQ(key([](StraightRack& r) { r.semi_topping_angle = 45_deg; }), "rack.semi_topping_angle");
  EXPECT_EQ(key([](StraightRack& r) {
              r.semi_topping_angle = 15_deg;
              r.tool_addendum = 0.7;
            }),
            "rack.semi_topping_angle");
  EXPECT_EQ(key([](StraightRack& r) {
              r.semi_topping_angle = 45_deg;
              r.tool_addendum = 0.7;
              r.tip_fillet_radius = 0.1;
            }),
            "rack.semi_topping_angle");
}

TEST(StraightRack, the_limits_named_are_the_limits) {
  StraightRack rack;
  rack.root_fillet_radius = full_radius(rack, 20_deg);
  EXPECT_TRUE(make_edge(rack, 2.0, 20_deg));
  rack.root_fillet_radius *= 1 + 1e-12;
  EXPECT_FALSE(make_edge(rack, 2.0, 20_deg));
  StraightRack high;
  high.tool_addendum = kPi / 4 / std::tan(kPi / 9) * (1 - 1e-12);
  EXPECT_TRUE(make_edge(high, 2.0, 20_deg));
  high.tool_addendum = *high.tool_addendum * (1 + 1e-11);
  EXPECT_FALSE(make_edge(high, 2.0, 20_deg));
}

}  // namespace
}  // namespace gearwright
