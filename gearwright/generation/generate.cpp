#include "gearwright/generation/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gearwright/base/angle.hpp"
#include "gearwright/math/polynomial.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A piece of envelope along which the radius grows from t_lo to t_hi.
struct Branch {
  ArcName name;
  CurvePtr curve;
  double t_lo, t_hi;
  double rho_lo, rho_hi;
  bool smooth_start;  // goes on from the end of the branch before
  const RackTrochoid* trochoid = nullptr;

  double t_at(double rho) const {
    if (rho <= rho_lo) return t_lo;
    if (rho >= rho_hi) return t_hi;
    return curve->parameter_at_radius(rho, t_lo, t_hi);
  }
  double theta_at(double rho) const { return curve->polar_angle(t_at(rho)); }
  void end_at(double rho) {
    t_hi = t_at(rho);
    rho_hi = rho;
  }
  void start_at(double rho) {
    t_lo = t_at(rho);
    rho_lo = rho;
  }
};

double radius_of(const Curve& curve, double t) { return curve.point(t).norm(); }

void add_line(std::vector<Branch>& branches, const RackMotion& motion, const EdgeArc& arc) {
  const EdgeLine& line = *arc.line;
  const double xi_begin = rack_involute_roll(motion, line, line.begin_height + motion.shift);
  const double xi_end = std::isinf(line.end_height)
                            ? kInfinity
                            : rack_involute_roll(motion, line, line.end_height + motion.shift);
  if (!(xi_end > 0.0)) return;  // all of it lies behind the cusp
  auto curve = std::make_shared<Involute>(rack_involute(motion, line));
  const double r_b = curve->base_radius();
  const auto radius = [&](double xi) {
    return std::isinf(xi) ? kInfinity : r_b * std::hypot(1.0, xi);
  };
  const double xi_lo = std::max(0.0, xi_begin);
  branches.push_back({arc.cuts, curve, xi_lo, xi_end, radius(xi_lo), radius(xi_end),
                      arc.smooth_start && xi_begin >= 0.0});
}

void add_circle(std::vector<Branch>& branches, const RackMotion& motion, const EdgeArc& arc) {
  const EdgeCircle& circle = *arc.circle;
  auto curve = std::make_shared<RackTrochoid>(motion, circle);
  const std::vector<double> f = curve->cusp_polynomial();
  const double direction = circle.end_tau > circle.begin_tau ? 1.0 : -1.0;
  const double s_a = std::sin(circle.begin_tau);
  const double s_b = std::sin(circle.end_tau);
  std::vector<double> cuts{circle.begin_tau};
  std::vector<double> cusps = polynomial_roots(f, std::min(s_a, s_b), std::max(s_a, s_b));
  if (direction < 0.0) std::reverse(cusps.begin(), cusps.end());
  for (double s : cusps) cuts.push_back(std::asin(std::min(1.0, s)));
  cuts.push_back(circle.end_tau);
  bool smooth = arc.smooth_start;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = std::sin(0.5 * (cuts[i] + cuts[i + 1]));
    const bool forward = evaluate_polynomial(f, middle) * direction > 0.0;
    if (forward) {
      branches.push_back({arc.cuts, curve, cuts[i], cuts[i + 1], radius_of(*curve, cuts[i]),
                          radius_of(*curve, cuts[i + 1]), smooth, curve.get()});
    }
    smooth = false;  // behind a cusp nothing goes on
  }
}

// How the outline goes on from `last` to `next`.
struct Joint {
  enum Kind { at_radius, last_hidden, next_hidden } kind;
  double rho = 0.0;
};

// The radius in [lo, hi] at which last's half angle, smaller at lo, becomes the larger one.
double crossing(const Branch& last, const Branch& next, double lo, double hi) {
  if (last.curve->radius_is_closed_form() && next.curve->radius_is_closed_form()) {
    const auto gap = [&](double rho) { return last.theta_at(rho) - next.theta_at(rho); };
    const Root root = find_root(gap, lo, hi);
    GW_ENSURES(root.found());
    return root.x;
  }
  // Solve in the parameter of the branch that has no closed radius: no root inside a root.
  const bool by_last = !last.curve->radius_is_closed_form();
  const Branch& free = by_last ? last : next;
  const Branch& other = by_last ? next : last;
  const auto gap_t = [&](double t) {
    const double rho = radius_of(*free.curve, t);
    const double difference = free.curve->polar_angle(t) - other.theta_at(rho);
    return by_last ? difference : -difference;
  };
  const double t_a = free.t_at(lo);
  const double t_b = free.t_at(hi);
  return radius_of(*free.curve, find_root(gap_t, std::min(t_a, t_b), std::max(t_a, t_b)).x);
}

// The tooth is the lower envelope of the half angles. It has no jump; so where the radii of the two
// only touch, or where one ends without having crossed the other, they share that point up to
// rounding (undercut that begins just here, a corner of the edge on the pitch line).
Joint joint(const Branch& last, const Branch& next) {
  const double lo = std::max(last.rho_lo, next.rho_lo);
  double hi = std::min(last.rho_hi, next.rho_hi);
  const auto gap = [&](double rho) { return last.theta_at(rho) - next.theta_at(rho); };
  if (!(lo < hi)) {
    if (last.rho_hi <= next.rho_lo) return {Joint::at_radius, last.rho_hi};
    return {Joint::last_hidden};  // unless what came before hides `next` too
  }
  if (gap(lo) >= 0.0) {
    if (next.rho_lo > last.rho_lo) return {Joint::at_radius, lo};
    return {Joint::last_hidden};
  }
  if (std::isinf(hi)) {  // both straight: the one that rises less steeply wins far out
    hi = 2.0 * lo;
    while (gap(hi) < 0.0 && hi < 1e6 * lo) hi *= 2.0;
  }
  if (gap(hi) > 0.0) return {Joint::at_radius, crossing(last, next, lo, hi)};
  if (last.rho_hi < next.rho_hi) return {Joint::at_radius, hi};
  return {Joint::next_hidden};
}

// What two ends that ought to be one point may differ by, of their radius: the root of ε, since a
// branch that begins along a circle about the axis (τ = π/2) has θ like the root of its radius.
constexpr double kSamePoint = 1.5e-8;

std::vector<Branch> assemble(const std::vector<Branch>& branches, double tip_radius) {
  std::vector<Branch> chain;
  const Branch* before = nullptr;  // the branch that ends the chain, whole
  for (const Branch& branch : branches) {
    if (branch.rho_lo >= tip_radius && !chain.empty() && chain.back().rho_hi >= tip_radius)
      continue;
    Branch next = branch;
    if (chain.empty() || (next.smooth_start && before == &branch - 1)) {
      chain.push_back(next);
      before = &branch;
      continue;
    }
    std::size_t kept = chain.size();
    Joint j = joint(chain[kept - 1], next);
    while (j.kind == Joint::last_hidden && kept > 1) {
      --kept;
      j = joint(chain[kept - 1], next);
    }
    if (j.kind == Joint::next_hidden) continue;
    if (j.kind == Joint::at_radius && j.rho >= tip_radius) continue;  // takes over in the air
    if (j.kind == Joint::last_hidden) {
      chain.clear();
    } else {
      chain.resize(kept);
      chain.back().end_at(j.rho);
      next.start_at(j.rho);
      const Vec2 a = chain.back().curve->point(chain.back().t_hi);
      const Vec2 b = next.curve->point(next.t_lo);
      GW_ENSURES((a - b).norm() <= kSamePoint * a.norm());
    }
    chain.push_back(next);
    before = &branch;
  }
  return chain;
}

// The smallest half angle of the root fillet, of what the tip leaves of it.
void find_neck(const std::vector<Branch>& chain, GeneratedTooth& tooth) {
  for (const Branch& branch : chain) {
    if (branch.name != ArcName::root_fillet || branch.rho_lo >= tooth.tip_radius) continue;
    const double t_end = branch.t_at(tooth.tip_radius);
    std::vector<double> candidates{branch.t_lo, t_end};
    if (branch.trochoid) {
      const double lo = std::min(branch.t_lo, t_end);
      const double hi = std::max(branch.t_lo, t_end);
      for (double t : branch.trochoid->neck_angles(lo, hi)) candidates.push_back(t);
    }
    for (double t : candidates) {
      const double theta = branch.curve->polar_angle(t);
      if (!tooth.neck_half_angle || theta < *tooth.neck_half_angle) {
        tooth.neck_half_angle = theta;
        tooth.neck_radius = radius_of(*branch.curve, t);
      }
    }
  }
}

// Ends the chain at the tip circle, or where the tooth is pointed before that.
void end_at_tip(std::vector<Branch>& chain, GeneratedTooth& tooth) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    Branch& branch = chain[i];
    // The cutter's bottom rounding ends on the land's circle itself, up to rounding.
    const bool final = i + 1 == chain.size();
    if (final) GW_ENSURES(branch.rho_hi >= tooth.tip_radius * (1 - 1e-9));
    const bool last = final || branch.rho_hi >= tooth.tip_radius;
    const double rho_end = std::min(branch.rho_hi, tooth.tip_radius);
    if (branch.theta_at(rho_end) <= 0.0) {
      const auto theta = [&](double rho) { return branch.theta_at(rho); };
      tooth.tip_radius = find_root(theta, branch.rho_lo, rho_end).x;
      tooth.pointed = true;
    }
    if (last || tooth.pointed) {
      if (tooth.tip_radius < branch.rho_hi) branch.end_at(tooth.tip_radius);
      chain.resize(i + 1);
      return;
    }
  }
}

void write_outline(const std::vector<Branch>& chain, double y_root_land, const RackMotion& motion,
                   int teeth, GeneratedTooth& tooth) {
  Outline& outline = tooth.outline;
  outline.teeth = teeth;
  const double half_pitch = std::numbers::pi / teeth;
  const double theta_root = y_root_land / (motion.cos_beta * motion.pitch_radius);
  const auto root_circle = std::make_shared<AxisCircle>(tooth.root_radius);
  const SinCos middle = sincos_turn(1, 2LL * teeth);
  Vec2 joint = tooth.root_radius * Vec2(middle.cos, middle.sin);
  if (theta_root < half_pitch * (1 - 1e-12)) {
    const Vec2 end = root_circle->point(theta_root);
    outline.arcs.push_back({ArcName::root_land, root_circle, half_pitch, theta_root, joint, end});
    joint = end;
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Branch& branch = chain[i];
    Vec2 end = branch.curve->point(branch.t_hi);
    if (i + 1 == chain.size() && tooth.pointed) end = Vec2(tooth.tip_radius, 0.0);
    outline.arcs.push_back({branch.name, branch.curve, branch.t_lo, branch.t_hi, joint, end});
    joint = end;
  }
  if (!tooth.pointed) {
    const double theta_tip = chain.back().curve->polar_angle(chain.back().t_hi);
    outline.arcs.push_back({ArcName::tip_land, std::make_shared<AxisCircle>(tooth.tip_radius),
                            theta_tip, 0.0, joint, Vec2(tooth.tip_radius, 0.0)});
  }
}

}  // namespace

Result<GeneratedTooth> cut_by_rack(const CutterEdge& edge, const RackMotion& motion, int teeth,
                                   double blank_radius) {
  GW_EXPECTS(teeth >= 1);
  GeneratedTooth tooth{};
  tooth.root_radius = motion.pitch_radius + motion.shift - edge.tip_depth;
  const double bottom_radius = motion.pitch_radius + motion.shift + edge.bottom_height;
  tooth.tip_radius = std::min(blank_radius, bottom_radius);
  if (!(tooth.root_radius > 0.0)) {
    tooth.through_axis = true;
    return tooth;
  }
  if (!(tooth.tip_radius > tooth.root_radius)) {
    return Error{"tip_diameter_mm", fmt::format("{}", 2 * blank_radius),
                 fmt::format("tip_diameter_mm = {}: must be greater than the root diameter {} mm",
                             2 * blank_radius, 2 * tooth.root_radius)};
  }

  std::vector<Branch> branches;
  for (const EdgeArc& arc : edge.arcs) {
    if (arc.line) add_line(branches, motion, arc);
    if (arc.circle) add_circle(branches, motion, arc);
  }
  std::vector<Branch> chain = assemble(branches, tooth.tip_radius);
  GW_ENSURES(!chain.empty());

  find_neck(chain, tooth);
  if (tooth.neck_half_angle && *tooth.neck_half_angle <= 0.0) {
    tooth.severed = true;
    return tooth;
  }
  end_at_tip(chain, tooth);
  tooth.tip_cut_by_rack = !tooth.pointed && bottom_radius < blank_radius;
  for (const Branch& branch : chain) {
    if (branch.name != ArcName::flank) continue;
    tooth.form_radius = branch.rho_lo;
    tooth.tip_form_radius = branch.rho_hi;
  }
  write_outline(chain, edge.tip_land_end, motion, teeth, tooth);
  return tooth;
}

}  // namespace gearwright
