#include "gearwright/pair/crossed_gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/math/lowest.hpp"
#include "gearwright/pair/gap_profile.hpp"

namespace gearwright::detail {

namespace {

// The frames of gears at rest. A is the gear whose tip moves, and B is its mating gear. The gaps
// are computed twice, with gear 1 and with gear 2 as A.
struct Own {};
struct Tip {};   // A
struct Mate {};  // B

struct Body {
  GapProfile profile;
  Pose<Housing, Own> place;
  double twist;  ///< 2π/p_z
  double half_face;
  double form_radius;  ///< radius at which the fillet ends
  int teeth;
};

Body body_of(const MountedGears& pair, int which) {
  const Gear& gear = pair.gears[which - 1];
  const auto form = gear.root_form_radius();
  return {GapProfile(gear.tooth->outline),
          Pose<Housing, Own>(which == 1 ? pair.pose_1().isometry() : pair.pose_2().isometry()),
          gear.twist(),
          gear.spec.face_width / 2,
          form.value_or(gear.tooth->tip_radius),
          gear.spec.teeth};
}

template <class Role>
Pose<Housing, Role> place_as(const Body& body) {
  return Pose<Housing, Role>(body.place.isometry());
}

/// A moving point of half a tooth: a corner, or a point of a rounded tip.
struct TipPoint {
  double rho, theta;
  OutlinePlace place;
};

/// The gap between a point of the tip of A and the outline of B.
struct TipGap {
  double value = std::numeric_limits<double>::infinity();  // rotation of B that closes the gap, rad
  double side = 1.0;
  double arm = 0.0;
  double turn_a = 0.0;
  Point<Tip> point;
  ArcName arc = ArcName::root_fillet;
};

/// The motion of a point of the tip of A past B. The point moves on a cylinder about the axis of A,
/// and azimuth and height on this cylinder give its positions.
class TipMotion {
 public:
  TipMotion(const Body& a, const Body& b, const TipPoint& tip)
      : a_(a), b_(b), tip_(tip), to_b_(place_as<Mate>(b).inverse() * place_as<Tip>(a)) {
    const Vec3 towards = (to_b_.inverse() * Point<Mate>{}).r;  // a point of the axis of B
    start_ = std::atan2(towards.y(), towards.x());
  }

  const Body& a() const { return a_; }
  const Body& b() const { return b_; }
  double rho() const { return tip_.rho; }
  /// Azimuth of the axis of B, in the frame of A.
  double start() const { return start_; }
  /// The direction of the axis of B, in the frame of A.
  Vec3 axis() const { return to_b_.inverse().axis(2); }
  Point<Tip> in_a(double angle, double z) const {
    return {Vec3(tip_.rho * std::cos(angle), tip_.rho * std::sin(angle), z)};
  }
  Point<Mate> in_b(double angle, double z) const { return to_b_ * in_a(angle, z); }

  TipGap at(double angle, double z) const {
    TipGap gap;
    gap.point = in_a(angle, z);
    const Vec3 q = (to_b_ * gap.point).r;
    const double rho = std::hypot(q.x(), q.y());
    const ProfileArc* arc = b_.profile.arc_at(rho);
    if (arc == nullptr || std::abs(q.z()) > b_.half_face) return gap;
    gap.turn_a = angle - tip_.theta - a_.twist * z;
    const double turn_b = -gap.turn_a * a_.teeth / b_.teeth;
    const double delta =
        std::remainder(std::atan2(q.y(), q.x()) - b_.twist * q.z() - turn_b, 2 * kPi / b_.teeth);
    const ProfilePlace place = arc->at_radius(rho);
    gap.value = std::abs(delta) - place.theta;
    gap.side = delta < 0.0 ? -1.0 : 1.0;
    gap.arm = std::abs(place.s) / std::hypot(1.0, b_.twist * place.s);
    gap.arc = arc->arc->name;
    return gap;
  }

 private:
  const Body& a_;
  const Body& b_;
  TipPoint tip_;
  Pose<Mate, Tip> to_b_;
  double start_;
};

// Returns a ψ next to the zero of `beyond`, at which `beyond` is still negative. `beyond` must be
// negative at `deepest` and must not be negative at `away`.
template <class F>
double crossing(const F& beyond, double deepest, double away, double z) {
  constexpr int kHalvings = 50;
  double in = deepest, out = away;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (in + out) / 2;
    (beyond(middle, z) < 0.0 ? in : out) = middle;
  }
  return in;
}

/// The gap as a function of (u, v) in [−1, 1]². outside() and inside() map (u, v) to a point of the
/// tip cylinder. outside() returns an empty GapOver if no point of the tip cylinder lies within the
/// form cylinder of B.
using GapOver = std::function<TipGap(double, double)>;

/// Returns the gap of an external pair. u maps to ψ, measured from the direction of the axis of B.
/// The part of the tip cylinder within the form cylinder of B is a strip, and v maps to the
/// position across this strip.
GapOver outside(const TipMotion& motion, double distance) {
  const double form = motion.b().form_radius;
  const Vec3 axis = motion.axis();
  const double across = -axis.x() * std::sin(motion.start()) + axis.y() * std::cos(motion.start());
  const double c = (distance - form) / motion.rho();
  const double reach = c < 1.0 ? std::acos(std::max(-1.0, c)) : 0.0;
  if (!(reach > 0.0)) return {};
  return [=, &motion](double u, double v) {
    const double psi = u * reach;
    const double d = distance - motion.rho() * std::cos(psi);
    const double wide = std::sqrt(std::max(0.0, (form - d) * (form + d)));
    const double z = (motion.rho() * std::sin(psi) * axis.z() + v * wide) / across;
    const double half = motion.a().half_face;
    return motion.at(motion.start() + psi, std::clamp(z, -half, half));
  };
}

/// Returns the gap of an internal pair. v maps to the height z on the face of A, and u maps to ψ on
/// the tip circle at this height. Only the part of the tip circle on the root side of the radius
/// `limit` of B is used.
GapOver inside(const TipMotion& motion, double limit) {
  const bool ring = side_of(motion.a().teeth) < 0.0;
  const double mesh = motion.start() + (ring ? 0.0 : kPi);
  // Returns the radial distance of a point from the radius `limit` of B. It is negative on the root
  // side of this radius.
  const auto beyond = [=, &motion](double psi, double z) {
    const Vec3 q = motion.in_b(mesh + psi, z).r;
    const double rho = std::hypot(q.x(), q.y());
    return ring ? rho - limit : limit - rho;
  };
  // A range of ψ in which the points lie on the root side of `limit`, and the ψ of the point that
  // lies farthest on this side. If all points lie on the other side, no Window exists.
  struct Window {
    double deepest, lo, hi;
  };
  const auto window_at = [=](double z) -> std::optional<Window> {
    const double deepest =
        place_of_least([&](double psi) { return beyond(psi, z); }, -kHalfPi, kHalfPi);
    if (!(beyond(deepest, z) < 0.0)) return std::nullopt;
    const auto end = [&](double away) {
      return beyond(away, z) < 0.0 ? away : crossing(beyond, deepest, away, z);
    };
    return Window{deepest, end(-kPi), end(kPi)};
  };
  // The windows are stored, because many pairs (u, v) share a height z.
  const auto windows = std::make_shared<std::map<double, std::optional<Window>>>();
  return [=, &motion](double u, double v) {
    const double z = v * motion.a().half_face;
    auto found = windows->find(z);
    if (found == windows->end()) found = windows->emplace(z, window_at(z)).first;
    const std::optional<Window>& w = found->second;
    if (!w) return TipGap{};
    const double end = u < 0.0 ? w->lo : w->hi;
    return motion.at(mesh + w->deepest + std::abs(u) * (end - w->deepest), z);
  };
}

struct Node {
  double x, y;
  TipGap gap;
};

// Returns the gaps at the nodes of a grid, column by column. The columns divide u, the rows v.
std::vector<Node> grid_of(const GapOver& gap_at, int columns, int rows) {
  std::vector<Node> nodes;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double u = -1.0 + 2.0 * i / (columns - 1), v = -1.0 + 2.0 * j / (rows - 1);
      nodes.push_back({u, v, gap_at(u, v)});
    }
  }
  return nodes;
}

// Searches for the minimum from a node. Each step goes to the minimum of the quadratic function
// through nine points around the current point, whose distance h decreases from step to step.
TipGap descend(const GapOver& gap_at, const Node& from, double h) {
  constexpr int kSteps = 14;
  constexpr double kCloser = 0.4;
  TipGap best = from.gap;
  double x = from.x, y = from.y;
  for (int step = 0; step < kSteps && std::isfinite(best.value); ++step, h *= kCloser) {
    std::array<std::array<double, 3>, 3> f{};
    const double x_0 = std::clamp(x, -1.0 + h, 1.0 - h), y_0 = std::clamp(y, -1.0 + h, 1.0 - h);
    const auto ask = [&](double u, double v) {
      const auto gap = gap_at(std::clamp(u, -1.0, 1.0), std::clamp(v, -1.0, 1.0));
      if (gap.value < best.value) {
        best = gap;
        x = std::clamp(u, -1.0, 1.0);
        y = std::clamp(v, -1.0, 1.0);
      }
      return gap.value;
    };
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        f[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
            ask(x_0 + (i - 1) * h, y_0 + (j - 1) * h);
    }
    const double f_x = (f[2][1] - f[0][1]) / 2, f_y = (f[1][2] - f[1][0]) / 2;
    const double f_xx = f[2][1] - 2 * f[1][1] + f[0][1], f_yy = f[1][2] - 2 * f[1][1] + f[1][0];
    const double f_xy = (f[2][2] - f[2][0] - f[0][2] + f[0][0]) / 4;
    const double det = f_xx * f_yy - f_xy * f_xy;
    if (!(det > 0.0) || !(f_xx > 0.0)) continue;  // f has no minimum; only h decreases
    const double dx = std::clamp((-f_yy * f_x + f_xy * f_y) / det, -2.0, 2.0);
    const double dy = std::clamp((-f_xx * f_y + f_xy * f_x) / det, -2.0, 2.0);
    ask(x_0 + dx * h, y_0 + dy * h);
  }
  return best;
}

// Returns the least gap of an external pair. The search starts at the best node of a uniform grid.
TipGap least_outside(const GapOver& gap_at) {
  constexpr int kGrid = 9;
  const std::vector<Node> nodes = grid_of(gap_at, kGrid, kGrid);
  const auto best = std::min_element(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) {
    return a.gap.value < b.gap.value;
  });
  return descend(gap_at, *best, 1.0 / (kGrid - 1));
}

// Returns the least gap of an internal pair. The tip passes several teeth of B, so the gap may have
// several minima. A search starts from every node that has no neighbour with a smaller gap.
TipGap least_inside(const GapOver& gap_at) {
  constexpr int kColumns = 49, kRows = 9;
  const std::vector<Node> nodes = grid_of(gap_at, kColumns, kRows);
  const auto value = [&](int i, int j) {
    const bool within = i >= 0 && i < kColumns && j >= 0 && j < kRows;
    return within ? nodes[static_cast<std::size_t>(i * kRows + j)].gap.value
                  : std::numeric_limits<double>::infinity();
  };
  TipGap best;
  for (int i = 0; i < kColumns; ++i) {
    for (int j = 0; j < kRows; ++j) {
      const double here = value(i, j);
      if (!std::isfinite(here)) continue;
      if (here > std::min({value(i - 1, j), value(i + 1, j), value(i, j - 1), value(i, j + 1)}))
        continue;
      const TipGap gap =
          descend(gap_at, nodes[static_cast<std::size_t>(i * kRows + j)], 1.0 / (kColumns - 1));
      if (gap.value < best.value) best = gap;
    }
  }
  return best;
}

std::vector<TipPoint> tip_points(const Body& body) {
  constexpr int kPlaces = 16;
  std::vector<TipPoint> points;
  for (const ProfileCorner& c : body.profile.corners()) {
    if (c.rho > body.form_radius) points.push_back({c.rho, c.theta, {c.name, true}});
  }
  for (const ProfileArc& arc : body.profile.arcs()) {
    if (arc.arc->name != ArcName::tip_fillet) continue;
    for (int i = 0; i <= kPlaces; ++i) {
      const ProfilePlace p = arc.at(static_cast<double>(i) / kPlaces);
      points.push_back({p.rho, p.theta, {ArcName::tip_fillet, false}});
    }
  }
  return points;
}

}  // namespace

std::vector<OutlineTouch> crossed_gaps(const CrossedPair& pair) {
  GW_EXPECTS(pair.gears[0].tooth && pair.gears[1].tooth);
  const std::array<Body, 2> bodies{body_of(pair, 1), body_of(pair, 2)};
  const double ratio = static_cast<double>(bodies[0].teeth) / bodies[1].teeth;
  std::vector<OutlineTouch> touches;
  for (const std::size_t i : {0U, 1U}) {
    const Body& a = bodies[i];
    const Body& b = bodies[1 - i];
    std::optional<OutlineTouch> at_fillet, at_flank;
    const auto take = [&](const TipPoint& tip, const TipGap& gap,
                          std::optional<OutlineTouch>& least) {
      if (!std::isfinite(gap.value)) return;
      OutlineTouch t;
      t.gap = i == 0 ? gap.value : gap.value * std::abs(ratio);
      t.arm = i == 0 ? gap.arm : gap.arm / std::abs(ratio);
      if (least && least->gap <= t.gap) return;
      const double turn_b = gap.side * gap.value;
      // For the tip of gear 2, the gap is a rotation of gear 1. Both gears are therefore turned
      // back together until gear 1 is at its original rotation.
      const double turn_1 =
          i == 0 ? gap.turn_a : -gap.turn_a * bodies[1].teeth / bodies[0].teeth + turn_b;
      t.rotation_1 = -std::remainder(turn_1, 2 * kPi / bodies[0].teeth);
      t.turn_2 = i == 0 ? turn_b : ratio * turn_b;
      const Vec3 p = (place_as<Tip>(a) * gap.point).r;
      t.point = Vec2(p.x(), p.y());
      t.height = p.z();
      t.places[i] = tip.place;
      t.places[1 - i] = {gap.arc, false};
      least = t;
    };
    for (const TipPoint& tip : tip_points(a)) {
      const TipMotion motion(a, b, tip);
      if (!pair.crossed_inside()) {
        if (const GapOver gap_at = outside(motion, pair.center_distance))
          take(tip, least_outside(gap_at), at_fillet);
        continue;
      }
      take(tip, least_inside(inside(motion, b.form_radius)), at_fillet);
      take(tip, least_inside(inside(motion, b.profile.tip_radius())), at_flank);
    }
    if (at_fillet) touches.push_back(*at_fillet);
    if (at_flank && !(at_fillet && at_flank->gap >= at_fillet->gap)) touches.push_back(*at_flank);
  }
  return touches;
}

}  // namespace gearwright::detail
