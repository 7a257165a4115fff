#include "gearwright/design/shift_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/numbers.hpp"
#include "gearwright/design/tip_curvature.hpp"
#include "gearwright/math/root.hpp"
#include "gearwright/pair/leaf_formulas.hpp"

namespace gearwright {

using detail::curvature;
using detail::lower;
using detail::radius_of;
using detail::raise;

namespace {

// Least relative excess of the centre distance over the sum of the base radii. At this excess, the
// working pressure angle is 4e-5 rad. At smaller distances, double precision is not sufficient to
// decide whether the gears mesh.
constexpr double kMinOpening = 1e-9;

}  // namespace

std::string_view name(ShiftEdge edge) {
  constexpr std::array<std::string_view, kShiftEdges> kNames{
      "s1min",    "s1max",   "s2min",     "s2max",         "Cmin",          "Cmax", "eps",
      "eps_true", "sliding", "clearance", "interference1", "interference2", "mesh"};
  return kNames[static_cast<std::size_t>(edge)];
}

std::string_view name(Limit limit) {
  constexpr std::array<std::string_view, kLimits> kNames{
      "shift_limits",  "center_distance", "contact_ratio", "overlap_ratio", "sliding",
      "tip_clearance", "interference",    "safety_flank",  "safety_root",   "verdict"};
  return kNames[static_cast<std::size_t>(limit)];
}

ShiftGraph::ShiftGraph(const SearchProblem& problem, const Trial& trial, const TrialGear& gear_1,
                       const TrialGear& gear_2)
    : problem_(&problem),
      trial_(trial),
      gears_{gear_1, gear_2},
      internal_(trial.z2 < 0),
      crossed_(problem.crossed()),
      tight_(problem.tight()),
      R_(gear_1.r + gear_2.r),
      B_(gear_1.r_b + gear_2.r_b),
      tan_alpha_(std::tan(problem.normal_pressure_angle.rad())),
      teeth_sum_(trial.z1 + trial.z2),
      nearest_(crossed_ ? 0.0 : std::abs(B_) * (1.0 + kMinOpening)) {
  const double cos_beta = std::abs(gear_1.teeth / (2.0 * gear_1.r));
  const double alpha_t = std::asin(gear_1.sin_transverse);
  inv_alpha_t_ = involute(alpha_t);
  pitch_ = std::numbers::pi * std::cos(alpha_t) / cos_beta;
  if (crossed_) {
    // [T9.10]: For X = Σ, N = r_1 sin α_t1/cos β_b1 + r_2 sin α_t2/cos β_b2 + Σ/sin α_n.
    pitch_ = std::numbers::pi * std::cos(problem.normal_pressure_angle.rad());
    for (std::size_t i : {0, 1}) {
      weight_[i] = 1.0 / gears_[i].cos_base_helix;
      crossed_line_0_ += gears_[i].r * gears_[i].sin_transverse * weight_[i];
    }
    crossed_line_1_ = 1.0 / std::sin(problem.normal_pressure_angle.rad());
  }
  min_path_ = problem.limits.contact_ratio * pitch_;
  mesh_sum_ = crossed_ ? -crossed_line_0_ / crossed_line_1_ : sum_of_distance(nearest_);
  if (!internal_) {
    path_sum_ = crossed_ ? (min_path_ - crossed_line_0_) / crossed_line_1_
                         : sum_of_distance(radius_of(min_path_, B_));
  }
  walls_ = plain_sums(kRegionLimits, Band::left_out);
  region_sums_ = all_sums(kRegionLimits);
  for (std::size_t i : {0, 1}) {
    const TrialGear& g = gears_[i];
    start_slope_[i] = weight_[i] / g.sin_transverse;
    least_start_[i] = weight_[i] * leaf::flank_start(g.r, g.sin_transverse, g.edge_depth, 0.0);
    usable_whole_tips_[i] = usable_shifts(i, 0.0);
  }
}

// The formulas of [T9.4].
SumPlace ShiftGraph::place(double sum) const {
  SumPlace at{R_ + sum, 0.0, 0.0};
  if (crossed_) {
    at.N = crossed_line_0_ + crossed_line_1_ * sum;
  } else if (tight_) {
    const double y = leaf::working_involute(inv_alpha_t_, tan_alpha_, sum, teeth_sum_);
    const double alpha_w = inverse_involute(std::max(y, 0.0));
    if (sum != 0.0) at.a = B_ / std::cos(alpha_w);
    at.N = sum != 0.0 ? B_ * std::tan(alpha_w) : std::copysign(curvature(R_, B_), B_);
    if (problem_->shorten_tips) at.k = std::min(0.0, at.a - R_ - sum);
  } else {
    at.N = std::copysign(curvature(at.a, B_), B_);
  }
  return at;
}

double ShiftGraph::sum_of_distance(double distance) const {
  const double a = std::copysign(distance, B_);
  if (!tight_) return a - R_;
  if (a == R_) return 0.0;
  const double alpha_w = std::atan2(curvature(a, B_), std::abs(B_));
  return (involute(alpha_w) - inv_alpha_t_) * teeth_sum_ / (2.0 * tan_alpha_);
}

// Returns the range of Σ that follows from those limits that have a closed form. The corners of the
// rectangle of shifts are not included.
ShiftGraph::Sums ShiftGraph::plain_sums(int limits, Band band_asked) const {
  Sums s{-kInfinity, kInfinity, ShiftEdge::mesh, ShiftEdge::mesh};
  const auto from_below = [&](double sum, ShiftEdge edge) {
    if (sum > s.lo) s.lo = sum, s.lo_edge = edge;
  };
  const auto from_above = [&](double sum, ShiftEdge edge) {
    if (sum < s.hi) s.hi = sum, s.hi_edge = edge;
  };
  // For an internal pair, the centre distance decreases as Σ increases, so a lower limit of the
  // distance is an upper limit of Σ.
  const auto not_nearer = [&](double sum, ShiftEdge edge) {
    internal_ ? from_above(sum, edge) : from_below(sum, edge);
  };
  const auto not_farther = [&](double sum, ShiftEdge edge) {
    internal_ ? from_below(sum, edge) : from_above(sum, edge);
  };
  // Without a working pressure angle, there is no contact ratio. If the limit of the contact ratio
  // is evaluated, sums without a working pressure angle are therefore excluded.
  if (limits > static_cast<int>(Limit::contact_ratio)) {
    not_nearer(mesh_sum_, ShiftEdge::mesh);
  }
  if (band_asked == Band::asked && limits > static_cast<int>(Limit::center_distance) &&
      problem_->center_distance) {
    const auto& band = *problem_->center_distance;
    const double least = band[0] / trial_.module;
    const double most = band[1] / trial_.module;
    // If the centre distance is less than the sum of the base radii, no sum of shifts gives a
    // backlash-free pair.
    if (tight_ && most < nearest_) return {1.0, 0.0, ShiftEdge::Cmax, ShiftEdge::Cmax};
    not_nearer(sum_of_distance(least), ShiftEdge::Cmin);
    not_farther(sum_of_distance(most), ShiftEdge::Cmax);
  }
  if (limits > static_cast<int>(Limit::contact_ratio) && !internal_) {
    // The condition is N ≥ K, because the path lies between the base tangent points.
    from_below(path_sum_, ShiftEdge::eps_true);
  }
  return s;
}

ShiftGraph::Sums ShiftGraph::all_sums(int limits) const {
  Sums s = plain_sums(limits, Band::asked);
  if (s.lo_edge == ShiftEdge::Cmax && s.hi_edge == ShiftEdge::Cmax)
    return s;  // no Σ meets the upper limit of the centre distance
  // The corners of the rectangle of shifts limit the range, too. A corner is a point and belongs to
  // no edge, so no edge is named.
  raise(s.lo, gears_[0].x_min + gears_[1].x_min);
  double corner = gears_[0].x_max + gears_[1].x_max;
  if (tight_ && problem_->shorten_tips) {
    corner = std::max(corner, gears_[0].x_min + gears_[1].x_min);
    corner = limits > static_cast<int>(Limit::contact_ratio) ? beyond_long_paths(corner)
                                                             : beyond_thin_tips(corner, s.lo);
  }
  lower(s.hi, corner);
  return s;
}

// Returns a sum at which every path is shorter than K because the tips are shortened by k. All
// greater sums also have this property, because k decreases further. On a line Σ = const, the path
// length E has its maximum √((a + h_a1 + h_a2 + k)² − B²) − N at the point with equal tip pressure
// angles. [T9.6]
double ShiftGraph::beyond_long_paths(double sum) const {
  if (internal_) return sum;  // tips are not shortened
  sum = std::max(sum, 0.0);
  for (double step = 0.25;; step *= 2.0) {
    const SumPlace at = place(sum);
    const double tips = at.a + gears_[0].addendum + gears_[1].addendum + at.k;
    if (curvature(tips, B_) - at.N < min_path_ - kTouching) return sum;
    sum += step;
  }
}

// Returns the sum above which the tips are too thin, in spite of the shortening by k. If 60 steps
// do not find this sum, the function returns the sum of the last step.
double ShiftGraph::beyond_thin_tips(double sum, double least) const {
  constexpr double kLastRise = 1e-13;  // rounding of a shift, modules
  constexpr double kBeyond = 1e-9;     // modules, bound for the sum of all further increases
  for (int i = 0; i < 60; ++i) {
    const double k = place(std::max(sum, least)).k;
    const double next = max_shift(*problem_, gears_[0], k) + max_shift(*problem_, gears_[1], k);
    if (!(next > sum + kLastRise)) break;
    sum = next;
  }
  return sum + kBeyond;
}

double ShiftGraph::path_length(const SumPlace& at, double sum, double x1) const {
  // The length is ρ_1E − ρ_1A of the leaf formulas, with weights for crossed axes and with a signed
  // N. In this form, its derivative with respect to x1 is a sum of derivatives of two square roots.
  const double u_1 = gears_[0].r + gears_[0].addendum + at.k + x1;
  const double u_2 = gears_[1].r + gears_[1].addendum + at.k + (sum - x1);
  return weight_[0] * curvature(u_1, gears_[0].r_b) +
         side_of(trial_.z2) * weight_[1] * curvature(u_2, gears_[1].r_b) - at.N;
}

namespace {

// dE/dx1 = w_1/sin α_a1 − w_2/sin α_a2, and its derivative. Both tips must lie outside their base
// circles.
struct PathSlope {
  double first, second;
};
PathSlope path_slope(double u_1, double b_1, double w_1, double u_2, double b_2, double w_2,
                     double side) {
  const double q_1 = curvature(u_1, b_1);
  const double q_2 = curvature(u_2, b_2);
  const double bend_1 = w_1 * b_1 * b_1 / (q_1 * q_1 * q_1);
  const double bend_2 = w_2 * b_2 * b_2 / (q_2 * q_2 * q_2);
  return {w_1 * std::abs(u_1) / q_1 - w_2 * std::abs(u_2) / q_2, -bend_1 - side * bend_2};
}

}  // namespace

ShiftGraph::Longest ShiftGraph::longest_path(const SumPlace& at, double sum,
                                             const LineEnds& within) const {
  const double A_1 = gears_[0].r + gears_[0].addendum + at.k;
  const double A_2 = gears_[1].r + gears_[1].addendum + at.k;
  double x1 = (A_1 + A_2 + sum) * gears_[0].r_b / B_ - A_1;  // x1 with equal tip pressure angles
                                                             // [T9.6]
  if (crossed_ && within.lo < within.hi) {
    const auto slope = [&](double x) {
      const PathSlope s = path_slope(A_1 + x, gears_[0].r_b, weight_[0], A_2 + sum - x,
                                     gears_[1].r_b, weight_[1], side_of(trial_.z2));
      return Slope<double>{s.first, s.second};
    };
    x1 = newton_in_bracket<double>(slope, within.lo, within.hi,
                                   std::clamp(x1, within.lo, within.hi), false)
             .x;
  }
  x1 = within.lo < within.hi ? std::clamp(x1, within.lo, within.hi) : within.middle();
  return {x1, path_length(at, sum, x1)};
}

// Returns the x1 at which the length E of the path of contact equals its lower limit K. This x1
// lies between `bound` and the x1 of the longest path. The result is absent if the path is long
// enough at `bound`, or if `bound` is not on the given side of the longest path.
std::optional<double> ShiftGraph::end_of_path(const SumPlace& at, double sum, const Longest& top,
                                              LineSide side, double bound) const {
  const bool below = side == LineSide::lo;
  if (!(below ? bound < top.x1 : top.x1 < bound)) return std::nullopt;
  if (!(path_length(at, sum, bound) - min_path_ < 0.0)) return std::nullopt;
  const double A_1 = gears_[0].r + gears_[0].addendum + at.k;
  const double A_2 = gears_[1].r + gears_[1].addendum + at.k;
  const auto excess = [&](double x) {
    const PathSlope s = path_slope(A_1 + x, gears_[0].r_b, weight_[0], A_2 + sum - x, gears_[1].r_b,
                                   weight_[1], side_of(trial_.z2));
    return Slope<double>{path_length(at, sum, x) - min_path_, s.first};
  };
  // For an external pair, E is concave, so Newton steps from a bound never pass the root. For an
  // internal pair, E may be convex, so a bracket limits the steps.
  return below ? newton_in_bracket<double>(excess, bound, top.x1, bound, true).x
               : newton_in_bracket<double>(excess, top.x1, bound, bound, false).x;
}

ShiftSlice ShiftGraph::slice(double sum, int limits) const {
  const SumPlace at = place(sum);
  ShiftSlice slice = bounds_before_path(at, sum, limits).slice();
  if (limits <= static_cast<int>(Limit::contact_ratio) || slice.empty()) return slice;
  const Longest top = longest_path(at, sum, slice);
  if (!(top.length >= min_path_)) {
    // At most one x1 on this line has a path that is long enough. The result is an interval at the
    // x1 of the longest path, with the width zero or a negative width.
    const bool touching = top.length >= min_path_ - kTouching;
    return {{top.x1 + (touching ? 0.0 : 1.0), top.x1}, ShiftEdge::eps, ShiftEdge::eps};
  }
  const auto lo = end_of_path(at, sum, top, LineSide::lo, slice.lo);
  const auto hi = end_of_path(at, sum, top, LineSide::hi, slice.hi);
  if (lo) slice.lo = *lo, slice.lo_edge = ShiftEdge::eps;
  if (hi) slice.hi = *hi, slice.hi_edge = ShiftEdge::eps;
  return slice;
}

double ShiftGraph::slice_end(double sum, LineSide side) const {
  const SumPlace at = place(sum);
  const LineEnds ends = ends_before_path(at, sum);
  const double bound = side == LineSide::lo ? ends.lo : ends.hi;
  if (ends.empty()) return bound;
  const Longest top = longest_path(at, sum, ends);
  if (!(top.length >= min_path_)) {
    const ShiftSlice none = slice(sum);
    return side == LineSide::lo ? none.lo : none.hi;
  }
  return end_of_path(at, sum, top, side, bound).value_or(bound);
}

std::array<Interval, 2> ShiftGraph::shift_limits() const {
  std::array<Interval, 2> limits;
  for (std::size_t i : {0, 1}) {
    limits[i] = {gears_[i].x_min, kInfinity};
    if (tight_ && problem_->shorten_tips) continue;
    raise(limits[i].lo, usable_whole_tips_[i][0]);
    limits[i].hi = std::min(gears_[i].x_max, usable_whole_tips_[i][1]);
  }
  return limits;
}

double ShiftGraph::margin(double x1, double x2) const { return margin_in(sums(), x1, x2); }

double ShiftGraph::wall_distance(double x1, double x2) const { return margin_in(walls_, x1, x2); }

double ShiftGraph::margin_in(const Sums& range, double x1, double x2) const {
  const double sum = x1 + x2;
  double least = std::min(sum - range.lo, range.hi - sum);
  if (least < -kTouching) return least;
  const SumPlace at = place(sum);
  const LineEnds s = ends_before_path(at, sum);
  lower(least, std::min(x1 - s.lo, s.hi - x1));
  lower(least, sum_margin(at, sum).value);
  if (!overlap_ratio_is_enough()) return -1.0;
  return std::min(least, path_length(at, sum, x1) - min_path_);
}

}  // namespace gearwright
