// Compares SweptPinion with gears of the source, computed with 40 digits; with an internal and an
// external gear cut by a sharp-edged involute cutter, whose flanks and trochoids are known; and
// with a plain scan.
#include "tests/oracle/swept_pinion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/oracle/numbers.hpp"
#include "tests/oracle/pinion_cutter_cases.hpp"
#include "tests/oracle/plane_turn.hpp"

namespace gearwright::oracle {
namespace {

using Eigen::Vector2d;
constexpr double kRest = 1e-12;  // mm, the accuracy of SweptPinion

Vector2d polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

double involute_of_tan(double t) { return t - std::atan(t); }

SweptPinion swept(const PinionCutterCase& c) {
  return SweptPinion({c.pinion.teeth, c.pinion.gear_teeth, c.pinion.center_distance},
                     filleted_half_tooth(c.pinion).curves);
}

/// A point of the source's gear, whose space 0 is at −x, moved by `step` along its normal.
Vector2d place(const PinionCutterCase& c, const CutGearPoint& p, double step = 0.0) {
  return turned({p.x + step * p.n_x, p.y + step * p.n_y}, kPi / c.pinion.gear_teeth - kPi);
}

TEST(SweptPinion, cutters_have_the_radii_of_the_source) {
  for (const PinionCutterCase& c : pinion_cutter_cases()) {
    const FilletedHalfTooth half = filleted_half_tooth(c.pinion);
    EXPECT_NEAR(half.root_fillet_radius, c.root_fillet_radius, 1e-13) << c.name;
    EXPECT_NEAR(half.root_radius, c.root_radius, 1e-13) << c.name;
    EXPECT_NEAR(half.tip_fillet_radius, c.tip_fillet_radius, 1e-13) << c.name;
    EXPECT_NEAR(half.tip_radius, c.tip_radius, 1e-13) << c.name;
  }
}

// In S07, the end C of the involute cuts a loop that the root arc removes. All other points lie on
// the surface. After a step away from the surface, the clearance must equal the step.
TEST(SweptPinion, points_of_the_source_lie_on_the_surface) {
  int on_surface = 0;
  for (const PinionCutterCase& c : pinion_cutter_cases()) {
    const SweptPinion sweep = swept(c);
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const CutGearPoint& p = c.points[i];
      if (c.name[2] == '7' && i == 0) {
        EXPECT_NEAR(sweep.clearance(place(c, p)), -4.6e-3, 5e-5);
        continue;
      }
      ++on_surface;
      EXPECT_NEAR(sweep.clearance(place(c, p)), 0.0, kRest) << c.name << " " << p.x << " " << p.y;
      // Perpendicular to the step, the edges of cutter and gear curve away from each other, by
      // step²/mm.
      for (const double step : {1e-5, 1e-8}) {
        EXPECT_NEAR(sweep.clearance(place(c, p, -step)), step, kRest + step * step)
            << c.name << " " << p.x << " " << p.y;
        EXPECT_NEAR(sweep.clearance(place(c, p, step)), -step, kRest + 4 * step * step)
            << c.name << " " << p.x << " " << p.y;
      }
    }
  }
  EXPECT_EQ(on_surface, 50);
}

/// The involute flank of the gear in S07, side y > 0 of tooth 0. It has the same normal and pitch
/// circles as that of the cutter; at a = r + r_2 these are the reference circles.
Vector2d flank_of_S07(double radius) {
  const double alpha = 20 * kDegree, m = 3, r_2 = 36, r_b2 = r_2 * std::cos(alpha);
  const double half_space = m * (kPi / 4 + 0.3 * std::tan(alpha)) / r_2;
  const double t = std::sqrt((radius - r_b2) * (radius + r_b2)) / r_b2;
  return polar(radius,
               kPi / 24 - half_space + involute_of_tan(std::tan(alpha)) - involute_of_tan(t));
}

// Near the cusp, the involute is the surface up to a radius that the source computed by
// intersecting the two branches. Above this radius it is cut away.
TEST(SweptPinion, cusp_ends_the_flank_where_the_source_says) {
  const SweptPinion sweep = swept(pinion_cutter_cases().back());
  constexpr double kTrim = 37.5358651600508473, kConjugateOfC = 37.578;
  for (const double below : {0.0, 1e-6, 1e-3, 0.1, 1.0, 3.0}) {
    EXPECT_NEAR(sweep.clearance(flank_of_S07(kTrim - below)), 0.0, kRest) << below;
  }
  double last = 0.0;
  for (const double above : {1e-6, 1e-4, 1e-3, 1e-2, kConjugateOfC - kTrim}) {
    const double cut = sweep.clearance(flank_of_S07(kTrim + above));
    EXPECT_LT(cut, last) << above;
    EXPECT_GT(cut, -0.2 * above) << above;
    last = cut;
  }
}

/// A spur cutter m = 2, 20°, sharp at its tip: root circle, radial line, involute, tip circle.
struct SharpCutter {
  int teeth;
  double shift, r, r_b, sigma, r_f, r_a, t_a, tip_angle;

  SharpCutter(int z, double x)
      : teeth(z),
        shift(x),
        r(z),
        r_b(r * std::cos(20 * kDegree)),
        sigma((kPi / 2 + 2 * x * std::tan(20 * kDegree)) / z +
              involute_of_tan(std::tan(20 * kDegree))),
        r_f(r_b - 1.0),
        r_a(r + 2.5 + 2 * x),
        t_a(std::sqrt((r_a - r_b) * (r_a + r_b)) / r_b),
        tip_angle(sigma - involute_of_tan(t_a)) {}

  std::vector<ToothedOutline::Curve> curves() const {
    const double inner = r_f, outer = r_b, angle = sigma;
    return {circle_arc({0, 0}, r_f, kPi / teeth, sigma),
            [=](double u) { return polar(inner + u * (outer - inner), angle); },
            involute_curve(r_b, sigma, 0.0, t_a), circle_arc({0, 0}, r_a, tip_angle, 0.0)};
  }
};

/// The path of the cutter's sharp edge in the gear, on the side of the gear's tooth 0. It is a
/// trochoid in closed form.
Vector2d edge_path(const SharpCutter& c, int gear_teeth, double a, double roll) {
  const double teeth = std::abs(gear_teeth), s = gear_teeth > 0 ? 1 : -1;
  const double orientation = roll + (s > 0 ? kPi : 0.0);
  return turned(Vector2d(a, 0) + polar(c.r_a, orientation + s * c.tip_angle),
                kPi / teeth + s * roll * c.teeth / teeth);
}

/// The involute flank of the gear next to space 0, side y > 0 of tooth 0, at the operating pressure
/// angle that belongs to `a`. The space of an internal gear has the shape of a tooth on the same
/// base circle. The space of an external gear is the gap between its teeth.
Vector2d gear_flank(const SharpCutter& c, int gear_teeth, double a, double radius) {
  const double teeth = std::abs(gear_teeth), s = gear_teeth > 0 ? 1 : -1;
  const double u = teeth / c.teeth, r_b2 = c.r_b * u, pitch_radius = a / (u + s) * u;
  const double t_w = std::sqrt((pitch_radius - r_b2) * (pitch_radius + r_b2)) / r_b2;
  const double half_space = (c.sigma - involute_of_tan(t_w)) / u;
  const double t = std::sqrt((radius - r_b2) * (radius + r_b2)) / r_b2;
  return polar(radius, kPi / teeth - half_space - s * (involute_of_tan(t) - involute_of_tan(t_w)));
}

/// Checks three parts of the gear, which must not be undercut: the flank from the point conjugate
/// to the cutter's base circle to the point conjugate to its edge, the trochoid of the edge, and
/// the root circle.
void check_sharp(const SharpCutter& c, int gear_teeth, double a) {
  const SweptPinion sweep({c.teeth, gear_teeth, a}, c.curves());
  const double teeth = std::abs(gear_teeth), s = gear_teeth > 0 ? 1 : -1;
  const double u = teeth / c.teeth, r_b2 = c.r_b * u;
  // Lengths of the string between the two base circles, and of the part on the gear.
  const double string = std::sqrt((a - (r_b2 + s * c.r_b)) * (a + (r_b2 + s * c.r_b)));
  // No material is beyond the reach of the cutter's root circle.
  const double start = s > 0 ? std::min(std::hypot(r_b2, string), a - c.r_f)
                             : std::max(std::hypot(r_b2, string), a + c.r_f);
  const double end = std::hypot(r_b2, string - s * c.r_b * c.t_a);
  for (int i = 0; i <= 40; ++i) {
    const double radius = start + (end - start) * i / 40;
    EXPECT_NEAR(sweep.clearance(gear_flank(c, gear_teeth, a, radius)), 0.0, kRest) << radius;
  }
  const double middle = 0.5 * (start + end);
  const Vector2d p = gear_flank(c, gear_teeth, a, middle);
  const Vector2d t = (gear_flank(c, gear_teeth, a, middle + 1e-5) - p).normalized();
  const Vector2d out(-t.y(), t.x());
  EXPECT_NEAR(sweep.clearance(p + 1e-5 * out), -1e-5, 1e-9);
  EXPECT_NEAR(sweep.clearance(p - 1e-5 * out), 1e-5, 1e-9);

  // The range is from the line of centres, where the edge is deepest, to the conjugate point of the
  // flank.
  const double deepest = -s * c.tip_angle;
  const double cosine = (end * end - a * a - c.r_a * c.r_a) / (2 * a * c.r_a);
  const double spread = std::acos(s > 0 ? -cosine : cosine);
  const double root = a - s * c.r_a;
  EXPECT_NEAR(edge_path(c, gear_teeth, a, deepest).norm(), root, 1e-12);
  const double last = deepest + s * spread;
  EXPECT_NEAR((edge_path(c, gear_teeth, a, last) - gear_flank(c, gear_teeth, a, end)).norm(), 0.0,
              1e-11);
  for (int i = 0; i <= 40; ++i) {
    const double roll = deepest + (last - deepest) * i / 40;
    const Vector2d edge = edge_path(c, gear_teeth, a, roll);
    EXPECT_NEAR(sweep.clearance(edge), 0.0, kRest) << i;
    if (i == 0 || i == 40) continue;
    const Vector2d way = (edge_path(c, gear_teeth, a, roll + s * 1e-6) - edge).normalized();
    const Vector2d into = s * Vector2d(way.y(), -way.x());
    EXPECT_NEAR(sweep.clearance(edge + 1e-5 * into), 1e-5, 1e-8) << i;
    // Inside the wedge of the sharp edge, the depth is positive but not greater than the step.
    const double cut = sweep.clearance(edge - 1e-5 * into);
    EXPECT_GE(cut, -1e-5 - kRest) << i;
    EXPECT_LT(cut, -1e-6) << i;
  }
  const Vector2d beside = edge_path(c, gear_teeth, a, deepest);
  const double from = std::atan2(beside.y(), beside.x());
  for (int i = 0; i <= 10; ++i) {
    const double angle = from + (kPi / teeth - from) * i / 10;
    EXPECT_NEAR(sweep.clearance(polar(root, angle)), 0.0, kRest) << i;
    EXPECT_NEAR(sweep.clearance(polar(root - s * 0.1, angle)), 0.1, kRest) << i;
  }
}

TEST(SweptPinion, ring_has_involute_flanks_and_the_trochoid_of_the_edge) {
  check_sharp(SharpCutter(20, 0.0), -60, 40.0);
  check_sharp(SharpCutter(25, 0.1), -90, 65.3);
}

TEST(SweptPinion, external_gear_has_involute_flanks_and_the_trochoid_of_the_edge) {
  check_sharp(SharpCutter(20, 0.0), 45, 65.0);
  check_sharp(SharpCutter(30, 0.1), 37, 67.4);
}

std::vector<SweptPinion> sweeps() {
  std::vector<SweptPinion> all;
  for (const PinionCutterCase& c : pinion_cutter_cases()) all.push_back(swept(c));
  all.emplace_back(PinionSweepNumbers{20, -60, 40.0}, SharpCutter(20, 0.0).curves());
  all.emplace_back(PinionSweepNumbers{20, 12, 32.0}, SharpCutter(20, 0.0).curves());  // undercut
  all.emplace_back(PinionSweepNumbers{20, -24, 4.0}, SharpCutter(20, 0.0).curves());  // trimmed
  return all;
}

/// Points around the root, flanks and tips of the gear.
Vector2d somewhere(const SweptPinion& sweep, std::mt19937_64& random) {
  std::uniform_real_distribution<double> part(0, 1);
  const PinionSweepNumbers& n = sweep.numbers();
  const double r_a = sweep.cutter().outer_radius();
  const double root = n.gear_teeth > 0 ? n.center_distance - r_a : n.center_distance + r_a;
  const double depth = (-0.1 + 1.0 * part(random)) * (n.cutter_teeth < 10 ? 4.0 : 5.0);
  return polar(n.gear_teeth > 0 ? root + depth : root - depth, 2 * kPi * part(random));
}

/// Evaluates all positions of one turn of the gear in equal steps, then refines the minima. It uses
/// only the gap at a position.
double plain_scan(const SweptPinion& sweep, const Vector2d& p) {
  const double turn = 2 * kPi * std::abs(sweep.numbers().gear_teeth) / sweep.numbers().cutter_teeth;
  const int positions = static_cast<int>(turn * 60);
  const double step = turn / positions;
  std::vector<double> gap(static_cast<std::size_t>(positions));
  for (int k = 0; k < positions; ++k) gap[k] = sweep.gap_at(p, k * step);
  double best = *std::min_element(gap.begin(), gap.end());
  const double limit = best + 0.3;  // includes other minima that a step may have missed
  for (int k = 0; k < positions; ++k) {
    const double before = gap[(k + positions - 1) % positions], after = gap[(k + 1) % positions];
    if (gap[k] > before || gap[k] > after || gap[k] > limit) continue;
    double lo = (k - 1) * step, hi = lo + 2 * step;
    for (int i = 0; i < 75; ++i) {
      const double a = lo + 0.382 * (hi - lo), b = hi - 0.382 * (hi - lo);
      const bool first = sweep.gap_at(p, a) < sweep.gap_at(p, b);
      (first ? hi : lo) = first ? b : a;
    }
    best = std::min(best, sweep.gap_at(p, 0.5 * (lo + hi)));
  }
  return best;
}

TEST(SweptPinion, agrees_with_a_plain_scan_of_all_positions) {
  std::mt19937_64 random(20240612);
  for (const SweptPinion& sweep : sweeps()) {
    int standing = 0, cut = 0;
    for (int i = 0; i < 40; ++i) {
      const Vector2d p = somewhere(sweep, random);
      const double fast = sweep.clearance(p), scan = plain_scan(sweep, p);
      ++(scan >= 0 ? standing : cut);
      // The plain scan measures the roll from an arbitrary origin. At a hundred radians, the
      // rounding error is 1e-14 rad. At the tip of a kink, golden section stops within the square
      // root of the rounding error.
      EXPECT_NEAR(fast, scan, 3e-12) << sweep.numbers().gear_teeth << " " << p.transpose();
    }
    EXPECT_GT(standing, 4) << sweep.numbers().gear_teeth;
    EXPECT_GT(cut, 4) << sweep.numbers().gear_teeth;
  }
}

// (1) many points at once give the same results    (2) all teeth, and both halves, give the same
// (3) if a point moves, the clearance changes by no more than the length of the movement
// (4) the clearance is the gap at the roll that is returned
TEST(SweptPinion, laws) {
  std::mt19937_64 random(5);
  for (const SweptPinion& sweep : sweeps()) {
    std::vector<Vector2d> points;
    for (int i = 0; i < 12; ++i) {
      points.push_back(somewhere(sweep, random));
      points.push_back(points.back() + Vector2d(3e-3, -2e-3));
    }
    const std::vector<double> many = sweep.clearances(points);
    const double pitch = 2 * kPi / std::abs(sweep.numbers().gear_teeth);
    ASSERT_EQ(many.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector2d p = points[i];
      const double one = sweep.clearance(p);
      EXPECT_NEAR(many[i], one, kRest) << p.transpose();                           // (1)
      EXPECT_NEAR(sweep.clearance({p.x(), -p.y()}), one, kRest) << p.transpose();  // (2)
      EXPECT_NEAR(sweep.clearance(turned(p, 3 * pitch)), one, kRest) << p.transpose();
      const std::size_t j = i ^ 1;  // its neighbour
      EXPECT_LE(std::abs(one - many[j]), (p - points[j]).norm() + kRest) << p.transpose();  // (3)
      const double angle = std::atan2(p.y(), p.x());
      const double folded = std::abs(std::remainder(angle, pitch));
      const SweptPinion::Nearest n = sweep.nearest(p);
      EXPECT_NEAR(sweep.gap_at(polar(p.norm(), folded), n.roll), n.clearance, kRest);  // (4)
    }
  }
}

TEST(SweptPinion, refuses_what_makes_no_gear) {
  const auto curves = SharpCutter(20, 0.0).curves();
  EXPECT_NO_THROW(SweptPinion({20, -21, 2.0}, curves));
  EXPECT_THROW(SweptPinion({20, -20, 2.0}, curves), std::invalid_argument);
  EXPECT_THROW(SweptPinion({20, 0, 40.0}, curves), std::invalid_argument);
  EXPECT_THROW(SweptPinion({20, 30, 0.0}, curves), std::invalid_argument);
  EXPECT_THROW(SweptPinion({21, 30, 50.0}, curves), std::invalid_argument);
}

}  // namespace
}  // namespace gearwright::oracle
