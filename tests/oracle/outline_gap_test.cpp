// The gap of two outlines against polygons of both gears, which share no code with it, over random
// mounted pairs with everything that shapes a tooth.
//
//   free     turned to the ends of the true play, and in its middle, polygons of 64 positions of a
//            pitch share no area
//   tight    where a touch is said to be, both outlines have a point, to a nanometre: a little more
//            of a turn, and they overlap
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "gearwright/pair/outline_gap.hpp"
#include "tests/oracle/random_mounted_pair.hpp"
#include "tests/oracle/toothed_outline.hpp"
#include "tests/oracle/turned_polygons.hpp"

namespace gearwright::oracle {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kChord = 2e-7;   // mm, from the outline to the polygon
constexpr double kShared = 1e-6;  // mm²: the chords of a tooth's height, with room
constexpr double kTight = 1e-9;   // mm
constexpr int kPositions = 64;
constexpr int kLines = 1000;

void add_points(const Arc& arc, double u, double v, const Vec2& p, const Vec2& q, int depth,
                std::vector<Eigen::Vector2d>& points) {
  const double middle = 0.5 * (u + v);
  const Vec2 m = arc.point(middle);
  if (depth > 14 || (depth > 3 && (m - 0.5 * (p + q)).norm() < kChord)) {
    points.push_back(q);
    return;
  }
  add_points(arc, u, middle, p, m, depth + 1, points);
  add_points(arc, middle, v, m, q, depth + 1, points);
}

ToothedPolygon polygon_of(const Outline& outline) {
  ToothedPolygon polygon{outline.teeth, {outline.arcs.front().begin_point}};
  for (const Arc& arc : outline.arcs)
    add_points(arc, 0.0, 1.0, arc.begin_point, arc.end_point, 0, polygon.half_tooth);
  return polygon;
}

class Material {
 public:
  explicit Material(const Outline& outline)
      : sign_(outline.teeth < 0 ? -1.0 : 1.0),
        outline_(std::abs(outline.teeth), curves_of(outline)) {}
  double distance(const Vec2& q) const { return sign_ * outline_.distance(q); }

 private:
  static std::vector<ToothedOutline::Curve> curves_of(const Outline& outline) {
    std::vector<ToothedOutline::Curve> curves;
    for (const Arc& arc : outline.arcs)
      curves.push_back([&arc](double u) -> Eigen::Vector2d { return arc.point(u); });
    return curves;
  }

  double sign_;
  ToothedOutline outline_;
};

Vec2 turned(const Vec2& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

struct Run {
  int pairs = 0, overlap = 0, within_play = 0, rough = 0;
};

void expect_tight(const InvolutePair& pair, const OutlineGap& gap, const std::string& text,
                  Run& run) {
  const Outline& one = pair.gears[0].tooth->outline;
  const Outline& two = pair.gears[1].tooth->outline;
  try {
    const Material first(one), second(two);
    const bool ring = two.teeth < 0;
    const double ratio = static_cast<double>(one.teeth) / std::abs(two.teeth);
    for (const auto& row : gap.touches) {
      for (const auto& touch : row) {
        if (!touch) continue;
        // At rest as in [T1.5]; counter-clockwise by −rotation_1, gear 2 as it rolls and by turn_2.
        const double phi = -touch->rotation_1;
        const Vec2 q_1 = turned(ring ? Vec2(-touch->point) : touch->point, -phi);
        const double rest = kPi - kPi / std::abs(two.teeth);
        const double phi_2 = (ring ? ratio : -ratio) * phi + touch->turn_2;
        const Vec2 q_2 = turned(touch->point - Vec2(pair.center_distance, 0.0), -rest - phi_2);
        EXPECT_LE(std::abs(first.distance(q_1)), kTight) << text;
        EXPECT_LE(std::abs(second.distance(q_2)), kTight) << text;
      }
    }
  } catch (const std::invalid_argument&) {
    ++run.rough;  // an arc that is rougher than the polynomials of the oracle
  }
}

void expect_free(const InvolutePair& pair, double turn, const std::string& text) {
  const Outline& one = pair.gears[0].tooth->outline;
  const TurnedPolygons polygons(polygon_of(one), polygon_of(pair.gears[1].tooth->outline),
                                pair.center_distance, kLines);
  if (!polygons.in_reach()) return;
  double most = 0.0;
  for (const double t : {0.0, turn}) {
    for (int i = 0; i < kPositions; ++i) {
      // Mirrored, the other end of the play looks the same.
      const double phi = 2 * kPi / one.teeth * (i + 0.37) / kPositions;
      most = std::max(most, polygons.shared_area(phi, t));
    }
    if (turn == 0.0) break;
  }
  EXPECT_LE(most, kShared) << text;
}

Run check(std::uint64_t from, std::uint64_t to, bool areas) {
  Run run;
  for (std::uint64_t seed = from; seed < to; ++seed) {
    Random random(seed);
    const auto mounted = random_mounted_pair(random);
    if (!mounted) continue;
    const InvolutePair& pair = mounted->pair;
    const std::string text = fmt::format("seed {}, {}", seed, mounted->text);
    const double claimed = std::max(0.0, pair.mesh.backlash.rotation[1] / 2);
    const OutlineGap gap = outline_gap(pair.gears[0].tooth->outline, pair.gears[1].tooth->outline,
                                       pair.center_distance, claimed);
    const auto least = gap.least();
    EXPECT_TRUE(least) << text;
    if (!least) continue;
    ++run.pairs;
    if (least->distance() < -kTight) ++run.overlap;
    if (least->distance(claimed) < -kTight) ++run.within_play;
    expect_tight(pair, gap, text, run);
    const bool reaches_root = std::min(pair.tip_clearance[0], pair.tip_clearance[1]) < -kTight;
    if (areas && !reaches_root && least->distance() > -kTight)
      expect_free(pair, std::clamp(least->gap, 0.0, claimed), text);
    if (::testing::Test::HasFailure()) break;
  }
  return run;
}

void report(const Run& run) {
  ::testing::Test::RecordProperty("pairs", run.pairs);
  ::testing::Test::RecordProperty("overlap", run.overlap);
  ::testing::Test::RecordProperty("within_play", run.within_play);
  // The sample must hold both kinds, and the oracle must take nearly all.
  EXPECT_GT(run.overlap, run.pairs / 20);
  EXPECT_GT(run.within_play, run.overlap);
  EXPECT_LT(run.rough, run.pairs / 20 + 1);
}

TEST(OutlineGapOracle, touches_are_tight) { report(check(0, 2000, false)); }
TEST(OutlineGapOracle, polygons_are_free_within_the_true_play) {
  report(check(50000, 50250, true));
}
TEST(LongOutlineGapOracle, polygons_are_free_within_the_true_play) {
  report(check(100000, 125000, true));
}

}  // namespace
}  // namespace gearwright::oracle
