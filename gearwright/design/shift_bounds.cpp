// Computes the bounds that each limit of the s1–s2 graph imposes on Σ, and on x1 for a given Σ.
//
// The bounds are solutions of the leaf formulas (pair/leaf_formulas.hpp) for a shift.
#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/design/shift_graph.hpp"
#include "gearwright/design/tip_curvature.hpp"

namespace gearwright {

using detail::lower;
using detail::radius_of;
using detail::raise;

namespace {

// Stores the tightest bounds of x1 on a line Σx = const, without the names of their limits.
struct Tightest : LineEnds {
  static constexpr bool kNamed = false;
  double& lo_of(ShiftEdge) { return lo; }
  double& hi_of(ShiftEdge) { return hi; }
};

}  // namespace

void ShiftGraph::bound_sliding(const SumPlace& at, double sum, double& lo, double& hi) const {
  // With t = ρ2/(u ρ1) at the ends A and E of the path, the limit |ζ| ≤ Z of the specific sliding
  // is equivalent to 1/(1 + Z) ≤ t ≤ 1 + Z. [T9.8]
  const double u = static_cast<double>(trial_.z2) / trial_.z1;
  const double most = 1.0 + *problem_->limits.sliding;
  const double A_1 = gears_[0].r + gears_[0].addendum + at.k;
  const double A_2 = gears_[1].r + gears_[1].addendum + at.k;
  const auto tip_1 = [&](double t) {
    const double q = at.N / (1.0 + t * u);
    return q > 0.0 ? radius_of(q, gears_[0].r_b) : kInfinity;
  };
  const auto tip_2 = [&](double t) {
    // ρ2 at this t. If its sign is not that of z2, no tip radius gives this t.
    const double q = t * u * at.N / (1.0 + t * u);
    return q * u > 0.0 ? radius_of(q, gears_[1].r_b) : kInfinity;
  };
  raise(lo, tip_1(most) - A_1);
  lower(hi, tip_1(1.0 / most) - A_1);
  if (internal_) {
    raise(lo, tip_2(most) + A_2 + sum);
    lower(hi, tip_2(1.0 / most) + A_2 + sum);
  } else {
    lower(hi, sum + A_2 - tip_2(1.0 / most));
    raise(lo, sum + A_2 - tip_2(most));
  }
}

// c_F is the form clearance, a distance along the line of action. It is measured from the start of
// a flank to the point of this flank that the mating tip touches. The conditions are ρ_1A ≥ ρ_F1 +
// c_F and ρ_2E ≥ ρ_F2 + c_F. For a given sum of the profile shifts, each condition has the form w
// q(u) ≤ c + s u. Here, u is the tip radius of the mating gear, and q is the curvature radius of
// the mating flank at its tip. Squaring the condition gives a quadratic in u. For an external pair,
// the condition is violated between the roots. [T9.9]
void ShiftGraph::bound_interference(const SumPlace& at, double sum, double& lo_2,
                                    double& hi_1) const {
  const auto greater_root = [](double w, double c, double s, double b) {
    const double disc = c * c - (s * s - w * w) * b * b;
    if (!(c < 0.0) || !(disc >= 0.0)) return -kInfinity;
    return (-c * s + w * std::sqrt(disc)) / (s * s - w * w);
  };
  const auto line = [&](std::size_t i, double A_mate) {
    const double s = start_slope_[i];
    const double c = at.N - problem_->limits.form_clearance -
                     weight_[i] * gears_[i].r * gears_[i].sin_transverse +
                     s * gears_[i].flank_depth - s * (sum + A_mate);
    return std::array<double, 2>{c, s};
  };
  const double A_1 = gears_[0].r + gears_[0].addendum + at.k;
  const double A_2 = gears_[1].r + gears_[1].addendum + at.k;
  if (!internal_) {
    const auto [c_1, s_1] = line(0, A_2);
    const auto [c_2, s_2] = line(1, A_1);
    lower(hi_1, sum + A_2 - greater_root(weight_[1], c_1, s_1, gears_[1].r_b));
    raise(lo_2, greater_root(weight_[0], c_2, s_2, gears_[0].r_b) - A_1);
    return;
  }
  // For the tip radius v = |u| of the internal gear, √(v² − b²) ≥ s v + c holds between the roots.
  const double s = 1.0 / gears_[0].sin_transverse;
  const double c = -at.N + problem_->limits.form_clearance +
                   gears_[0].r * gears_[0].sin_transverse - s * gears_[0].flank_depth +
                   s * (A_2 + sum);
  const double b = gears_[1].r_b;
  const double disc = c * c - (s * s - 1.0) * b * b;
  // If disc < 0, no value meets the condition, and the lower end exceeds the upper end. If disc =
  // 0, the ends coincide. The width of the interval is therefore a continuous function of Σ.
  const double middle = -s * c / (s * s - 1.0) + A_2 + sum;
  const double half = std::copysign(std::sqrt(std::abs(disc)), disc) / (s * s - 1.0);
  raise(lo_2, middle - half);
  lower(hi_1, middle + half);
}

// Returns the range of the shift of gear i for which its usable flank is long enough. The usable
// flanks begin at f_i = max(0, w_i ρ_Fi) [T9.1]. The path clipped to the usable flanks must have at
// least the length K. This gives three conditions: w_1 q_1 − f_1 ≥ K, w_2 q_2 − f_2 ≥ K and N − f_1
// − f_2 ≥ K. This function solves the condition of gear i. If f_1, f_2 > 0, the third condition
// depends on Σ alone (sum_margin). An internal gear has no bound, because the start of its flank is
// unknown. [T9.7]
std::array<double, 2> ShiftGraph::usable_shifts(std::size_t i, double k) const {
  const TrialGear& g = gears_[i];
  if (g.teeth < 0) return {-kInfinity, kInfinity};
  const double A = g.r + g.addendum + k;
  const double path = min_path_ / weight_[i];
  double least = radius_of(path, g.r_b);
  double most = kInfinity;
  // The condition for the tip radius u is q(u) ≥ s u + c. Squaring it gives a quadratic in u, and
  // the condition holds between the roots. If s u + c < 0 at the base circle, it holds from the
  // base circle up to the greater root.
  const double s = 1.0 / g.sin_transverse;
  const double c = path + g.r * g.sin_transverse - s * (g.edge_depth + A);
  const double disc = c * c - (s * s - 1.0) * g.r_b * g.r_b;
  const bool starts_above = s * g.r_b + c > 0.0;
  if (disc >= 0.0 && c < 0.0) {
    most = (-s * c + std::sqrt(disc)) / (s * s - 1.0);
    if (starts_above) raise(least, (-s * c - std::sqrt(disc)) / (s * s - 1.0));
  } else if (starts_above) {
    most = least - 1.0;
  }
  return {least - A, most - A};
}

void ShiftGraph::bound_usable_path(const SumPlace& at, double sum, double& lo, double& hi) const {
  for (std::size_t i : {0, 1}) {
    const TrialGear& g = gears_[i];
    auto [least, most] = at.k == 0.0 ? usable_whole_tips_[i] : usable_shifts(i, at.k);
    if (!internal_) {
      const double path = at.N - min_path_;
      const double of_place = (crossed_ ? path / weight_[i] : path) - g.r * g.sin_transverse;
      lower(most, g.edge_depth + of_place * g.sin_transverse);
    }
    if (i == 0) {
      raise(lo, least);
      lower(hi, most);
    } else {
      raise(lo, sum - most);
      lower(hi, sum - least);
    }
  }
}

template <class Line>
void ShiftGraph::bound(const SumPlace& at, double sum, int limits, Line& line) const {
  const TrialGear& g_1 = gears_[0];
  const TrialGear& g_2 = gears_[1];
  raise(line.lo_of(ShiftEdge::s1min), g_1.x_min);
  lower(line.hi_of(ShiftEdge::s2min), sum - g_2.x_min);
  if (limits > static_cast<int>(Limit::contact_ratio)) {
    bound_usable_path(at, sum, line.lo_of(ShiftEdge::eps_true), line.hi_of(ShiftEdge::eps_true));
  }
  if (limits > static_cast<int>(Limit::sliding) && problem_->limits.sliding && !crossed_) {
    bound_sliding(at, sum, line.lo_of(ShiftEdge::sliding), line.hi_of(ShiftEdge::sliding));
  }
  if (limits > static_cast<int>(Limit::interference) && problem_->limits.avoid_interference) {
    const ShiftEdge below = internal_ ? ShiftEdge::interference1 : ShiftEdge::interference2;
    bound_interference(at, sum, line.lo_of(below), line.hi_of(ShiftEdge::interference1));
  }
  // If tips are shortened, the bounds s1max and s2max are solutions of equations. If only the
  // tightest bounds are stored, an equation is solved only if its bound may be the tightest one.
  double& hi = line.hi_of(ShiftEdge::s1max);
  if (Line::kNamed || least_max_shift(*problem_, g_1, at.k) < hi)
    lower(hi, max_shift(*problem_, g_1, at.k));
  double& lo = line.lo_of(ShiftEdge::s2max);
  if (Line::kNamed || sum - least_max_shift(*problem_, g_2, at.k) > lo)
    raise(lo, sum - max_shift(*problem_, g_2, at.k));
}

ShiftBounds ShiftGraph::bounds_before_path(const SumPlace& at, double sum, int limits) const {
  ShiftBounds bounds;
  bound(at, sum, limits, bounds);
  return bounds;
}

LineEnds ShiftGraph::ends_before_path(const SumPlace& at, double sum, int limits) const {
  Tightest ends{{-kInfinity, kInfinity}};
  bound(at, sum, limits, ends);
  return ends;
}

ShiftSlice ShiftBounds::slice() const {
  ShiftSlice s{{-kInfinity, kInfinity}, ShiftEdge::mesh, ShiftEdge::mesh};
  s.lo = *std::max_element(lo.begin(), lo.end());
  s.hi = *std::min_element(hi.begin(), hi.end());
  // If several bounds coincide, the name of the first one is used. For example, the bounds of the
  // clipped path and of interference can coincide.
  const auto first = [](const auto& bounds, double value) {
    const auto at = std::find_if(bounds.begin(), bounds.end(), [value](double bound) {
      return bound == value || std::abs(bound - value) <= kOneBound;
    });
    return static_cast<ShiftEdge>(at - bounds.begin());
  };
  if (s.lo > -kInfinity) s.lo_edge = first(lo, s.lo);
  if (s.hi < kInfinity) s.hi_edge = first(hi, s.hi);
  return s;
}

ShiftGraph::SumMargin ShiftGraph::sum_margin(const SumPlace& at, double sum, int limits) const {
  SumMargin margin{kInfinity, ShiftEdge::mesh};
  if (limits > static_cast<int>(Limit::contact_ratio) && !internal_) {
    // N − ρ_F1 − ρ_F2 ≥ K, in units of Σ. [T9.7]
    const double path = at.N - min_path_ - least_start_[0] - least_start_[1];
    margin = {path / start_slope_[0] - sum, ShiftEdge::eps_true};  // the slope is the same for both
                                                                   // gears
  }
  if (limits > static_cast<int>(Limit::tip_clearance) && problem_->limits.tip_clearance) {
    const double lost = at.a - R_ - sum - at.k;  // [T9.5]
    const double least =
        std::min(gears_[0].dedendum - gears_[1].addendum, gears_[1].dedendum - gears_[0].addendum);
    const double free = least + lost - *problem_->limits.tip_clearance;
    if (free < margin.value) margin = {free, ShiftEdge::clearance};
  }
  return margin;
}

}  // namespace gearwright
