// Computes the s1–s2 graph of a pair of gears with given numbers of teeth. The graph is the set of
// all pairs of profile shifts that meet all limits.
//
//   Σ = x1 + x2     sum of shifts. Centre distance, working pressure angle and tip alteration
//                   depend on Σ alone. On a line Σ = const, every limit leaves one interval of x1
//   a(Σ), N(Σ), k(Σ)  centre distance, distance of the base tangent points, tip alteration
//   E(Σ, x1)        length of the path of contact; it has one maximum in x1 (external: concave)
//   w_1, w_2        weights of the flanks in E: 1, or 1/cos β_b on crossed axes
//   K               least length of the path: the least contact ratio times the pitch
//                                              theory: docs/theory/09-design-search.md
//
// All values are in normal modules with ISO 21771 signs, so the same formulas hold for external,
// internal and crossed pairs. Every bound is the solution of an equation. Section 9.4 proves in
// which cases there is only one interval of Σ. In other cases, a search from nodes finds the
// intervals. If interference is excluded, external gears with tips inside their own reference
// circle are also excluded.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/design/intervals.hpp"
#include "gearwright/design/trial_gear.hpp"

namespace gearwright {

/// Upper limit of the second derivatives of margins with respect to Σ, 1/modules. The greatest
/// actual values are a few 1/modules, for the interference bounds. A higher limit only makes a
/// search end later.
inline constexpr double kMostBend = 100.0;

/// The limit that defines a part of the boundary.
enum class ShiftEdge {
  s1min,
  s1max,
  s2min,
  s2max,
  Cmin,
  Cmax,
  eps,
  eps_true,
  sliding,
  clearance,
  interference1,
  interference2,
  mesh
};
inline constexpr std::size_t kShiftEdges = 13;
/// Returns the name of an edge, for example "s1min" or "Cmax". Beyond an edge with the name "mesh",
/// there is no working pressure angle.
std::string_view name(ShiftEdge edge);
/// Two limits count as touching within this tolerance, modules. The tolerance is necessary, because
/// a centre distance divided by a module has a rounding error.
inline constexpr double kTouching = 1e-11;
/// Bounds of x1 count as equal if they differ by less than this value, modules. Without this
/// tolerance, rounding errors would determine which limit is named.
inline constexpr double kOneBound = 1e-12;
/// The interval of x1 on a line Σ = const, which is empty if lo > hi + kTouching.
struct LineEnds {
  double lo, hi;
  bool empty() const { return !(lo <= hi + kTouching); }
  double middle() const { return (lo + hi) / 2.0; }
};

enum class LineSide { lo, hi };

/// The interval of x1 on a line Σ = const, with the names of the limits at its ends.
struct ShiftSlice : LineEnds {
  ShiftEdge lo_edge, hi_edge;
};
/// The lower and upper bound of x1 due to each limit. If a limit has no bounds, the values are ∓∞.
struct ShiftBounds {
  std::array<double, kShiftEdges> lo, hi;
  ShiftBounds() {
    lo.fill(-std::numeric_limits<double>::infinity());
    hi.fill(std::numeric_limits<double>::infinity());
  }
  static constexpr bool kNamed = true;
  double& lo_of(ShiftEdge edge) { return lo[static_cast<std::size_t>(edge)]; }
  double& hi_of(ShiftEdge edge) { return hi[static_cast<std::size_t>(edge)]; }
  ShiftSlice slice() const;  ///< the slice between the tightest bounds
};

/// Values that depend on Σ alone.
struct SumPlace {
  double a;  ///< centre distance, signed
  double N;  ///< distance of the base tangent points, signed
  double k;  ///< tip alteration, ≤ 0
};

class ShiftGraph {
 public:
  /// Domain    the problem must outlive the graph
  ShiftGraph(const SearchProblem& problem, const Trial& trial, const TrialGear& gear_1,
             const TrialGear& gear_2);

  const std::array<TrialGear, 2>& gears() const { return gears_; }
  const Trial& trial() const { return trial_; }
  const SearchProblem& problem() const { return *problem_; }
  double min_path() const { return min_path_; }  ///< K
  double pitch() const { return pitch_; }        ///< p_bt; p_bn on crossed axes
  /// Returns the ratio of a length along the line of action to its projection on the transverse
  /// section of a gear.
  double weight(std::size_t gear) const { return weight_[gear]; }
  double overlap_of(double face) const;  ///< ε_β of a face width in modules; 0 on crossed axes
  /// Returns the values that depend on Σ alone.   Domain: within sums(), so that a working angle
  /// exists
  SumPlace place(double sum) const;
  /// The range of Σ that the first `limits` limits permit. Limits that depend on x1 are ignored.
  struct Sums {
    double lo, hi;
    ShiftEdge lo_edge, hi_edge;
  };
  Sums sums(int limits = kRegionLimits) const {
    return limits == kRegionLimits ? region_sums_ : all_sums(limits);
  }

  /// The smallest margin, in units of Σ, of those limits that depend on Σ alone but whose range of
  /// Σ has no closed form. These limits are met if the margin is ≥ 0.
  struct SumMargin {
    double value;
    ShiftEdge edge;
  };
  SumMargin sum_margin(const SumPlace& at, double sum, int limits = kRegionLimits) const;

  /// Returns all bounds of x1 on a line Σ = const, except the bound of the path length.
  ShiftBounds bounds_before_path(double sum, int limits = kRegionLimits) const {
    return bounds_before_path(place(sum), sum, limits);
  }
  /// Returns the interval of x1 on a line Σ = const, including the limit of the path length.
  ShiftSlice slice(double sum, int limits = kRegionLimits) const;
  /// Returns one end of slice(), without the name of its limit. The integral of the area uses it.
  double slice_end(double sum, LineSide side) const;
  /// Returns the ends of the interval between the bounds of bounds_before_path(), without the names
  /// of the limits. The names are needed only for few lines.
  LineEnds ends_before_path(const SumPlace& at, double sum, int limits = kRegionLimits) const;
  /// Returns E, the length of the path at a point.
  double path_length(const SumPlace& at, double sum, double x1) const;
  struct Longest {
    double x1, length;
  };
  /// Returns the greatest E on a line Σ = const, and its x1.
  Longest longest_path(const SumPlace& at, double sum, const LineEnds& within) const;
  /// Returns the sums Σ for which the first `limits` limits leave an interval of x1. If the region
  /// consists of several pieces, there may be several intervals of Σ.
  std::vector<Interval> feasible_sums(int limits = kRegionLimits) const;
  /// True if feasible_sums() finds a sum. If it does, this function is usually faster than
  /// feasible_sums().
  bool has_feasible_sums(int limits = kRegionLimits) const;
  /// Returns the first limit that leaves no region, or none if a region remains. The limits are
  /// applied in the order of the enum Limit.
  std::optional<Limit> what_kills() const;
  /// Returns the smallest margin of all limits at a point, modules, computed from the same bounds
  /// as the slices. The point is inside the region if the margin is ≥ 0. If Σ lies outside sums(),
  /// the margin is −1 times the distance of Σ from sums(). If Σ lies within sums() and the overlap
  /// ratio is too small, the margin is −1.
  double margin(double x1, double x2) const;
  /// Returns, for each shift, the range that follows from the limits of this shift alone. If tips
  /// are shortened, limits that depend on the tip are omitted.
  std::array<Interval, 2> shift_limits() const;
  /// Returns the distance of a point from the nearest border. The result is margin() without the
  /// band of centre distances, whose ends are not borders, because the user chooses them.
  ///
  /// Domain    within sums()
  double wall_distance(double x1, double x2) const;

 private:
  enum class Band { asked, left_out };
  Sums plain_sums(int limits, Band band) const;
  Sums all_sums(int limits) const;
  double beyond_long_paths(double sum) const;
  double beyond_thin_tips(double sum, double least) const;
  double margin_in(const Sums& range, double x1, double x2) const;
  double sum_of_distance(double distance) const;
  ShiftBounds bounds_before_path(const SumPlace& at, double sum, int limits) const;
  bool is_asked(Limit limit) const;
  std::optional<double> end_of_path(const SumPlace& at, double sum, const Longest& top,
                                    LineSide side, double bound) const;
  double width_before_path(const SumPlace& at, double sum, int limits) const;
  double excess_of_path(const SumPlace& at, double sum, int limits) const;
  template <class Line>
  void bound(const SumPlace& at, double sum, int limits, Line& line) const;
  std::array<double, 2> usable_shifts(std::size_t i, double k) const;
  void bound_sliding(const SumPlace& at, double sum, double& lo, double& hi) const;
  void bound_interference(const SumPlace& at, double sum, double& lo_2, double& hi_1) const;
  void bound_usable_path(const SumPlace& at, double sum, double& lo, double& hi) const;
  bool overlap_ratio_is_enough() const;
  bool tip_clearance_can_be_enough() const;

  const SearchProblem* problem_;
  Trial trial_;
  std::array<TrialGear, 2> gears_;
  std::array<double, 2> weight_{1.0, 1.0};
  bool internal_, crossed_, tight_;
  double pitch_, min_path_;
  double R_, B_;  ///< r1 + r2, r_b1 + r_b2; with signs
  double tan_alpha_, inv_alpha_t_, teeth_sum_;
  double nearest_;                                      ///< least centre distance
  double crossed_line_0_ = 0.0, crossed_line_1_ = 0.0;  ///< N = line_0 + line_1 Σ
  // Values that are computed once per graph, because many lines Σ = const, ranges of Σ or points
  // use them.
  double mesh_sum_ = 0.0, path_sum_ = 0.0;  ///< Σ at the least centre distance, and Σ with N = K
  Sums walls_{};                            ///< plain_sums() without the band of centre distances
  Sums region_sums_{};                      ///< sums() of all limits
  std::array<double, 2> start_slope_{};     ///< w_i/sin α_t
  std::array<double, 2> least_start_{};     ///< w_i ρ_Fi at x = 0
  std::array<std::array<double, 2>, 2> usable_whole_tips_{};  ///< usable_shifts at k = 0
};

}  // namespace gearwright
