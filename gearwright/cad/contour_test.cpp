#include "gearwright/cad/contour.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/violation.hpp"
#include "gearwright/cad/testing/odd_outlines.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

struct ContourCase {
  const char* what;
  ToothedBody body;
  std::size_t pieces_per_tooth;
};

std::vector<ContourCase> contour_cases() {
  return {{"spur", testing::sample_body({}), 6},
          {"chamfer", testing::sample_body({.chamfer = 0.3}), 8},
          {"pointed", testing::sample_body({.pointed = true}), 5},
          {"full root", testing::sample_body({.full_radius_root = true}), 5},
          {"both", testing::sample_body({.pointed = true, .full_radius_root = true}), 4},
          {"undercut", testing::undercut_body(8, 2.0, 1.25, 0.8, 0.0, 10.0), 6},
          {"one", testing::few_tooth_body(1, 5.0, 0.0, 10.0), 6},
          {"two", testing::few_tooth_body(2, 5.0, 0.0, 10.0), 6},
          {"ring", testing::ring_body(40, 2.0, 0.0, 10.0, 100.0), 4}};
}

Contour contour_of(const Outline& outline) {
  const auto contour = closed_contour(outline);
  EXPECT_TRUE(static_cast<bool>(contour));
  return *contour;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

TEST(Contour, PiecesAreChainedBitForBit) {  // law 1
  for (const ContourCase& c : contour_cases()) {
    const Contour contour = contour_of(c.body.outline);
    const auto& pieces = contour.pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      EXPECT_EQ(pieces[i].end, pieces[(i + 1) % pieces.size()].begin) << c.what << " " << i;
      EXPECT_NE(pieces[i].begin, pieces[i].end) << c.what << " " << i;
    }
  }
}

TEST(Contour, CountIsThatOfOneToothTimesTeeth) {  // laws 2, 3
  for (const ContourCase& c : contour_cases()) {
    const Contour contour = contour_of(c.body.outline);
    const auto z = static_cast<std::size_t>(std::abs(c.body.outline.teeth));
    EXPECT_EQ(contour.pieces.size(), z * c.pieces_per_tooth) << c.what;
  }
}

TEST(Contour, GoesOnceRoundCounterClockwise) {
  for (const ContourCase& c : contour_cases()) {
    double turn = 0.0;
    for (const ContourPiece& piece : contour_of(c.body.outline).pieces) {
      if (piece.land) {
        EXPECT_GT(piece.sweep, 0.0) << c.what;
        turn += piece.sweep;
      } else {
        turn += std::atan2(cross(piece.begin, piece.end), piece.begin.dot(piece.end));
      }
    }
    EXPECT_NEAR(turn, 2 * kPi, 1e-12) << c.what;
  }
}

TEST(Contour, LandsAreCirclesAboutTheAxis) {
  for (const ContourCase& c : contour_cases()) {
    for (const ContourPiece& piece : contour_of(c.body.outline).pieces) {
      if (!piece.land) continue;
      EXPECT_NEAR(piece.begin.norm(), piece.end.norm(), 1e-14 * piece.begin.norm()) << c.what;
      const double angle = std::atan2(cross(piece.begin, piece.end), piece.begin.dot(piece.end));
      EXPECT_NEAR(std::remainder(piece.sweep - angle, 2 * kPi), 0.0, 1e-13) << c.what;
    }
  }
  // A gear with a single tooth whose root land spans more than half a turn.
  const Contour one = contour_of(testing::plain_body(1, 10.0, 1.0, 14.0, 0.8).outline);
  EXPECT_NEAR(one.pieces[2].sweep, 2 * kPi - 2.0, 1e-15 * 10);
}

TEST(Contour, ToothKIsToothZeroTurned) {
  const ToothedBody body = testing::sample_body({});
  const Contour contour = contour_of(body.outline);
  for (int k = 0; k < 20; ++k) {
    const SinCos t = sincos_turn(k, 20);
    for (std::size_t i = 0; i < 3; ++i) {  // tip land and upper half
      const Vec2& p = contour.pieces[i].begin;
      const Vec2 q(t.cos * p.x() - t.sin * p.y(), t.sin * p.x() + t.cos * p.y());
      EXPECT_EQ(contour.pieces[static_cast<std::size_t>(6 * k) + i].begin, q);
    }
  }
  // Quarter turns are exact, so a point (x, y) of tooth 0 is (−y, x) on tooth 5 of 20.
  const Vec2 a = contour.pieces[1].begin;
  EXPECT_EQ(contour.pieces[31].begin, Vec2(-a.y(), a.x()));
}

TEST(Contour, PlacedPointsRunAsThePieceDoes) {
  const ToothedBody body = testing::sample_body({.beta = 0.2});
  const Contour contour = contour_of(body.outline);
  for (const ContourPiece& piece : contour.pieces) {
    if (piece.land) continue;
    const std::vector<Vec2> points =
        placed(contour, piece, sample(body.outline.arcs[piece.arc], 5));
    EXPECT_EQ(points.front(), piece.begin);
    EXPECT_EQ(points.back(), piece.end);
    // The contour runs upwards along the lower half and downwards along the upper half.
    for (std::size_t i = 1; i < points.size(); ++i) {
      EXPECT_EQ(points[i].norm() > points[i - 1].norm(), piece.mirrored);
    }
  }
}

TEST(Contour, SliversMakeNoPiece) {
  ToothedBody body = testing::sample_body({});
  const std::size_t whole = contour_of(body.outline).pieces.size();
  // A chamfer of 10 nm between flank and tip land.
  std::vector<Arc>& arcs = body.outline.arcs;
  const Arc land = arcs.back();
  const double radius = land.begin_point.norm();
  arcs.pop_back();
  const double angle = land.begin - 1e-8 / radius;
  testing::append(body.outline, ArcName::tip_fillet,
                  std::make_shared<testing::SampleCircle>(radius), land.begin, angle);
  testing::append(body.outline, ArcName::tip_land, land.curve, angle, 0.0);
  EXPECT_EQ(contour_of(body.outline).pieces.size(), whole);
}

TEST(Contour, ARoughLandIsAnOrdinaryArc) {
  // The tip "land" is a straight line, not a circle about the axis. Its two halves are therefore
  // two pieces, the arc and its mirror image.
  ToothedBody body = testing::plain_body(12, 20.0, 0.2, 24.0, 0.05);
  body.outline.arcs.pop_back();
  const Vec2 p = body.outline.arcs.back().end_point;
  testing::append(
      body.outline, ArcName::tip_land,
      std::make_shared<testing::SampleLine>(testing::C(p.x(), p.y()), testing::C(p.x(), 0.0)), 0.0,
      1.0);
  const Contour contour = contour_of(body.outline);
  EXPECT_EQ(contour.pieces.size(), 12U * 5U);
  EXPECT_FALSE(contour.pieces.front().land);
}

TEST(Contour, ASeveredToothIsAFact) {
  // Five teeth are cut two modules deep, so the path of the cutter's corner crosses the centre line
  // of the tooth.
  const ToothedBody deep = testing::undercut_body(5, 2.0, 2.0, 1.0, 0.0, 10.0);
  double lowest = 1.0;
  for (const Vec2& p : sample(*deep.outline.find(ArcName::root_fillet), 100)) {
    lowest = std::min(lowest, p.y());
  }
  ASSERT_LT(lowest, -0.01);
  for (const ToothedBody& body : {deep, testing::plain_body(12, 20.0, -0.02, 24.0, 0.05)}) {
    const auto contour = closed_contour(body.outline);
    ASSERT_FALSE(contour);
    EXPECT_EQ(contour.error().field, "teeth");
    EXPECT_EQ(contour.error().value, std::to_string(body.outline.teeth));
    EXPECT_NE(contour.error().message().find("crosses"), std::string::npos);
  }
}

TEST(ContourDeathTest, Contracts) {
  Outline gap = testing::sample_body({}).outline;
  gap.arcs[1].begin_point.x() += 1e-15 * gap.arcs[1].begin_point.x() * 4;
  GW_EXPECT_VIOLATION(static_cast<void>(closed_contour(gap)));
  Outline more = testing::sample_body({}).outline;
  more.teeth = 21;
  GW_EXPECT_VIOLATION(static_cast<void>(closed_contour(more)));
  GW_EXPECT_VIOLATION(static_cast<void>(closed_contour({0, more.arcs})));
}

}  // namespace
}  // namespace gearwright
