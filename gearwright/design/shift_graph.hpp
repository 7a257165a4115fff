// The s1–s2 graph of one pair of tooth numbers: the ranges of the two profile shifts that each
// limit leaves.
//
//   Σ = x1 + x2     the coordinate along which the graph is cut: centre distance, working angle and
//                   tip alteration depend on Σ alone, and on a line Σ = const every limit leaves
//                   one interval of x1
//   a(Σ), N(Σ), k(Σ)  centre distance, distance of the base tangent points, tip alteration
//   E(Σ, x1)        length of the path of contact, with one maximum in x1 (external: concave); its
//                   weights w_1, w_2 are 1, or 1/cos β_b of crossed axes
//   K               least length of the path: the least contact ratio times the pitch
//                                              theory: docs/theory/09-design-search.md
//
// All values are in normal modules with ISO 21771 signs, so external, internal and crossed pairs
// share one set of formulas. Every bound is solved, not sampled. The ends in Σ are searched from
// nodes if section 9.4 does not prove that there is a single interval. If interference is to be
// avoided, external gears with tips inside their own reference circle are deliberately excluded.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/design/intervals.hpp"
#include "gearwright/design/trial_gear.hpp"

namespace gearwright {

/// Upper limit of the second derivative of margins over Σ, 1/modules. The greatest are those of the
/// bounds of interference, a few if tips lie outside their own reference circles. The bound is
/// generous, because it only determines when to stop searching.
inline constexpr double kMostBend = 100.0;

/// The limit at an end of the region.
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
/// "s1min", "Cmax", …; `mesh` if there is no working angle beyond.
std::string_view name(ShiftEdge edge);

/// Limits that coincide within this, modules, touch, because a centre distance divided by a module
/// is rounded.
inline constexpr double kTouching = 1e-11;

/// Bounds of x1 within this, modules, count as one bound, so that rounding does not change its
/// name.
inline constexpr double kOneBound = 1e-12;

/// One line Σ = const: the interval of x1; empty when lo > hi + kTouching.
struct LineEnds {
  double lo, hi;
  bool empty() const { return !(lo <= hi + kTouching); }
  double middle() const { return (lo + hi) / 2.0; }
};

enum class LineSide { lo, hi };

/// The same interval with the names of the limits at its ends.
struct ShiftSlice : LineEnds {
  ShiftEdge lo_edge, hi_edge;
};

/// The ends of the interval for each edge; ∓∞ for an edge that does not end it.
struct ShiftBounds {
  std::array<double, kShiftEdges> lo, hi;
  ShiftBounds() {
    lo.fill(-std::numeric_limits<double>::infinity());
    hi.fill(std::numeric_limits<double>::infinity());
  }
  static constexpr bool kNamed = true;
  double& lo_of(ShiftEdge edge) { return lo[static_cast<std::size_t>(edge)]; }
  double& hi_of(ShiftEdge edge) { return hi[static_cast<std::size_t>(edge)]; }
  ShiftSlice slice() const;  ///< the slice between the tightest edges
};

/// Values that depend on Σ alone.
struct SumPlace {
  double a;  ///< centre distance, signed
  double N;  ///< distance of the base tangent points, signed
  double k;  ///< tip alteration, ≤ 0
};

class ShiftGraph {
 public:
  /// Domain    the problem outlives the graph
  ShiftGraph(const SearchProblem& problem, const Trial& trial, const TrialGear& gear_1,
             const TrialGear& gear_2);

  const std::array<TrialGear, 2>& gears() const { return gears_; }
  const Trial& trial() const { return trial_; }
  const SearchProblem& problem() const { return *problem_; }
  double min_path() const { return min_path_; }  ///< K
  double pitch() const { return pitch_; }        ///< p_bt, crossed p_bn

  /// Domain    within sums() (contract: there is a working angle)
  SumPlace place(double sum) const;

  /// The range of Σ that the limits on Σ alone leave, with the first `limits` of them evaluated.
  struct Sums {
    double lo, hi;
    ShiftEdge lo_edge, hi_edge;
  };
  Sums sums(int limits = kRegionLimits) const {
    return limits == kRegionLimits ? region_sums_ : all_sums(limits);
  }

  /// The limits on Σ alone that are not simple ranges, in units of Σ; satisfied if ≥ 0.
  struct SumMargin {
    double value;
    ShiftEdge edge;
  };
  SumMargin sum_margin(const SumPlace& at, double sum, int limits = kRegionLimits) const;

  /// All bounds on a line except that of the path's length, and the slice including that one.
  ShiftBounds bounds_before_path(double sum, int limits = kRegionLimits) const {
    return bounds_before_path(place(sum), sum, limits);
  }
  ShiftSlice slice(double sum, int limits = kRegionLimits) const;
  /// One end of that slice, without its name, for the integral of the area.
  double slice_end(double sum, LineSide side) const;
  /// The result of bounds_before_path() without names, which is sufficient for most lines.
  LineEnds ends_before_path(const SumPlace& at, double sum, int limits = kRegionLimits) const;

  /// E: the path's length at a point, and the greatest length on a slice with its place.
  double path_length(const SumPlace& at, double sum, double x1) const;
  struct Longest {
    double x1, length;
  };
  Longest longest_path(const SumPlace& at, double sum, const LineEnds& within) const;

  /// The sums Σ at which the first `limits` limits leave a slice. There are several intervals only
  /// if the region is in pieces.
  std::vector<Interval> feasible_sums(int limits = kRegionLimits) const;

  /// True if feasible_sums() is not empty; faster in that case.
  bool has_feasible_sums(int limits = kRegionLimits) const;

  /// The first limit that leaves no region; none if the region exists.
  std::optional<Limit> what_kills() const;

  /// Least margin over all limits at one point, modules, from the same bounds as the slices; ≥ 0:
  /// inside.   Domain: outside sums() that distance alone
  double margin(double x1, double x2) const;

  /// The limits of each shift that are independent of the other shift, without those of shortened
  /// tips.
  std::array<Interval, 2> shift_limits() const;

  /// The same as margin() without the band of centre distances, whose ends are a choice of the
  /// user: the distance of a point from the nearest violated limit.   Domain: within sums()
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
  double R_, B_;  ///< r1 + r2, r_b1 + r_b2; signed
  double tan_alpha_, inv_alpha_t_, teeth_sum_;
  double nearest_;                                      ///< least centre distance
  double crossed_line_0_ = 0.0, crossed_line_1_ = 0.0;  ///< N = …_0 + …_1 Σ
  // Values that every line needs again.
  double mesh_sum_ = 0.0, path_sum_ = 0.0;  ///< Σ where a mesh begins, where N = K
  Sums walls_{};                            ///< of plain_sums, without the band
  Sums region_sums_{};                      ///< sums() of all limits
  std::array<double, 2> start_slope_{};     ///< w_i/sin α_t
  std::array<double, 2> least_start_{};     ///< w_i ρ_Fi at x = 0
  std::array<std::array<double, 2>, 2> usable_whole_tips_{};  ///< usable_shifts at k = 0
};

}  // namespace gearwright
