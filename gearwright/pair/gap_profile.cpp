#include "gearwright/pair/gap_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright::detail {

namespace {

bool is_land(const Arc& arc) {
  return arc.name == ArcName::root_land || arc.name == ArcName::tip_land;
}

ProfilePlace place_of(const CurvePoint& p) {
  const double c = std::cos(p.tangent_angle);
  const double s = std::sin(p.tangent_angle);
  return {p.point.norm(),
          std::atan2(p.point.y(), p.point.x()),
          p.point.x() * c + p.point.y() * s,
          p.point.y() * c - p.point.x() * s,
          p.tangent_angle,
          p.curvature};
}

// Returns the arc length from p to the radius ρ, from the series of ρ² to second order in the arc
// length. If this quadratic equation has no two distinct real roots, the result is the step of
// Newton's method for ρ² along the tangent.
double way_to(const ProfilePlace& p, double curvature, double rho) {
  const double c0 = (p.rho - rho) * (p.rho + rho);
  const double root = p.s * p.s - (1.0 + curvature * p.q) * c0;
  if (!(root > 0.0)) return -c0 / (2 * p.s);
  return -c0 / (p.s + std::copysign(std::sqrt(root), p.s));
}

ProfilePlace moved(const ProfilePlace& p, double curvature, double way, double rho) {
  const double turn = curvature * way;
  const double along = p.s + way;
  const double across = p.q + 0.5 * turn * way;
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  return {rho,
          p.theta + std::atan2(across * p.s - along * p.q, along * p.s + across * p.q),
          along * c + across * s,
          across * c - along * s,
          p.tau + turn,
          curvature};
}

}  // namespace

ProfilePlace ProfileArc::at(double u) const { return place_of(arc->at(u)); }

ProfileArc::Found ProfileArc::find(double rho) const {
  const double side = rho_tip > rho_root ? 1.0 : -1.0;
  if (side * (rho - rho_root) <= 0.0) return {0.0, at(0.0)};
  if (side * (rho - rho_tip) >= 0.0) return {1.0, at(1.0)};
  if (closed_form) {
    const double t = arc->curve->parameter_at_radius(rho, arc->begin, arc->end);
    const double u = (t - arc->begin) / (arc->end - arc->begin);
    return {u, at(u)};
  }
  if (guesses.empty()) {
    guesses.reserve(kGuesses + 1);
    for (int i = 0; i <= kGuesses; ++i) guesses.push_back(at(static_cast<double>(i) / kGuesses));
  }
  int cell = 0;
  while (cell + 1 < kGuesses && side * (guesses[static_cast<std::size_t>(cell) + 1].rho - rho) < 0)
    ++cell;
  const ProfilePlace& below = guesses[static_cast<std::size_t>(cell)];
  const ProfilePlace& above = guesses[static_cast<std::size_t>(cell) + 1];
  double lo = static_cast<double>(cell) / kGuesses;
  double hi = static_cast<double>(cell + 1) / kGuesses;
  // Near a point with s = 0, the radius grows with the square of the distance along the arc. The
  // first guess therefore uses a square root there.
  const double part = std::clamp((rho - below.rho) / (above.rho - below.rho), 0.0, 1.0);
  const double slow = std::abs(below.s) < 0.5 * std::abs(above.s) ? std::sqrt(part) : part;
  double u = lo + (hi - lo) * slow;
  const double chord =
      std::sqrt(std::max(0.0, below.rho * below.rho + above.rho * above.rho -
                                  2 * below.rho * above.rho * std::cos(below.theta - above.theta)));
  double pace = chord / (hi - lo);
  constexpr double kShort = 2e-6;  // limit for the last step, relative to the radius of curvature
                                   // and to ρ
  constexpr int kMost = 60;        // greatest number of steps; bisection alone would need fewer
  for (int i = 0;; ++i) {
    const CurvePoint at_u = arc->at(u);
    const ProfilePlace p = place_of(at_u);
    const double way = way_to(p, at_u.curvature, rho);
    if (std::abs(way * at_u.curvature) < kShort && std::abs(way) < kShort * rho)
      return {std::clamp(u + way / pace, lo, hi), moved(p, at_u.curvature, way, rho)};
    if (side * (p.rho - rho) < 0.0) {
      lo = u;
    } else {
      hi = u;
    }
    const double next = u + way / pace;
    const double kept = next > lo && next < hi ? next : 0.5 * (lo + hi);
    // Along a circle about the axis, the distance to a neighbouring radius is inaccurate. If two
    // radii differ only in the last digit, this distance may be NaN.
    if (i == kMost || kept == u) return {u, moved(p, at_u.curvature, 0.0, rho)};
    const Vec2 there = arc->curve->point(arc->begin + kept * (arc->end - arc->begin));
    const double run = (there - at_u.point).norm() / std::abs(kept - u);
    if (run > 0.0) pace = run;
    u = kept;
  }
}

ProfilePlace ProfileArc::at_radius(double rho) const { return find(rho).place; }
double ProfileArc::u_at_radius(double rho) const { return find(rho).u; }

GapProfile::GapProfile(const Outline& outline)
    : teeth_(std::abs(outline.teeth)), side_(outline.side()) {
  GW_EXPECTS(!outline.arcs.empty());
  root_radius_ = outline.arcs.front().begin_point.norm();
  tip_radius_ = outline.arcs.back().end_point.norm();
  arcs_.reserve(outline.arcs.size());
  for (const Arc& arc : outline.arcs) {
    const double begin = arc.begin_point.norm();
    const double end = arc.end_point.norm();
    if (is_land(arc) || begin == end) continue;
    arcs_.push_back({&arc, begin, end, arc.curve->radius_is_closed_form()});
  }
  // If the angle between two arcs is smaller than this, there is no corner. Such an angle is a
  // rounding error, or the corner is so blunt that an arc touches in place of the corner.
  constexpr double kSmooth = 1e-7;  // rad
  // The mating gear cannot reach a concave corner. At an angle near half a turn, the corner may be
  // a cusp, and rounding determines the sign of the angle. Such a corner is included, because an
  // additional corner does no harm.
  constexpr double kCusp = 2.5;  // rad
  const double inward = -side();
  for (std::size_t i = 0; i + 1 < outline.arcs.size(); ++i) {
    const Arc& arc = outline.arcs[i];
    const Arc& next = outline.arcs[i + 1];
    const double turn =
        std::remainder(next.at(0.0).tangent_angle - arc.at(1.0).tangent_angle, 2 * kPi);
    if (std::abs(turn) < kSmooth || (turn * inward < 0.0 && std::abs(turn) < kCusp)) continue;
    const Vec2& p = arc.end_point;
    corners_.push_back({p.norm(), std::atan2(p.y(), p.x()), is_land(next) ? arc.name : next.name});
  }
  const Arc& last = outline.arcs.back();
  if (!is_land(last)) {
    const ProfilePlace end = place_of(last.at(1.0));
    if (std::abs(end.s) > kSmooth * end.rho) corners_.push_back({end.rho, 0.0, last.name});
  }
}

const ProfileArc* GapProfile::arc_at(double rho) const {
  for (const ProfileArc& a : arcs_) {
    if ((rho - a.rho_root) * (rho - a.rho_tip) <= 0.0) return &a;
  }
  return nullptr;
}

}  // namespace gearwright::detail
