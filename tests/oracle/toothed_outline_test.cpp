// Compares ToothedOutline with the curves themselves. Each curve is evaluated in small steps and
// the best step is refined. The side is determined by the winding number of the whole outline drawn
// with chords.
#include "tests/oracle/toothed_outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/oracle/numbers.hpp"
#include "tests/oracle/pinion_cutter_cases.hpp"

namespace gearwright::oracle {
namespace {

using Eigen::Vector2d;
using Curves = std::vector<ToothedOutline::Curve>;

struct Drawn {
  const char* name;
  int teeth;
  Curves curves;
};

ToothedOutline::Curve line(Vector2d from, Vector2d to) {
  return [=](double u) -> Vector2d { return from + u * (to - from); };
}

/// The cutters of the source, which are smooth everywhere; a sharp-edged cutter whose involute
/// starts at its base circle, where the speed is zero, on a radial line; the same with the
/// parameter √u; a necked tooth, whose polar angle decreases, increases and decreases again; and a
/// tooth that is pointed at the tip and in the space.
std::vector<Drawn> outlines() {
  std::vector<Drawn> all;
  for (const PinionCutterCase& c : pinion_cutter_cases()) {
    if (c.name[2] == '2' || c.name[2] == '3') continue;  // the cutter of S01
    all.push_back({c.name, c.pinion.teeth, filleted_half_tooth(c.pinion).curves});
  }
  const double gamma = kPi / 20, r_b = 18.8, sigma = 0.0934, t_a = 0.65;
  const Vector2d foot(std::cos(sigma), std::sin(sigma)), tip = involute_point(r_b, sigma, t_a);
  const Curves sharp = {circle_arc({0, 0}, 17.5, gamma, sigma), line(17.5 * foot, r_b * foot),
                        involute_curve(r_b, sigma, 0, t_a),
                        circle_arc({0, 0}, tip.norm(), std::atan2(tip.y(), tip.x()), 0)};
  all.push_back({"sharp", 20, sharp});
  Curves singular = sharp;
  singular[2] = [=](double u) { return involute_point(r_b, sigma, t_a * std::sqrt(u)); };
  all.push_back({"singular pace", 20, singular});
  all.push_back({"necked", 3, {[](double u) -> Vector2d {
                   const double r = 5 + 5 * u, v = 2 * kPi * u;
                   const double angle = kPi / 3 * (1 - u) - 0.35 * std::sin(v) * (1 - u);
                   return {r * std::cos(angle), r * std::sin(angle)};
                 }}});
  const Vector2d ray(std::cos(kPi / 7), std::sin(kPi / 7));
  all.push_back({"pointed", 7, {line(6.0 * ray, {7.0, 1.5}), line({7.0, 1.5}, {9.5, 0.0})}});
  return all;
}

/// Distance from the curves of one half tooth, without sign.
double walked_distance(const Curves& curves, const Vector2d& q) {
  constexpr int kSteps = 4000;
  double best = std::numeric_limits<double>::infinity();
  for (const auto& curve : curves) {
    const auto away = [&](double u) { return (curve(u) - q).norm(); };
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kSteps; ++i) {
      const double d = away(static_cast<double>(i) / kSteps);
      if (d < least) least = d, nearest = i;
    }
    double lo = std::max(0.0, (nearest - 1.0) / kSteps),
           hi = std::min(1.0, (nearest + 1.0) / kSteps);
    for (int i = 0; i < 80; ++i) {
      const double a = lo + 0.382 * (hi - lo), b = hi - 0.382 * (hi - lo);
      (away(a) < away(b) ? hi : lo) = away(a) < away(b) ? b : a;
    }
    best = std::min({best, least, away(lo)});
  }
  return best;
}

std::vector<Vector2d> drawn_whole(const Drawn& d) {
  constexpr int kSteps = 2000;
  std::vector<Vector2d> half, whole;
  for (const auto& curve : d.curves) {
    for (int i = 0; i < kSteps; ++i) half.push_back(curve(static_cast<double>(i) / kSteps));
  }
  for (int tooth = 0; tooth < d.teeth; ++tooth) {
    const double turn = -2 * kPi * tooth / d.teeth, s = std::sin(turn), c = std::cos(turn);
    const auto add = [&](double x, double y) { whole.emplace_back(c * x - s * y, s * x + c * y); };
    for (const Vector2d& p : half) add(p.x(), p.y());
    for (auto p = half.rbegin(); p != half.rend(); ++p) add(p->x(), -p->y());
  }
  return whole;
}

bool winds_around(const std::vector<Vector2d>& polygon, const Vector2d& q) {
  double turn = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d a = polygon[i] - q, b = polygon[(i + 1) % polygon.size()] - q;
    turn += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(turn) > kPi;
}

TEST(ToothedOutline, distance_is_that_from_the_walked_curves) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (const Drawn& d : outlines()) {
    const ToothedOutline outline(d.teeth, d.curves);
    const std::vector<Vector2d> whole = drawn_whole(d);
    int outside = 0, inside = 0;
    for (int i = 0; i < 120; ++i) {
      const double r = 1.3 * outline.outer_radius() * part(random);
      const double angle = 2 * kPi * part(random);
      const Vector2d q(r * std::cos(angle), r * std::sin(angle));
      // The walk uses only one half tooth, so the point is moved into the half pitch of this half
      // tooth.
      const double pitch = 2 * kPi / d.teeth;
      const double left = angle - pitch * std::floor(angle / pitch);
      const double folded = std::min(left, pitch - left);
      const double walked = walked_distance(d.curves, {r * std::cos(folded), r * std::sin(folded)});
      const double found = outline.distance(q);
      // Golden section over distances stops within the root of rounding, but its value is accurate.
      EXPECT_NEAR(std::abs(found), walked, 2e-13 + 1e-14 * r) << d.name << " " << q.transpose();
      EXPECT_EQ(found < 0, winds_around(whole, q)) << d.name << " " << q.transpose();
      ++(found < 0 ? inside : outside);
    }
    EXPECT_GT(outside, 9) << d.name;
    EXPECT_GT(inside, 9) << d.name;
  }
}

// Close to the curve, the sign is most important. A step to either side along the normal must be
// measured as itself. The normal is computed from three points of the curve. At a sharp edge, this
// holds only outwards.
TEST(ToothedOutline, small_steps_to_either_side_are_seen) {
  for (const Drawn& d : outlines()) {
    const ToothedOutline outline(d.teeth, d.curves);
    for (std::size_t k = 0; k < d.curves.size(); ++k) {
      for (int i = 5; i <= 45; ++i) {
        const double u = i / 50.0, h = 1e-5;
        const Vector2d p = d.curves[k](u);
        const Vector2d t = (d.curves[k](u + h) - d.curves[k](u - h)).normalized();
        const Vector2d n(-t.y(), t.x());
        EXPECT_NEAR(outline.distance(p), 0.0, 2e-13) << d.name << " " << k << " " << u;
        for (const double step : {1e-12, 1e-9, 1e-6, 1e-3}) {
          const double rest = 3e-13 + 1e-6 * step;
          EXPECT_NEAR(outline.distance(p + step * n), step, rest) << d.name << k << " " << u;
          EXPECT_NEAR(outline.distance(p - step * n), -step, rest) << d.name << k << " " << u;
        }
      }
    }
  }
  const ToothedOutline pointed(7, outlines().back().curves);
  EXPECT_NEAR(pointed.distance({9.5 + 1e-9, 0}), 1e-9, 1e-14);
  EXPECT_NEAR(pointed.distance({9.5 - 1e-9, 0}), -1e-9 * 1.5 / std::hypot(1.5, 2.5), 1e-14);
  const Vector2d ray(std::cos(kPi / 7), std::sin(kPi / 7));
  EXPECT_LT(pointed.distance((6 - 1e-9) * ray), 0);
  EXPECT_GT(pointed.distance((6 + 1e-9) * ray), 0);
}

TEST(ToothedOutline, every_tooth_and_both_halves_are_alike) {
  for (const Drawn& d : outlines()) {
    const ToothedOutline outline(d.teeth, d.curves);
    const Vector2d q(0.8 * outline.outer_radius(), 0.13 * outline.outer_radius());
    const double here = outline.distance(q);
    EXPECT_DOUBLE_EQ(outline.distance({q.x(), -q.y()}), here) << d.name;
    for (int tooth = 1; tooth < d.teeth; ++tooth) {
      const double turn = 2 * kPi * tooth / d.teeth, s = std::sin(turn), c = std::cos(turn);
      EXPECT_NEAR(outline.distance({c * q.x() - s * q.y(), s * q.x() + c * q.y()}), here, 1e-14)
          << d.name << " " << tooth;
    }
    for (std::size_t piece = 0; piece < outline.piece_count(); ++piece) {
      EXPECT_NEAR(outline.foot(q, piece).distance, here, 1e-14) << d.name;
    }
  }
}

TEST(ToothedOutline, refuses_a_chain_that_is_none) {
  const Curves good = outlines()[3].curves;
  EXPECT_NO_THROW(ToothedOutline(20, good));
  EXPECT_THROW(ToothedOutline(0, good), std::invalid_argument);
  EXPECT_THROW(ToothedOutline(21, good), std::invalid_argument);  // begins beside the space
  EXPECT_THROW(ToothedOutline(20, {}), std::invalid_argument);
  EXPECT_THROW(ToothedOutline(20, {good[0], good[1], good[2]}), std::invalid_argument);
  EXPECT_THROW(ToothedOutline(20, {good[0], good[2], good[3]}), std::invalid_argument);
  EXPECT_THROW(ToothedOutline(20, {good[3], good[2], good[1], good[0]}), std::invalid_argument);
  Curves broken = good;
  broken[2] = [&](double u) -> Vector2d {
    return good[2](u) + (u > 0.4 && u < 0.6 ? Vector2d(0.01, 0) : Vector2d(0, 0));
  };
  EXPECT_THROW(ToothedOutline(20, broken), std::invalid_argument);
  Curves rough = good;
  rough[2] = [&](double u) -> Vector2d { return good[2](u) * (1 + 1e-9 * std::sin(1e9 * u)); };
  EXPECT_THROW(ToothedOutline(20, rough), std::invalid_argument);
}

}  // namespace
}  // namespace gearwright::oracle
