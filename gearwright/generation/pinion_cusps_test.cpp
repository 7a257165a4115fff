#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/generation/circular_fillets.hpp"
#include "gearwright/generation/pinion_envelope.hpp"
#include "gearwright/generation/testing/cutter_piece.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {
namespace {

using testing::CutterPiece;

// True if the normal meets the centrode of the cutter. `s` is the distance of the normal from the
// axis.
bool normal_meets_centrode(const CutterPiece& piece, double t) {
  const CurvePoint p = piece.curve->at(t);
  const double s =
      p.point.x() * std::cos(p.tangent_angle) + p.point.y() * std::sin(p.tangent_angle);
  return std::abs(s) < 0.999 * piece.motion.cutter_pitch_radius();
}

constexpr int kCells = 2000;

// Samples slightly inside the piece, because at its ends the normal lies on the line of centres.
double sample(const CutterPiece& piece, int i) {
  return piece.at(1e-9 + (1.0 - 2e-9) * i / kCells);
}

// Returns the positions between the cells, as numbers of cells, where the sign of `rise` changes.
// `rise` has one value per cell.
template <class F>
std::vector<double> scanned(const F& rise) {
  std::vector<double> places;
  for (int i = 1; i < kCells; ++i) {
    if ((rise(i - 1) > 0.0) != (rise(i) > 0.0)) places.push_back(i);
  }
  return places;
}

// Random fillets of random cutters. The normal of every point meets the centrode.
std::vector<CutterPiece> random_pieces(int count) {
  std::mt19937_64 random(7);
  const auto between = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  std::vector<CutterPiece> all;
  while (static_cast<int>(all.size()) < count) {
    const int z_0 = std::uniform_int_distribution<int>(1, 30)(random);
    const double r_b = z_0 / 2.0 * std::cos(between(0.2, 0.6));
    const Involute flank(r_b, between(0.9, 2.4) / z_0);
    const bool ring = all.size() % 3 == 0;
    const int z = ring ? -std::uniform_int_distribution<int>(z_0 + 2, 4 * z_0 + 20)(random)
                       : std::uniform_int_distribution<int>(3, 40)(random);
    const PinionMotion motion{z_0, z, r_b * between(1.02, 1.25) * std::abs(1.0 + double(z) / z_0)};
    const double gamma = kPi / z_0;
    const auto add = [&](const CutterPiece& piece) {
      for (int i = 0; i <= 50; ++i) {
        if (!normal_meets_centrode(piece, piece.at(i / 50.0))) return;
      }
      all.push_back(piece);
    };
    const auto root = root_fillet_at(flank, z_0, between(0.0, 0.2));
    if (root && root->end > 0.0) {
      add({motion, std::make_shared<OffsetCircle>(root->distance, gamma, root->radius), gamma - kPi,
           gamma - kPi + root->span.rad()});
    }
    const auto tip = tip_fillet_at(
        flank, between(0.3, 1.0) * std::tan(inverse_involute(flank.base_half_angle())));
    if (!tip) continue;
    const auto circle = std::make_shared<OffsetCircle>(tip->distance, 0.0, tip->radius);
    add({motion, circle, tip->span.rad(), 0.0});
    if (ring) add({motion, circle, tip->span.rad(), 0.0, Meeting::behind});
    // A sharp tip on the flank, with its range of normals.
    const double xi = between(0.2, 1.0) * std::tan(inverse_involute(flank.base_half_angle()));
    const double nu = flank.base_half_angle() - xi + kPi / 2;
    add({motion, std::make_shared<CornerFan>(flank.point(xi)), nu, flank.polar_angle(xi)});
  }
  return all;
}

void expect_same_places(std::vector<double> scan, std::vector<double> found,
                        const CutterPiece& piece, const char* what) {
  std::vector<double> cells;
  for (double t : found) cells.push_back((t - piece.root) / (piece.tip - piece.root) * kCells);
  std::sort(cells.begin(), cells.end());
  // A point in the first or last cell may or may not be found by the scan. Two points in one cell
  // are never found.
  std::erase_if(cells, [&](double c) {
    const bool at_end = c < 1.0 || c > kCells - 1.0;
    if (at_end) std::erase_if(scan, [&](double s) { return std::abs(s - c) <= 1.0; });
    return at_end;
  });
  ASSERT_EQ(scan.size(), cells.size())
      << what << " " << piece.motion.cutter_teeth << ":" << piece.motion.teeth;
  for (std::size_t i = 0; i < cells.size(); ++i) EXPECT_NEAR(scan[i], cells[i], 1.0) << what;
}

// The cusps from the cubic are exactly the points at which the radius reverses in a fine scan.
// Between the cusps, `cuts` must agree with the direction in which the radius changes.
TEST(PinionCusps, cusps_are_all_and_only_the_turns_of_the_radius) {
  int cusps = 0;
  for (const CutterPiece& piece : random_pieces(1200)) {
    const PinionEnvelope envelope = piece.envelope();
    std::vector<double> radius;
    for (int i = 0; i <= kCells; ++i) radius.push_back(envelope.point(sample(piece, i)).norm());
    const auto rise = [&](int i) { return radius[i + 1] - radius[i]; };
    const std::vector<double> breaks = envelope.breaks(piece.root, piece.tip);
    EXPECT_TRUE(std::is_sorted(breaks.begin(), breaks.end(), [&](double a, double b) {
      return (a - b) * (piece.tip - piece.root) < 0;
    }));
    cusps += static_cast<int>(breaks.size());
    expect_same_places(scanned(rise), breaks, piece, "cusp");
    // If w G > 0, the radius decreases from root to tip of the cutter on an external gear and
    // increases on an internal gear. Behind the tooth, w has the other sign.
    const double sense = -piece.motion.side() * (piece.meeting == Meeting::ahead ? 1.0 : -1.0);
    for (int i = 2; i < kCells - 2; i += 97) {
      const double u = (i + 0.5) / kCells;
      const bool beside = std::none_of(breaks.begin(), breaks.end(), [&](double t) {
        return std::abs((t - piece.root) / (piece.tip - piece.root) - u) < 2.0 / kCells;
      });
      if (!beside) continue;
      EXPECT_EQ(envelope.cuts(piece.at(u)), sense * rise(i) > 0.0) << i;
    }
  }
  EXPECT_GT(cusps, 50);
}

TEST(PinionCusps, turns_are_where_the_half_angle_stands_still) {
  int turns = 0;
  for (const CutterPiece& piece : random_pieces(1200)) {
    const PinionEnvelope envelope = piece.envelope();
    std::vector<double> angle;
    for (int i = 0; i <= kCells; ++i) angle.push_back(envelope.polar_angle(sample(piece, i)));
    const std::vector<double> found = envelope.turns(piece.root, piece.tip);
    turns += static_cast<int>(found.size());
    std::vector<double> still = found;  // at a cusp both the point and its angle are stationary
    for (double t : envelope.breaks(piece.root, piece.tip)) still.push_back(t);
    expect_same_places(scanned([&](int i) { return angle[i + 1] - angle[i]; }), still, piece,
                       "turn");
  }
  EXPECT_GT(turns, 40);
}

// The concave root of the cutter with 8 teeth, module 3, x = 0.3. The source gives the normal of
// the cusp as −0.13050237994245208615, measured from the x axis in the direction opposite to our t.
TEST(PinionCusps, cusp_of_a_known_set) {
  const double alpha = kPi / 9, r_b = 12 * std::cos(alpha);
  const double psi_b = (kPi / 2 + 0.6 * std::tan(alpha)) / 8 + involute(alpha);
  const double xi_c = std::tan(alpha) + 2 * (0.76095150191937041 * std::cos(alpha) - 2.1) /
                                            (12 * std::sin(2 * alpha));
  const auto root = root_fillet_at(Involute(r_b, psi_b), 8, xi_c);
  ASSERT_TRUE(root);
  const auto circle = std::make_shared<OffsetCircle>(root->distance, kPi / 8, root->radius);
  const PinionEnvelope envelope({8, 24, 48.0}, circle, Walk::forward);
  const double from = kPi / 8 - kPi;
  const auto cusps = envelope.breaks(from, from + root->span.rad());
  ASSERT_EQ(cusps.size(), 1u);
  EXPECT_NEAR(cusps[0], -kPi / 2 + 0.13050237994245208615, 1e-12);
}

// The corner lies outside the centrode, so some of its normals do not meet the centrode. The
// normals at the ends of this range are tangent to the centrode.
TEST(PinionCusps, reach_ends_where_the_normal_touches_the_centrode) {
  const PinionMotion motion{8, 24, 48.0};
  const double r_p = motion.cutter_pitch_radius();
  const Vec2 corner(15.0, 1.0);
  const auto fan = std::make_shared<CornerFan>(corner);
  const PinionEnvelope envelope(motion, fan, Walk::forward);
  const double theta = std::atan2(1.0, 15.0);
  const auto ends = envelope.breaks(theta, theta + kPi);
  ASSERT_EQ(ends.size(), 2u);
  for (const double nu : ends) {
    const double s = corner.x() * std::sin(nu) - corner.y() * std::cos(nu);
    EXPECT_NEAR(s, r_p, 1e-12);
  }
  EXPECT_TRUE(envelope.cuts(ends[0] - 1e-6));
  EXPECT_FALSE(envelope.cuts(ends[0] + 1e-6));
  EXPECT_FALSE(envelope.cuts(ends[1] - 1e-6));
  EXPECT_TRUE(envelope.cuts(ends[1] + 1e-6));
}

}  // namespace
}  // namespace gearwright
