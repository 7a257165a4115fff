// The path of a tip corner through the root of the mating gear, and the least distance between this
// path and the fillet.
//
//   ρ_c, θ_c   radius and half angle of the corner on its own tooth     u = z_gear/z_mate
//   η          half the backlash as a rotation of the mating gear; this rotation closes the gap
//              between the flanks
//   w          orbit parameter, 0 at the deepest position, where the corner crosses the centre line
//
// In the frame of the gear with the fillet, the axis of the mating gear moves on a circle about the
// axis of the gear with the fillet. The right column names the gear with the fillet. By [T2.26],
// the corner of the mating gear is at
//   P(w) = e^{iφ} (a − ρ_c e^{iw}),  w = uφ − (θ_c + η)      gear of an external pair
//   P(w) = e^{iφ} (ρ_c e^{iw} − a),  w = (θ_c + η) − uφ      pinion of an internal gear
//   P(w) = e^{iφ} (ρ_c e^{iw} + a),  w = (θ_c + η) − uφ      internal gear
// The x axis is the centre line of the space. The fillet belongs to the tooth with the centre line
// at the polar angle π/z.
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>

#include "gearwright/math/lowest.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

namespace {

using Complex = std::complex<double>;

struct Corner {
  double radius;
  double half_angle;
};

// Returns the corners at the tip of a tooth. If a tip fillet follows the flank, both ends of the
// tip fillet are corners.
std::vector<Corner> tip_corners(const Gear& mate) {
  if (!mate.tooth) {
    const double r = mate.tip_diameter / 2;
    if (r < mate.base_radius()) return {};
    const double d_b = mate.reference().base_diameter;
    return {{r, tooth_thickness_transverse(mate.spec.teeth, d_b,
                                           mate.reference().base_tooth_thickness, 2 * r) /
                    (2 * r)}};
  }
  std::vector<Corner> corners;
  for (const Arc& arc : mate.tooth->outline.arcs) {
    if (arc.name == ArcName::root_land || arc.name == ArcName::tip_land) continue;
    const Corner end{arc.end_point.norm(), std::atan2(arc.end_point.y(), arc.end_point.x())};
    if (arc.name == ArcName::root_fillet) {
      corners = {end};  // a root fillet or flank that follows replaces these corners
    } else if (arc.name == ArcName::flank) {
      corners = {end};
    } else {
      corners.push_back(end);
    }
  }
  return corners;
}

struct Orbit {
  double a, u, play;       // play = η
  double side, mate_side;  // σ of the gear with the fillet, and of the gear with the corner
  double half_space;       // π/z

  // Returns the corner in the frame of the tooth beside the space. The position is mirrored to the
  // side y > 0 of this tooth.
  Vec2 place(const Corner& c, double w) const {
    const double kappa = c.half_angle + play;
    const double phi = (kappa + side * mate_side * w) / u;
    const Complex from_axis = mate_side * (a - side * std::polar(c.radius, w));
    const Complex p = std::polar(1.0, phi - half_space) * from_axis;
    return {p.real(), -p.imag()};
  }
};

constexpr int kHalfDigits = std::numeric_limits<double>::digits / 2;

constexpr double kFoot = 1e-6;  // accuracy of the foot of p, relative to the length of the arc

// Distance from p to an arc, > 0 on the side of the space.
double signed_distance(const Arc& arc, const Vec2& p) {
  const auto distance = [&](double u) { return (arc.point(u) - p).norm(); };
  const auto [lo, hi, at_node] = least_node(distance, 8);
  const double u = boost::math::tools::brent_find_minima(distance, lo, hi, kHalfDigits).first;
  const CurvePoint foot = arc.at(u);
  const Vec2 away = p - foot.point;
  const Vec2 along(std::cos(foot.tangent_angle), std::sin(foot.tangent_angle));
  const double beside = along.dot(away);
  const double above = along.x() * away.y() - along.y() * away.x();
  // At the foot of p, the vector to p is perpendicular to the arc. The distance is therefore exact,
  // although only half of the digits of u are accurate. The space lies to the left of the arc, or
  // to the right of the arc if the tooth belongs to an internal gear.
  if (std::abs(beside) <= kFoot * (arc.end_point - arc.begin_point).norm())
    return arc.begin_point.norm() < arc.end_point.norm() ? above : -above;
  const double least = std::min(at_node, distance(u));
  const double r_begin = arc.begin_point.norm();
  const double r_end = arc.end_point.norm();
  const bool outward = r_begin < r_end;
  const double rho = std::clamp(p.norm(), std::min(r_begin, r_end), std::max(r_begin, r_end));
  const double theta =
      arc.curve->polar_angle(outward ? arc.curve->parameter_at_radius(rho, arc.begin, arc.end)
                                     : arc.curve->parameter_at_radius(rho, arc.end, arc.begin));
  double angle = std::atan2(p.y(), p.x());
  // The polar angle of p may exceed π if the gear has one tooth. In this case, atan2 returns this
  // angle minus 2π.
  if (angle < theta - std::numbers::pi) angle += 2 * std::numbers::pi;
  return angle >= theta ? least : -least;
}

constexpr double kFarAway = 1e9;  // mm; marks a corner that does not reach the fillet

// Returns the least value of f on [0, 1], or none if every sampled value is kFarAway.
std::optional<double> min_on(const std::function<double(double)>& f) {
  const auto [lo, hi, least] = least_node(f, 8);
  if (least == kFarAway) return std::nullopt;
  constexpr int kQuarterDigits = std::numeric_limits<double>::digits / 4;
  return std::min(least, boost::math::tools::brent_find_minima(f, lo, hi, kQuarterDigits).second);
}

}  // namespace

std::optional<double> fillet_clearance(const ParallelPair& pair, int which) {
  GW_EXPECTS(which == 1 || which == 2);
  const Gear& gear = pair.gears[which - 1];
  const Gear& mate = pair.gears[2 - which];
  if (!gear.tooth) return std::nullopt;  // an internal gear without a cutter
  const double a = pair.center_distance;
  const double play =
      (which == 1 ? pair.mesh.backlash.rotation[1] : pair.mesh.backlash.rotation[0]) / 2;
  const double z = std::abs(gear.spec.teeth);
  const double side = gear.side(), mate_side = mate.side();
  const Orbit orbit{a, z / std::abs(mate.spec.teeth), play, side, mate_side, std::numbers::pi / z};
  const auto clearance_of = [&](const Corner& corner) {
    std::optional<double> least;
    for (const Arc& arc : gear.tooth->outline.arcs) {
      if (arc.name != ArcName::root_fillet) continue;
      // If cos w is greater than c, the corner lies on the root side of the end of the arc.
      const double r = arc.end_point.norm();
      const double deep = a * a + corner.radius * corner.radius - r * r;
      const double c = side * deep / (2 * a * corner.radius);
      if (c >= 1.0) continue;  // the corner never reaches this depth
      const double w_end = std::acos(std::max(-1.0, c));
      // In an external gear, only the half of the path on the side of this fillet is examined. In
      // an internal gear, the corner of the pinion can reach the fillet on both halves of the path.
      const double from = side < 0.0 ? -w_end : 0.0;
      const auto gap = [&](double s) {
        const double w = from + s * (w_end - from);
        return signed_distance(arc, orbit.place(corner, -side * mate_side * w));
      };
      const auto [lo, hi, at_node] = least_node(gap, side < 0.0 ? 48 : 24);
      const double found =
          std::min(at_node, boost::math::tools::brent_find_minima(gap, lo, hi, kHalfDigits).second);
      if (!least || found < *least) least = found;
    }
    return least;
  };
  std::optional<double> least;
  const auto take = [&](const std::optional<double>& c) {
    if (c && (!least || *c < *least)) least = c;
  };
  for (const Corner& corner : tip_corners(mate)) take(clearance_of(corner));
  if (!mate.tooth) return least;
  // The point of a rounded tip that is closest to the fillet may lie within the rounding.
  for (const Arc& arc : mate.tooth->outline.arcs) {
    if (arc.name != ArcName::tip_fillet) continue;
    const auto at = [&](double u) {
      const Vec2 p = arc.point(u);
      return clearance_of({p.norm(), std::atan2(p.y(), p.x())}).value_or(kFarAway);
    };
    take(min_on(at));
  }
  return least;
}

}  // namespace gearwright
