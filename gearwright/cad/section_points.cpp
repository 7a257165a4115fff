#include "gearwright/cad/section_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/cad/screw.hpp"

namespace gearwright {

namespace {

// Fractions of the chord tolerance ε. The density of the points is computed with 0.90 ε. Most
// segments then pass the check with 0.95 ε and need not be split. The five points of the check
// detect at least 0.97 of the height of a parabola. Points that are closer than 0.02 ε are merged.
constexpr double kDensityShare = 0.90;
constexpr double kCheckShare = 0.95;
constexpr double kJoinShare = 0.02;
// Number of cells per arc for the integral of the density. The direction of one arc changes by at
// most 2 rad, which is 0.03 rad per cell.
constexpr int kCells = 64;

double bound(const Arc& arc, double u_0, double u_1, const SectionTolerance& tolerance) {
  const Vec2 start = arc.point(u_0);
  const Vec2 chord = arc.point(u_1) - start;
  const double a = chord.norm();
  double d = 0.0;
  for (int i = 1; i <= 5; ++i) {
    const Vec2 offset = arc.point(u_0 + (u_1 - u_0) * (i / 6.0)) - start;
    const double across = std::abs(chord.x() * offset.y() - chord.y() * offset.x());
    d = std::max(d, a > 0.0 ? across / a : offset.norm());
  }
  const double turn = tolerance.level_turn;
  return d + (2.0 * a * turn + tolerance.radius * turn * turn) / 8.0;
}

void split(const Arc& arc, double u_0, double u_1, const SectionTolerance& tolerance,
           std::size_t most, std::vector<double>& parameters) {
  if (parameters.size() > most) return;
  const double middle = 0.5 * (u_0 + u_1);
  const bool divisible = u_0 < middle && middle < u_1;
  if (divisible && bound(arc, u_0, u_1, tolerance) > kCheckShare * tolerance.chord) {
    split(arc, u_0, middle, tolerance, most, parameters);
    split(arc, middle, u_1, tolerance, most, parameters);
  } else {
    parameters.push_back(u_1);
  }
}

// Returns the parameters of the points on one arc, from 0 to 1.
std::vector<double> place(const Arc& arc, const SectionTolerance& tolerance, std::size_t most) {
  const double turn = tolerance.level_turn;
  const double slack = 8.0 * kDensityShare * tolerance.chord - tolerance.radius * turn * turn;
  GW_EXPECTS(slack > 0.0);

  std::vector<double> count(kCells + 1, 0.0);  // integral of the density up to the end of each cell
  Vec2 before = arc.point(0.0);
  for (int i = 0; i < kCells; ++i) {
    const Vec2 after = arc.point((i + 1.0) / kCells);
    // The density is evaluated at the middle of the cell, because the curvature of an involute is
    // infinite at the base circle.
    const double curvature = std::abs(arc.at((i + 0.5) / kCells).curvature);
    const double density = std::max((turn + std::sqrt(turn * turn + curvature * slack)) / slack,
                                    curvature / tolerance.facet_turn);
    count[static_cast<std::size_t>(i) + 1] =
        count[static_cast<std::size_t>(i)] + density * (after - before).norm();
    before = after;
  }

  // If a value exceeds an integer only by rounding, it is not rounded up to the next integer.
  const double wanted = std::min(std::ceil(count.back() - 1e-9), static_cast<double>(most) + 1.0);
  const int segments = std::max(1, static_cast<int>(wanted));
  std::vector<double> parameters{0.0};
  std::size_t cell = 0;
  for (int j = 1; j <= segments; ++j) {
    double u = 1.0;
    if (j < segments) {
      const double target = count.back() * j / segments;
      while (count[cell + 1] < target) ++cell;
      u = (static_cast<double>(cell) + (target - count[cell]) / (count[cell + 1] - count[cell])) /
          kCells;
    }
    split(arc, parameters.back(), u, tolerance, most, parameters);
  }
  return parameters;
}

// Merges neighbouring points that are closer than `nearest`. The two end points remain.
std::vector<SectionPoint> join_near(const std::vector<SectionPoint>& points, double nearest) {
  std::vector<SectionPoint> kept{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if ((points[i].point - kept.back().point).norm() >= nearest) {
      kept.push_back(points[i]);
    } else if (i + 1 < points.size() || kept.size() == 1) {
      kept.back().tip_normal = points[i].tip_normal;
    } else {
      const Vec2 root_normal = kept.back().root_normal;
      kept.back() = points[i];
      kept.back().root_normal = root_normal;
    }
  }
  return kept;
}

}  // namespace

std::vector<SectionPoint> section_points(const Outline& outline, const SectionTolerance& tolerance,
                                         std::size_t most) {
  GW_EXPECTS(!outline.arcs.empty() && outline.teeth != 0);
  GW_EXPECTS(tolerance.chord > 0.0 && tolerance.facet_turn > 0.0 && tolerance.level_turn >= 0.0);
  const double side = outline.side();  // arcs run clockwise, with the material on their right

  std::vector<SectionPoint> points;
  for (std::size_t i = 0; i < outline.arcs.size(); ++i) {
    const Arc& arc = outline.arcs[i];
    const std::vector<double> parameters = place(arc, tolerance, most);
    for (const double u : parameters) {
      const Vec2 normal = section_normal(side, arc.at(u).tangent_angle);
      if (u == 0.0 && !points.empty()) {
        points.back().tip_normal = normal;
      } else {
        points.push_back({arc.point(u), normal, normal, i, u});
      }
    }
    if (points.size() > most) return points;
  }

  const auto [s, c] = sincos_turn(1, 2LL * std::abs(outline.teeth));
  const Vec2 first = points.front().point.norm() * Vec2(c, s);
  const Vec2 last = {points.back().point.norm(), 0.0};
  GW_EXPECTS((first - points.front().point).norm() <= 1e-6 * tolerance.radius);
  GW_EXPECTS((last - points.back().point).norm() <= 1e-6 * tolerance.radius);
  points.front().point = first;
  points.back().point = last;
  return join_near(points, kJoinShare * tolerance.chord);
}

}  // namespace gearwright
