#include "gearwright/pair/crossed_gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/pair/gap_profile.hpp"

namespace gearwright::detail {

namespace {

struct Body {
  GapProfile profile;
  Eigen::Isometry3d place;  ///< gear to housing, at rest
  double twist;             ///< 2π/p_z
  double half_face;
  double form_radius;  ///< where the fillet ends, in the reach of the mating gear
  int teeth;
};

Body body_of(const MountedGears& pair, int which) {
  const Gear& gear = pair.gears[static_cast<std::size_t>(which - 1)];
  const auto form = gear.root_form_radius();
  return {GapProfile(gear.tooth->outline),
          which == 1 ? pair.pose_1().isometry() : pair.pose_2().isometry(),
          gear.twist(),
          gear.spec.face_width / 2,
          form.value_or(gear.tooth->tip_radius),
          gear.spec.teeth};
}

/// A moving point of half a tooth: a corner, or a point of a rounded tip.
struct TipPoint {
  double rho, theta;
  OutlinePlace place;
};

/// The tip of A at the root of B, over the places (ψ, v) of A's cylinder: ψ from the direction
/// of axis B, v across the strip that lies within the form cylinder of B.
class TipMotion {
 public:
  TipMotion(const Body& a, const Body& b, double distance, const TipPoint& tip)
      : a_(a), b_(b), tip_(tip), to_b_(b.place.inverse() * a.place) {
    const Vec3 towards = to_b_.inverse() * Vec3::Zero();  // a point of axis B, in A
    const Vec3 axis = to_b_.linear().transpose() * Vec3(0, 0, 1);
    start_ = std::atan2(towards.y(), towards.x());
    along_ = axis.z();
    across_ = -axis.x() * std::sin(start_) + axis.y() * std::cos(start_);
    distance_ = distance;
    const double c = (distance - b.form_radius) / tip.rho;
    reach_ = c < 1.0 ? std::acos(std::max(-1.0, c)) : 0.0;
  }

  bool reaches() const { return reach_ > 0.0; }
  double reach() const { return reach_; }

  struct Gap {
    double value = std::numeric_limits<double>::infinity();  // of B
    double side = 1.0;
    double arm = 0.0;
    double turn_a = 0.0;
    Vec3 point = Vec3::Zero();  // in A at rest
    ArcName arc = ArcName::root_fillet;
  };

  Gap at(double psi, double v) const {
    const double d = distance_ - tip_.rho * std::cos(psi);
    const double wide = std::sqrt(std::max(0.0, (b_.form_radius - d) * (b_.form_radius + d)));
    double z = (tip_.rho * std::sin(psi) * along_ + v * wide) / across_;
    z = std::clamp(z, -a_.half_face, a_.half_face);
    Gap gap;
    const double angle = start_ + psi;
    gap.point = Vec3(tip_.rho * std::cos(angle), tip_.rho * std::sin(angle), z);
    const Vec3 q = to_b_ * gap.point;
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
  Eigen::Isometry3d to_b_;
  double start_, along_, across_, distance_, reach_;
};

// The least gap over the places: the best of a grid, then steps to the extreme of the quadratic
// through nine places around it, with decreasing distances.
TipMotion::Gap least_of(const TipMotion& motion) {
  constexpr int kGrid = 9;
  constexpr int kSteps = 14;
  constexpr double kCloser = 0.4;
  TipMotion::Gap best;
  double x = 0.0, y = 0.0;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const double u = -1.0 + 2.0 * i / (kGrid - 1), v = -1.0 + 2.0 * j / (kGrid - 1);
      const auto gap = motion.at(u * motion.reach(), v);
      if (gap.value >= best.value) continue;
      best = gap;
      x = u;
      y = v;
    }
  }
  double h = 1.0 / (kGrid - 1);
  for (int step = 0; step < kSteps && std::isfinite(best.value); ++step, h *= kCloser) {
    std::array<std::array<double, 3>, 3> f{};
    const double x_0 = std::clamp(x, -1.0 + h, 1.0 - h), y_0 = std::clamp(y, -1.0 + h, 1.0 - h);
    const auto ask = [&](double u, double v) {
      const auto gap =
          motion.at(std::clamp(u, -1.0, 1.0) * motion.reach(), std::clamp(v, -1.0, 1.0));
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
    if (!(det > 0.0) || !(f_xx > 0.0)) continue;  // no minimum there, so the next step is shorter
    const double dx = std::clamp((-f_yy * f_x + f_xy * f_y) / det, -2.0, 2.0);
    const double dy = std::clamp((-f_xx * f_y + f_xy * f_x) / det, -2.0, 2.0);
    ask(x_0 + dx * h, y_0 + dy * h);
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

std::vector<OutlineTouch> crossed_gaps(const MountedGears& pair) {
  GW_EXPECTS(pair.crossed() && pair.gears[0].tooth && pair.gears[1].tooth);
  const std::array<Body, 2> bodies{body_of(pair, 1), body_of(pair, 2)};
  std::vector<OutlineTouch> touches;
  for (const std::size_t i : {0U, 1U}) {
    const Body& a = bodies[i];
    const Body& b = bodies[1 - i];
    std::optional<OutlineTouch> least;
    for (const TipPoint& tip : tip_points(a)) {
      const TipMotion motion(a, b, pair.center_distance, tip);
      if (!motion.reaches()) continue;
      const auto gap = least_of(motion);
      if (!std::isfinite(gap.value)) continue;
      const double ratio = static_cast<double>(bodies[0].teeth) / bodies[1].teeth;
      OutlineTouch t;
      t.gap = i == 0 ? gap.value : gap.value * ratio;
      t.arm = i == 0 ? gap.arm : gap.arm / ratio;
      if (least && least->gap <= t.gap) continue;
      const double turn_b = gap.side * gap.value;
      // For the tip of gear 2, gear 1 was turned, so both are turned back until only gear 2 has
      // turned.
      const double turn_1 =
          i == 0 ? gap.turn_a : -gap.turn_a * bodies[1].teeth / bodies[0].teeth + turn_b;
      t.rotation_1 = -std::remainder(turn_1, 2 * kPi / bodies[0].teeth);
      t.turn_2 = i == 0 ? turn_b : ratio * turn_b;
      const Vec3 p = a.place * gap.point;
      t.point = Vec2(p.x(), p.y());
      t.height = p.z();
      t.places[i] = tip.place;
      t.places[1 - i] = {gap.arc, false};
      least = t;
    }
    if (least) touches.push_back(*least);
  }
  return touches;
}

}  // namespace gearwright::detail
