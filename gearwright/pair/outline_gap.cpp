// Searches for the least gap between two outlines. The possible touches are divided into families,
// and each family has one parameter. [T2.29]…[T2.33]
//
//   A, B   the two gears; A moves in the frame of B, and either may be gear 1
//   D      position of the moving point W of A relative to the axis of B, in the frame of the mesh
//   ψ      angle of this point in the space of B, from the middle of the space
//   g = π/z_B − θ_B(|D|) − |ψ|   gap as a rotation of B, rad; if B is gear 1, it is converted to a
//                                rotation of gear 2 by the factor z_1/z_2
//   k        −1 if A is an internal gear, otherwise 1      ε = −σ,  κ = σ |z_A/z_B|
//
// The mesh lies at +x of the axis of A. A tooth of A is in the middle of a space of B at φ = 0, and
// B turns by −κφ. So D = k a + ε e^{iφ} W and ψ = arg D + κφ, reduced to one pitch.
#include "gearwright/pair/outline_gap.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/pair/envelope_nodes.hpp"
#include "gearwright/pair/gap_profile.hpp"
#include "gearwright/pair/least_gap.hpp"

namespace gearwright {

namespace {

using detail::EnvelopeNode;
using detail::EnvelopeNodes;
using detail::EnvelopePlace;
using detail::GapProfile;
using detail::GapSample;
using detail::LeastGap;
using detail::ProfileArc;
using detail::ProfileCorner;
using detail::ProfilePlace;
using detail::zero_between;

std::size_t index_of(ArcName name) { return static_cast<std::size_t>(name); }

struct Table {
  OutlineGap found;
  double limit;

  std::optional<OutlineTouch>& at(int entry) {
    return found.touches[static_cast<std::size_t>(entry) / OutlineGap::kNames]
                        [static_cast<std::size_t>(entry) % OutlineGap::kNames];
  }
};

struct Motion {
  const GapProfile& mover;
  const GapProfile& asked;
  Table& table;
  double a;
  bool first_moves;  ///< A is gear 1
  double side;       ///< σ of the pair, −1 if one gear is internal
  double k, epsilon, kappa;
  double pitch_radius;  ///< pitch radius of A
  double half_pitch;    ///< π/z_B
  double unit;          ///< factor from a rotation of B to a rotation of gear 2
  double to_arm;        ///< factor from an arm about the axis of B to an arm about axis 2

  Motion(const GapProfile& m, const GapProfile& b, Table& t, double distance, bool first)
      : mover(m), asked(b), table(t), a(distance), first_moves(first) {
    side = m.side() * b.side();
    const double ratio = static_cast<double>(m.teeth()) / b.teeth();
    k = m.side();
    epsilon = -side;
    kappa = side * ratio;
    const double sum = std::abs(b.teeth() + side * m.teeth());
    pitch_radius = a * m.teeth() / sum;
    half_pitch = kPi / b.teeth();
    unit = first ? 1.0 : 1.0 / ratio;
    to_arm = first ? 1.0 : ratio;
  }

  struct Gap {
    double value;  ///< gap as a rotation of B, rad
    double side;   ///< sign of ψ
    double lost;   ///< greatest possible rounding error of the value
  };
  // If the outline of B runs along a circle about the axis of B, an error in the last digit of the
  // radius can change the angle by more than the gap. For such a touch, the function records the
  // greatest gap that is possible within this error.
  Gap gap_of(const ProfilePlace& b, double psi) const {
    constexpr double kRounding = std::numeric_limits<double>::epsilon();
    const double reduced = std::remainder(psi, 2 * half_pitch);
    const double lost = kRounding * (a + b.rho) * std::abs(b.q / (b.s * b.rho));
    return {half_pitch - b.theta - std::abs(reduced), reduced < 0.0 ? -1.0 : 1.0, lost};
  }

  int entry(ArcName of_mover, ArcName of_asked) const {
    const auto i = static_cast<int>(of_mover), j = static_cast<int>(of_asked);
    return first_moves ? i * OutlineGap::kNames + j : j * OutlineGap::kNames + i;
  }

  /// Returns a limit, as a rotation of B, above which gaps need not be exact.
  double known(int e) const {
    const auto& touch = table.at(e);
    return (touch ? std::min(touch->gap, table.limit) : table.limit) / unit;
  }

  void keep(int e, const Gap& gap, double arm, double phi, const Vec2& in_mesh,
            OutlinePlace of_mover, OutlinePlace of_asked) const {
    ++table.found.evaluations;
    auto& touch = table.at(e);
    const double value = (gap.value + gap.lost) * unit;
    if (touch && touch->gap <= value) return;
    OutlineTouch t;
    t.gap = value;
    t.arm = arm * to_arm;
    const double turn = -gap.side * gap.value;  // rotation of B, counter-clockwise
    double phi_1 = phi;
    if (first_moves) {
      t.turn_2 = turn;
      t.point = side * in_mesh;
      t.places = {of_mover, of_asked};
    } else {
      // Both gears are turned back until gear 1 is at its original rotation.
      phi_1 = -kappa * phi + half_pitch + turn;
      t.turn_2 = side * unit * turn;
      t.point = Vec2(a - in_mesh.x(), -in_mesh.y());
      t.places = {of_asked, of_mover};
    }
    const int teeth_1 = first_moves ? mover.teeth() : asked.teeth();
    t.rotation_1 = -std::remainder(phi_1, 2 * kPi / teeth_1);
    touch = t;
  }
};

/// The gap between an arc of A and an arc of B. The normal at a point of the arc of A passes
/// through the pitch point in two positions of A, one for each branch. The gap is computed in these
/// positions. [T2.31]
class ArcFamily {
 public:
  ArcFamily(const Motion& motion, const ProfileArc& arc, double branch)
      : m_(motion), arc_(arc), branch_(branch) {}

  void ask(const ProfileArc& asked) {
    asked_ = &asked;
    entry_ = m_.entry(arc_.arc->name, asked.arc->name);
  }
  double known() const { return m_.known(entry_); }

  EnvelopePlace envelope(double u) const {
    const ProfilePlace p = arc_.at(u);
    const Position at = position(p);
    // With respect to arc length, s′ = 1 + k q and τ′ = k (gap_profile.hpp), where k is the
    // curvature of the outline. The slope of the envelope is infinite where both branches meet, so
    // it is multiplied by |sin(τ + φ)|, which is 0 there. k is infinite where an involute begins,
    // so the slope is also multiplied by `scale`. Along an involute, s′ is 0 within rounding.
    const double scale = 1.0 / (1.0 + std::abs(p.curvature) * m_.pitch_radius);
    const double bend =
        scale > 0.0 ? p.curvature * scale : std::copysign(1.0 / m_.pitch_radius, p.curvature);
    constexpr double kRounding = 1e-13;
    double pace = scale + bend * p.q;
    if (std::abs(pace) < kRounding) pace = 0.0;
    const double turn = -branch_ * pace / m_.pitch_radius - bend * std::abs(at.across);
    const double x = scale * std::abs(at.across) - turn * p.q;
    const double y = turn * p.s;
    const Vec2 run(x * at.along - y * at.across, x * at.across + y * at.along);
    return {m_.pitch_radius - std::abs(p.s), p.s < 0.0 ? pace : -pace, at.d.norm(),
            m_.epsilon * at.d.dot(run)};
  }

  GapSample sample(double u) const {
    const ProfilePlace p = arc_.at(u);
    const Position at = position(p);
    const ProfilePlace b = asked_->at_radius(at.d.norm());
    const double phi = std::atan2(at.across, at.along) - p.tau;
    const auto gap = m_.gap_of(b, std::atan2(at.d.y(), at.d.x()) + m_.kappa * phi);
    // The envelope is parallel to the tangent of the outline of A.
    const double radial = m_.epsilon * (at.along * at.d.x() + at.across * at.d.y());
    const double around = m_.epsilon * (at.across * at.d.x() - at.along * at.d.y());
    m_.keep(entry_, gap, std::abs(b.s), phi, at.w, {arc_.arc->name, false},
            {asked_->arc->name, false});
    return {gap.value, b.q * radial - gap.side * around * b.s, gap.lost};
  }

 private:
  struct Position {
    double along, across;  ///< components of the tangent, e^{i(τ + φ)}
    Vec2 w, d;             ///< the point in the mesh, relative to the axes of A and B
  };
  Position position(const ProfilePlace& p) const {
    const double c = std::clamp(p.s / m_.pitch_radius, -1.0, 1.0);
    const double s = branch_ * std::sqrt((1.0 - c) * (1.0 + c));
    const Vec2 w(p.s * c - p.q * s, p.s * s + p.q * c);
    return {c, s, w, {m_.k * m_.a + m_.epsilon * w.x(), m_.epsilon * w.y()}};
  }

  const Motion& m_;
  const ProfileArc& arc_;
  double branch_;
  const ProfileArc* asked_ = nullptr;
  int entry_ = 0;
};

/// The gap between a corner of A and an arc of B, as a function of t. t gives the parameter of the
/// arc, u = u_0 + (1 − u_0) t². [T2.32]
class CornerFamily {
 public:
  CornerFamily(const Motion& motion, const ProfileCorner& corner, const ProfileArc& arc)
      : m_(motion), corner_(corner), arc_(arc) {
    side_ = m_.asked.side();
    deepest_ = std::abs(m_.a - side_ * corner.rho);
    entry_ = m_.entry(corner.name, arc.arc->name);
    const double at_root = excess(arc.rho_root);
    const double at_tip = excess(arc.rho_tip);
    reaches_ = at_tip > 0.0 && at_root < 2.0;
    if (!reaches_) return;
    if (at_root <= 0.0) {
      u_0_ = arc.u_at_radius(deepest_);
      if (!(u_0_ < 1.0)) reaches_ = false;
    } else {
      // The u at which a straight line through the values of excess() at both ends of the arc is 0.
      u_0_ = -at_root / (at_tip - at_root);
      t_0_ = std::sqrt(-u_0_ / (1.0 - u_0_));
    }
  }

  bool reaches() const { return reaches_; }
  double t_begin() const { return t_0_; }
  void take_branch(double branch) { branch_ = branch; }
  double known() const { return m_.known(entry_); }

  GapSample sample(double t) const {
    const double u = std::clamp(u_0_ + (1.0 - u_0_) * t * t, 0.0, 1.0);
    const ProfilePlace b = arc_.at(u);
    const double x = std::clamp(excess(b.rho), 0.0, 2.0);
    const double w = 2 * branch_ * std::asin(std::sqrt(0.5 * x));
    const double c = 1.0 - x;
    const double s = branch_ * std::sqrt(x * (2.0 - x));
    const double phi = w - corner_.theta;
    const Vec2 p(corner_.rho * c, corner_.rho * s);
    const Vec2 d(m_.k * m_.a + m_.epsilon * p.x(), m_.epsilon * p.y());
    const auto gap = m_.gap_of(b, std::atan2(d.y(), d.x()) + m_.kappa * phi);
    // `radial` and `across` are the parts of D'/D, D' = iε ρ_c e^{iw}, for the corner's radius ρ_c.
    const double square = d.squaredNorm();
    const double radial = m_.epsilon * (p.x() * d.y() - p.y() * d.x()) / square;
    const double across = m_.epsilon * (p.x() * d.x() + p.y() * d.y()) / square;
    m_.keep(entry_, gap, std::abs(b.s), phi, p, {corner_.name, true}, {arc_.arc->name, false});
    return {gap.value, b.q * radial - gap.side * (across + m_.kappa) * b.s, gap.lost};
  }

 private:
  // Returns 1 − cos w for the position in which the corner passes through the radius ρ of B. w is
  // the angle between the corner and the centre line.
  double excess(double rho) const {
    return side_ * (rho - deepest_) * (rho + deepest_) / (2 * m_.a * corner_.rho);
  }

  const Motion& m_;
  const ProfileCorner& corner_;
  const ProfileArc& arc_;
  double side_, deepest_, u_0_ = 0.0, t_0_ = 0.0, branch_ = 1.0;
  int entry_;
  bool reaches_;
};

void collide_with_corners(const Motion& motion) {
  for (const ProfileCorner& corner : motion.mover.corners()) {
    for (const ProfileArc& arc : motion.asked.arcs()) {
      CornerFamily family(motion, corner, arc);
      if (!family.reaches()) continue;
      for (const double branch : {1.0, -1.0}) {
        family.take_branch(branch);
        LeastGap(family, family.t_begin(), 1.0);
      }
    }
  }
}

// Divides an arc of A into parts that each meet one arc of B, and finds the least gap of each.
void collide_with_arc(const Motion& motion, const ProfileArc& arc, double branch) {
  ArcFamily family(motion, arc, branch);
  const EnvelopeNodes nodes([&](double u) { return family.envelope(u); });
  for (const ProfileArc& b : motion.asked.arcs()) {
    const double lo = std::min(b.rho_root, b.rho_tip);
    const double hi = std::max(b.rho_root, b.rho_tip);
    const auto meets = [&](double rho) { return rho >= lo && rho <= hi; };
    // The next arc of B continues where this arc ends, so small errors of the crossing do no harm.
    constexpr double kNear = 1e-7;  // accuracy of u
    const auto crossing = [&](const EnvelopeNode& one, const EnvelopeNode& two, double limit) {
      return zero_between([&](double u) { return family.envelope(u).radius - limit; }, one.u,
                          one.radius - limit, two.u, two.radius - limit, kNear,
                          limit == lo ? -1.0 : 1.0);
    };
    family.ask(b);
    bool inside = false;
    double begin = 0.0;
    const auto begin_at = [&](double u) {
      inside = true;
      begin = u;
    };
    const auto end_at = [&](double u) {
      if (inside && begin < u) LeastGap(family, begin, u);
      inside = false;
    };
    const EnvelopeNode* last = nullptr;
    for (const EnvelopeNode& two : nodes) {
      if (two.begins) {
        if (last) end_at(last->u);
        if (meets(two.radius)) begin_at(two.u);
      } else if (const EnvelopeNode& one = *last; !meets(one.radius) || !meets(two.radius)) {
        // The envelope enters the range of radii of b, or passes through the whole range.
        if (!meets(one.radius) && (meets(two.radius) || (one.radius < lo) == (two.radius > hi)))
          begin_at(crossing(one, two, one.radius < lo ? lo : hi));
        if (!meets(two.radius) && inside) end_at(crossing(one, two, two.radius < lo ? lo : hi));
      }
      last = &two;
    }
    if (last) end_at(last->u);
  }
}

void collide_with_arcs(const Motion& motion) {
  for (const ProfileArc& arc : motion.mover.arcs()) {
    for (const double branch : {1.0, -1.0}) collide_with_arc(motion, arc, branch);
  }
}

}  // namespace

const std::optional<OutlineTouch>& OutlineGap::of(ArcName arc_1, ArcName arc_2) const {
  return touches[index_of(arc_1)][index_of(arc_2)];
}

std::optional<OutlineTouch> OutlineGap::least() const {
  std::optional<OutlineTouch> least = of(ArcName::flank, ArcName::flank);
  if (const auto other = least_beyond_flanks(); other && (!least || other->gap < least->gap))
    least = other;
  return least;
}

std::optional<OutlineTouch> OutlineGap::least_beyond_flanks() const {
  std::optional<OutlineTouch> least;
  for (const Row& row : touches) {
    for (const auto& touch : row) {
      if (!touch || (least && least->gap <= touch->gap)) continue;
      if (touch->places[0].arc == ArcName::flank && touch->places[1].arc == ArcName::flank)
        continue;
      least = touch;
    }
  }
  return least;
}

OutlineGap outline_gap(const Outline& gear_1, const Outline& gear_2, double center_distance,
                       double limit) {
  GW_EXPECTS(gear_1.teeth > 0 && center_distance > 0.0);
  GW_EXPECTS(gear_2.teeth > 0 || -gear_2.teeth > gear_1.teeth);
  const GapProfile one(gear_1);
  const GapProfile two(gear_2);
  Table table{{}, limit};
  const Motion first(one, two, table, center_distance, true);
  const Motion second(two, one, table, center_distance, false);
  collide_with_arcs(first);
  collide_with_corners(first);
  collide_with_corners(second);
  return table.found;
}

}  // namespace gearwright
