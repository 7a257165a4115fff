#include "gearwright/generation/branch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/refusal.hpp"
#include "gearwright/curve/basic_curves.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright::detail {

double Branch::t_at(double h) const {
  if (h <= height_lo) return t_lo;
  if (h >= height_hi) return t_hi;
  return side > 0.0 ? curve->parameter_at_radius(h, t_lo, t_hi)
                    : curve->parameter_at_radius(-h, t_hi, t_lo);
}

void Branch::end_at(double h) {
  t_hi = t_at(h);
  height_hi = h;
}

void Branch::start_at(double h) {
  t_lo = t_at(h);
  height_lo = h;
}

Branch branch_of(ArcName name, CurvePtr curve, double t_lo, double t_hi, double side) {
  const double lo = side * curve->point(t_lo).norm();
  const double hi = side * curve->point(t_hi).norm();
  return {name, std::move(curve), t_lo, t_hi, lo, hi, false, side};
}

namespace {

// How the outline goes on from `last` to `next`.
struct Joint {
  enum Kind { at_height, last_hidden, next_hidden } kind;
  double height = 0.0;
};

// The height in [lo, hi] at which last's half angle, smaller at lo, becomes the larger one.
double crossing(const Branch& last, const Branch& next, double lo, double hi) {
  if (last.curve->radius_is_closed_form() && next.curve->radius_is_closed_form()) {
    const auto gap = [&](double h) { return last.theta_at(h) - next.theta_at(h); };
    const Root root = find_root(gap, lo, hi);
    GW_ENSURES(root.found());
    return root.x;
  }
  // Solve in the parameter of the branch that has no closed radius: no root inside a root.
  const bool by_last = !last.curve->radius_is_closed_form();
  const Branch& free = by_last ? last : next;
  const Branch& other = by_last ? next : last;
  const auto gap_t = [&](double t) {
    const double difference = free.curve->polar_angle(t) - other.theta_at(free.height(t));
    return by_last ? difference : -difference;
  };
  const double t_a = free.t_at(lo);
  const double t_b = free.t_at(hi);
  return free.height(find_root(gap_t, std::min(t_a, t_b), std::max(t_a, t_b)).x);
}

// The tooth is the lower envelope of the half angles. It has no jump; so where the radii of the two
// only touch, or where one ends without having crossed the other, they share that point up to
// rounding (undercut that begins just here, a corner of the edge on the pitch line).
Joint joint(const Branch& last, const Branch& next) {
  const double lo = std::max(last.height_lo, next.height_lo);
  double hi = std::min(last.height_hi, next.height_hi);
  const auto gap = [&](double h) { return last.theta_at(h) - next.theta_at(h); };
  if (!(lo < hi)) {
    if (last.height_hi <= next.height_lo) return {Joint::at_height, last.height_hi};
    return {Joint::last_hidden};  // unless what came before hides `next` too
  }
  if (gap(lo) >= 0.0) {
    if (next.height_lo > last.height_lo) return {Joint::at_height, lo};
    return {Joint::last_hidden};
  }
  if (std::isinf(hi)) {  // both straight: the one that rises less steeply wins far out
    hi = 2.0 * lo;
    while (gap(hi) < 0.0 && hi < 1e6 * lo) hi *= 2.0;
  }
  if (gap(hi) > 0.0) return {Joint::at_height, crossing(last, next, lo, hi)};
  if (last.height_hi < next.height_hi) return {Joint::at_height, hi};
  return {Joint::next_hidden};
}

// What two ends that ought to be one point may differ by, of their radius: the root of ε, since a
// branch that begins along a circle about the axis (τ = π/2) has θ like the root of its radius.
constexpr double kSamePoint = 1.5e-8;

std::vector<Branch> assemble(const std::vector<Branch>& branches, double tip_height) {
  std::vector<Branch> chain;
  const Branch* before = nullptr;  // the branch that ends the chain, whole
  for (const Branch& branch : branches) {
    if (branch.height_lo >= tip_height && !chain.empty() && chain.back().height_hi >= tip_height)
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
    if (j.kind == Joint::at_height && j.height >= tip_height) continue;  // takes over in the air
    if (j.kind == Joint::last_hidden) {
      chain.clear();
    } else {
      chain.resize(kept);
      chain.back().end_at(j.height);
      next.start_at(j.height);
      const Vec2 a = chain.back().curve->point(chain.back().t_hi);
      const Vec2 b = next.curve->point(next.t_lo);
      GW_ENSURES((a - b).norm() <= kSamePoint * a.norm());
    }
    chain.push_back(next);
    before = &branch;
  }
  return chain;
}

// The first height at which `leaving` lies lower than the branch, between lo and hi.
std::optional<double> first_caught(const Branch& branch, const Branch& leaving, double lo,
                                   double hi) {
  constexpr int kCells = 32;
  const auto gap = [&](double h) { return branch.theta_at(h) - leaving.theta_at(h); };
  double before = lo;
  for (int i = 0; i <= kCells; ++i) {
    const double h = i == kCells ? hi : lo + (hi - lo) * i / kCells;
    if (gap(h) > 0.0) return i == 0 ? lo : find_root(gap, before, h).x;
    before = h;
  }
  return std::nullopt;
}

// Takes away what the leaving cutter catches. False: it does so from its first touch on, so that
// what came before it (its flank) has caught the tooth already.
bool trim_behind(std::vector<Branch>& chain, const Branch& leaving, double tip_height) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double lo = std::max(chain[i].height_lo, leaving.height_lo);
    const double hi = std::min({chain[i].height_hi, leaving.height_hi, tip_height});
    if (!(lo < hi)) continue;
    const auto caught = first_caught(chain[i], leaving, lo, hi);
    if (!caught) continue;
    if (*caught <= leaving.height_lo) return false;
    Branch rest = leaving;
    rest.start_at(*caught);
    chain[i].end_at(*caught);
    chain.resize(i + 1);
    chain.push_back(std::move(rest));
    return true;
  }
  return true;
}

// The smallest half angle of the root fillet, of what the tip leaves of it.
void find_neck(const std::vector<Branch>& chain, double tip_height, GeneratedTooth& tooth) {
  for (const Branch& branch : chain) {
    if (branch.name != ArcName::root_fillet || branch.height_lo >= tip_height) continue;
    const double t_end = branch.t_at(tip_height);
    std::vector<double> candidates{branch.t_lo, t_end};
    const auto [lo, hi] = std::minmax(branch.t_lo, t_end);
    for (double t : branch.turns) {
      if (t > lo && t < hi) candidates.push_back(t);
    }
    for (double t : candidates) {
      const double theta = branch.curve->polar_angle(t);
      if (!tooth.neck_half_angle || theta < *tooth.neck_half_angle) {
        tooth.neck_half_angle = theta;
        tooth.neck_radius = branch.curve->point(t).norm();
      }
    }
  }
}

// A fillet that ends the tooth on its centre line and a tip circle this close are one end.
constexpr double kSameEnd = 1e-12;

// Ends the chain at the tip circle, or where the tooth is pointed before that.
void end_at_tip(std::vector<Branch>& chain, double side, GeneratedTooth& tooth) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    Branch& branch = chain[i];
    const double tip = side * tooth.tip_radius;
    // The cutter's bottom rounding ends on the land's circle itself, up to rounding.
    const bool final = i + 1 == chain.size();
    if (final) GW_ENSURES(branch.height_hi >= tip - 1e-9 * tooth.tip_radius);
    const bool last = final || branch.height_hi >= tip;
    const double end = std::min(branch.height_hi, tip);
    if (branch.ends_on_center_line && branch.height_hi - end <= kSameEnd * tooth.tip_radius) {
      tooth.tip_radius = std::abs(branch.height_hi);
      tooth.rounded_tip = true;
    } else if (branch.theta_at(end) <= 0.0) {
      const auto theta = [&](double h) { return branch.theta_at(h); };
      tooth.tip_radius = std::abs(find_root(theta, branch.height_lo, end).x);
      tooth.pointed = true;
    }
    if (last || tooth.pointed) {
      if (side * tooth.tip_radius < branch.height_hi) branch.end_at(side * tooth.tip_radius);
      chain.resize(i + 1);
      return;
    }
  }
}

void write_outline(const std::vector<Branch>& chain, const ToothEnds& ends, GeneratedTooth& tooth) {
  Outline& outline = tooth.outline;
  outline.teeth = ends.teeth;
  const int z = std::abs(ends.teeth);
  const double half_pitch = std::numbers::pi / z;
  const auto root_circle = std::make_shared<AxisCircle>(tooth.root_radius);
  const SinCos middle = sincos_turn(1, 2LL * z);
  Vec2 joint = tooth.root_radius * Vec2(middle.cos, middle.sin);
  if (ends.root_land_angle < half_pitch * (1 - 1e-12)) {
    const Vec2 end = root_circle->point(ends.root_land_angle);
    outline.arcs.push_back(
        {ArcName::root_land, root_circle, half_pitch, ends.root_land_angle, joint, end});
    joint = end;
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Branch& branch = chain[i];
    Vec2 end = branch.curve->point(branch.t_hi);
    if (i + 1 == chain.size() && (tooth.pointed || tooth.rounded_tip))
      end = Vec2(tooth.tip_radius, 0.0);
    outline.arcs.push_back({branch.name, branch.curve, branch.t_lo, branch.t_hi, joint, end});
    joint = end;
  }
  if (!tooth.pointed && !tooth.rounded_tip) {
    const double theta_tip = chain.back().curve->polar_angle(chain.back().t_hi);
    outline.arcs.push_back({ArcName::tip_land, std::make_shared<AxisCircle>(tooth.tip_radius),
                            theta_tip, 0.0, joint, Vec2(tooth.tip_radius, 0.0)});
  }
}

}  // namespace

Result<GeneratedTooth> finish_tooth(const std::vector<Branch>& branches, const ToothEnds& ends,
                                    GeneratedTooth tooth) {
  const double side = ends.side;
  const auto nearer = [&](double a, double b) {
    return side > 0.0 ? std::min(a, b) : std::max(a, b);
  };
  tooth.tip_radius = nearer(ends.blank_radius, ends.cutter_radius);
  if (!(side * tooth.tip_radius > side * tooth.root_radius)) {
    return refused("tip_diameter_mm", 2 * ends.blank_radius,
                   fmt::format("must be {} than the root diameter {} mm",
                               side > 0.0 ? "greater" : "less", 2 * tooth.root_radius));
  }
  std::vector<Branch> chain = assemble(branches, side * tooth.tip_radius);
  GW_ENSURES(!chain.empty());
  for (const Branch& leaving : ends.behind) {
    if (trim_behind(chain, leaving, side * tooth.tip_radius)) continue;
    return Error{"cut_by", "",
                 "cut_by: the teeth of this cutter catch the ring's flanks as they leave; a cutter "
                 "of fewer teeth is needed, or a greater tip diameter"};
  }
  find_neck(chain, side * tooth.tip_radius, tooth);
  if (tooth.neck_half_angle && *tooth.neck_half_angle <= 0.0) {
    tooth.severed = true;
    return tooth;
  }
  end_at_tip(chain, side, tooth);
  tooth.tip_cut_by_rack =
      !tooth.pointed && !tooth.rounded_tip && side * ends.cutter_radius < side * ends.blank_radius;
  for (const Branch& branch : chain) {
    if (branch.name != ArcName::flank) continue;
    tooth.form_radius = std::abs(branch.height_lo);
    tooth.tip_form_radius = std::abs(branch.height_hi);
  }
  write_outline(chain, ends, tooth);
  return tooth;
}

}  // namespace gearwright::detail
