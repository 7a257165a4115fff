#include "gearwright/cad/walls.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

using testing::plain_body;
using testing::sample_body;

std::size_t count(const WallLoop& loop, WallShape shape) {
  std::size_t n = 0;
  for (const Wall& wall : loop.walls) n += wall.shape == shape ? 1 : 0;
  return n;
}

// Each wall starts at the end of the previous one, except for rounding, and the loop turns once
// about the axis.
void expect_closed(const WallLoop& loop, double radius) {
  double turn = 0.0;
  for (std::size_t i = 0; i < loop.walls.size(); ++i) {
    const Wall& wall = loop.walls[i];
    const Wall& next = loop.walls[(i + 1) % loop.walls.size()];
    EXPECT_LE(std::abs(wall.end - next.begin), 1e-14 * radius) << i;
    if (wall.shape == WallShape::spline) {
      EXPECT_EQ(wall.poles.front(), wall.begin) << i;
      EXPECT_EQ(wall.poles.back(), wall.end) << i;
    }
    if (wall.shape == WallShape::circle) {
      EXPECT_LE(std::abs(std::polar(wall.radius, wall.begin_angle) - wall.begin), 2e-14 * radius);
      EXPECT_LE(std::abs(std::polar(wall.radius, wall.end_angle) - wall.end), 2e-14 * radius);
      turn += wall.end_angle - wall.begin_angle;
    } else {
      turn += std::arg(wall.end / wall.begin);
    }
  }
  EXPECT_NEAR(turn, 2.0 * kPi, 1e-12);
}

TEST(Walls, LandsMergeAndFlanksDoNot) {
  const auto walls = make_walls(sample_body({.teeth = 20}));
  ASSERT_TRUE(walls);
  EXPECT_EQ(count(walls->teeth, WallShape::circle), 40u);  // a tip and a root land per tooth
  EXPECT_EQ(count(walls->teeth, WallShape::spline), 80u);  // two flanks, two fillets
  expect_closed(walls->teeth, 22.0);
}

TEST(Walls, PointedToothAndFullRadiusRootHaveNoLands) {
  const auto walls = make_walls(sample_body({.pointed = true, .full_radius_root = true}));
  ASSERT_TRUE(walls);
  EXPECT_EQ(walls->teeth.walls.size(), 80u);
  EXPECT_EQ(count(walls->teeth, WallShape::circle), 0u);
  expect_closed(walls->teeth, 24.0);
}

TEST(Walls, QuarterTeethAreExactQuarterTurns) {
  const auto walls = make_walls(sample_body({.teeth = 20}));
  ASSERT_TRUE(walls);
  const auto& w = walls->teeth.walls;
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(w[30 + i].begin, w[i].begin * Complex(0.0, 1.0));
    EXPECT_EQ(w[60 + i].begin, -w[i].begin);
  }
}

TEST(Walls, SliversGiveNoWalls) {
  // Half a tip land would be 0.8e-6 mm long, so it is omitted, and the flanks meet on the centre
  // line of the tooth.
  const auto tip = make_walls(plain_body(12, 20.0, 0.2, 25.0, 0.8e-6 / 25.0));
  ASSERT_TRUE(tip);
  EXPECT_EQ(tip->teeth.walls.size(), 36u);  // two flanks and a root land per tooth
  EXPECT_EQ(tip->teeth.walls[0].end.imag(), 0.0);
  expect_closed(tip->teeth, 25.0);
  const auto root = make_walls(plain_body(12, 20.0, kPi / 12 - 0.8e-6 / 20.0, 25.0, 0.08));
  ASSERT_TRUE(root);
  EXPECT_EQ(root->teeth.walls.size(), 36u);
  expect_closed(root->teeth, 25.0);
  // If the length is just above the limit, both lands remain.
  const auto both = make_walls(plain_body(12, 20.0, 0.2, 25.0, 1.2e-6 / 25.0));
  ASSERT_TRUE(both);
  EXPECT_EQ(both->teeth.walls.size(), 48u);
}

TEST(Walls, SliverBetweenArcsJoinsItsNeighbours) {
  auto body = sample_body({});
  Outline& outline = body.outline;
  const Vec2 at = outline.arcs[1].end_point;
  const Vec2 to = at + Vec2(0.5e-6, 0.0);
  outline.arcs.insert(outline.arcs.begin() + 2,
                      {ArcName::root_fillet,
                       std::make_shared<testing::SampleLine>(testing::C(at.x(), at.y()),
                                                             testing::C(to.x(), to.y())),
                       0.0, 1.0, at, to});
  const auto walls = make_walls(body);
  ASSERT_TRUE(walls);
  EXPECT_EQ(walls->teeth.walls.size(), 120u);
  EXPECT_EQ(walls->arcs.size(), 4u);
  expect_closed(walls->teeth, 22.0);
}

TEST(Walls, SlicesKeepTurnsBelowAHalf) {
  // The widest circle spans only 2(π/12 − 0.2), so the number of slices depends on the turn alone.
  const double most = kPi;
  for (const double turn : {0.0, 0.99, 1.01, 7.5}) {
    const auto walls = make_walls(plain_body(12, 20.0, 0.2, 25.0, 0.08, 10.0, -turn * most / 10.0));
    ASSERT_TRUE(walls);
    EXPECT_EQ(walls->teeth.slices, std::max(1, static_cast<int>(std::ceil(turn))));
    EXPECT_EQ(walls->teeth.walls.size(), 48u);
  }
  // The root land of the single tooth spans 0.9 π, which leaves 0.6 π for the turn.
  const auto one = make_walls(plain_body(1, 20.0, 0.55 * kPi, 25.0, 0.3, 10.0, kPi / 10.0));
  ASSERT_TRUE(one);
  EXPECT_EQ(one->teeth.slices, 2);
}

TEST(Walls, LandWiderThanHalfATurnIsTwoWalls) {
  const auto walls = make_walls(plain_body(1, 20.0, 0.4, 25.0, 0.3));
  ASSERT_TRUE(walls);
  EXPECT_EQ(count(walls->teeth, WallShape::circle), 3u);  // the tip land, two halves of the root
  EXPECT_EQ(count(walls->teeth, WallShape::spline), 2u);
  expect_closed(walls->teeth, 25.0);
}

TEST(Walls, BoreKeywayAndRim) {
  auto body = sample_body({});
  body.bore = Bore{20.0};
  EXPECT_EQ(make_walls(body)->bore->walls.size(), 1u);
  body.bore = Bore{20.0, 6.0, 2.8};
  const auto keyed = make_walls(body);
  ASSERT_TRUE(keyed);
  ASSERT_EQ(keyed->bore->walls.size(), 4u);
  EXPECT_EQ(keyed->bore->walls[2].begin, Complex(3.0, 12.8));
  EXPECT_EQ(keyed->bore->walls[2].end, Complex(-3.0, 12.8));
  expect_closed(*keyed->bore, 13.0);

  auto ring = plain_body(-12, 25.0, 0.2, 20.0, 0.08);
  ring.bore = Bore{60.0};
  const auto rim = make_walls(ring);
  ASSERT_TRUE(rim);
  expect_closed(*rim->bore, 30.0);
  expect_closed(rim->teeth, 25.0);
}

TEST(Walls, RefusesWhatIsNoBody) {
  auto body = plain_body(12, 20.0, 0.2, 25.0, 0.08);
  body.bore = Bore{40.0};
  EXPECT_EQ(make_walls(body).error().field, "bore.diameter");
  EXPECT_EQ(make_walls(body).error().value, "40");
  body.bore = Bore{36.0, 10.0, 2.0};  // the corner: hypot(5, 20) > 20
  EXPECT_EQ(make_walls(body).error().field, "bore.diameter");
  body.bore = Bore{34.0, 10.0, 2.0};
  EXPECT_TRUE(make_walls(body));
  body.bore = Bore{10.0, 10.0, 2.0};
  EXPECT_EQ(make_walls(body).error().field, "bore.keyway_width");
  auto ring = plain_body(-12, 25.0, 0.2, 20.0, 0.08);
  EXPECT_EQ(make_walls(ring).error().field, "bore.diameter");
  ring.bore = Bore{50.0};
  EXPECT_EQ(make_walls(ring).error().field, "bore.diameter");

  // The outline crosses the centre line of the tooth, or the centre line of the space.
  EXPECT_EQ(make_walls(plain_body(12, 20.0, -0.01, 25.0, 0.08)).error().field, "teeth");
  EXPECT_EQ(make_walls(plain_body(12, 20.0, 0.30, 25.0, 0.08)).error().field, "teeth");
}

// The flank has a jump of 0.01 mm in its middle, so no spline can approximate it.
class Torn final : public testing::ComplexCurve {
 public:
  Jet jet(double t) const override {
    return {testing::C(20.0 + 5.0 * t, t < 0.5 ? 2.0 : 2.01), 5.0, 0.0};
  }
};

TEST(Walls, RefusesAnArcThatNoSplineMeets) {
  Outline outline{12, {}};
  const double radius = std::hypot(20.0, 2.0);
  const double tip = std::hypot(25.0, 2.01);
  testing::append(outline, ArcName::root_land, std::make_shared<testing::SampleCircle>(radius),
                  kPi / 12, std::atan2(2.0, 20.0));
  testing::append(outline, ArcName::flank, std::make_shared<Torn>(), 0.0, 1.0);
  testing::append(outline, ArcName::tip_land, std::make_shared<testing::SampleCircle>(tip),
                  std::atan2(2.01, 25.0), 0.0);
  const auto walls = make_walls({"torn", outline, 0.0, 10.0, std::nullopt, {}});
  ASSERT_FALSE(walls);
  EXPECT_NE(walls.error().message().find("the best spline for the flank deviates by "),
            std::string::npos);
}

}  // namespace
}  // namespace gearwright
