// Computes the sums of shifts that meet all limits. If there is no such sum, finds the first limit
// that no sum meets together with all limits before it.
//                                              theory: docs/theory/09-design-search.md, 9.4
#include <algorithm>

#include "gearwright/design/face_width.hpp"
#include "gearwright/design/shift_graph.hpp"
#include "gearwright/pair/leaf_formulas.hpp"

namespace gearwright {

double ShiftGraph::width_before_path(const SumPlace& at, double sum, int limits) const {
  const LineEnds s = ends_before_path(at, sum, limits);
  return std::min(s.hi - s.lo, sum_margin(at, sum, limits).value);
}

double ShiftGraph::excess_of_path(const SumPlace& at, double sum, int limits) const {
  return longest_path(at, sum, ends_before_path(at, sum, limits)).length - min_path_;
}

std::vector<Interval> ShiftGraph::feasible_sums(int limits) const {
  if (limits > static_cast<int>(Limit::overlap_ratio) && !overlap_ratio_is_enough()) return {};
  if (limits > static_cast<int>(Limit::tip_clearance) && !tip_clearance_can_be_enough()) return {};
  Sums range = sums(limits);
  if (range.lo > range.hi && range.lo <= range.hi + kTouching)
    range.lo = range.hi = (range.lo + range.hi) / 2.0;
  const auto width = [&](double sum) { return width_before_path(place(sum), sum, limits); };
  const auto excess = [&](double sum) { return excess_of_path(place(sum), sum, limits); };
  // For an internal pair, the interference limit may leave ranges on both sides of Σ = 0 [T9.9].
  // Both sides of 0 are searched separately, because the gap between the ranges may be narrower
  // than the distance between nodes.
  const bool gap_at_zero = internal_ && problem_->limits.avoid_interference &&
                           limits > static_cast<int>(Limit::interference);
  const Hump hump{.bend = kMostBend};
  const auto exactly_or_touching = [&](const auto& f, double a, double b) {
    if (!(gap_at_zero && a < 0.0 && b > 0.0))
      return where_not_negative_or_touching(f, a, b, kTouching, hump);
    const auto beside_zero = [&](const auto& g) {
      auto pieces = where_not_negative(g, a, 0.0, kIntervalNodes, hump);
      for (const Interval& right : where_not_negative(g, 0.0, b, kIntervalNodes, hump)) {
        if (!pieces.empty() && pieces.back().hi == 0.0 && right.lo == 0.0) {
          pieces.back().hi = right.hi;
        } else {
          pieces.push_back(right);
        }
      }
      return pieces;
    };
    auto pieces = beside_zero(f);
    if (!pieces.empty()) return pieces;
    return beside_zero([&](double sum) { return f(sum) + kTouching; });
  };
  // `wide` contains the sums for which an interval of x1 meets all limits except that of the path
  // length. Such a sum is feasible if its longest path is long enough.
  const auto wide = exactly_or_touching(width, range.lo, range.hi);
  if (limits <= static_cast<int>(Limit::contact_ratio)) return wide;
  std::vector<Interval> found;
  for (const Interval& piece : wide) {
    const auto long_enough = exactly_or_touching(excess, piece.lo, piece.hi);
    found.insert(found.end(), long_enough.begin(), long_enough.end());
  }
  return found;
}

bool ShiftGraph::has_feasible_sums(int limits) const {
  if (limits > static_cast<int>(Limit::overlap_ratio) && !overlap_ratio_is_enough()) return false;
  if (limits > static_cast<int>(Limit::tip_clearance) && !tip_clearance_can_be_enough())
    return false;
  const Sums range = sums(limits);
  constexpr double kInside = 1e-9;  // modules; exceeds rounding errors
  for (const double share : {0.5, 0.25, 0.75, 0.1}) {
    const double sum = range.lo + share * (range.hi - range.lo);
    if (!(range.lo < sum && sum < range.hi)) break;
    const SumPlace at = place(sum);
    if (width_before_path(at, sum, limits) > kInside &&
        (limits <= static_cast<int>(Limit::contact_ratio) ||
         excess_of_path(at, sum, limits) > kInside))
      return true;
  }
  return !feasible_sums(limits).empty();
}

bool ShiftGraph::is_asked(Limit limit) const {
  const SearchLimits& limits = problem_->limits;
  switch (limit) {
    case Limit::center_distance: return problem_->center_distance.has_value();
    case Limit::overlap_ratio: return limits.overlap_ratio || problem_->sizes_faces();
    case Limit::sliding: return limits.sliding.has_value();
    case Limit::tip_clearance: return limits.tip_clearance.has_value();
    case Limit::interference: return limits.avoid_interference;
    default: return true;
  }
}

std::optional<Limit> ShiftGraph::what_kills() const {
  for (int n = 1; n <= kRegionLimits; ++n) {
    const auto limit = static_cast<Limit>(n - 1);
    if (!is_asked(limit)) continue;
    if (limit == Limit::shift_limits && !problem_->shorten_tips) {
      for (const TrialGear& g : gears_)
        if (!(g.x_min <= g.x_max + kTouching)) return limit;
      continue;
    }
    if (!has_feasible_sums(n)) return limit;
  }
  return std::nullopt;
}

double ShiftGraph::overlap_of(double face) const {
  return crossed_ ? 0.0 : leaf::overlap_of(face, gears_[0].tan_base_helix, pitch_);
}

bool ShiftGraph::overlap_ratio_is_enough() const {
  const auto [least, most] = face_widths(*problem_, trial_);
  if (!(least <= most)) return false;
  if (!problem_->limits.overlap_ratio) return true;
  return overlap_of(most / trial_.module) >= *problem_->limits.overlap_ratio - kTouching;
}

// For an external pair, a − R − Σ ≤ 0, so the clearance is at most that of the racks. [T9.5]
bool ShiftGraph::tip_clearance_can_be_enough() const {
  if (internal_ || !problem_->limits.tip_clearance) return true;
  const double most =
      std::min(gears_[0].dedendum - gears_[1].addendum, gears_[1].dedendum - gears_[0].addendum);
  return most >= *problem_->limits.tip_clearance - 2.0 * kTouching;
}

}  // namespace gearwright
