// Computes two charts over the number of teeth: the range of possible profile shifts, and the
// contact ratio of two identical gears in this range.
//
//   x_u      the undercut limit                     s_an     normal tip tooth thickness
//   x_t(s)   the shift at which s_an = s modules    ε_α      contact ratio of two identical gears
//                                              theory: docs/theory/09-design-search.md
//
// The charts show where good designs exist before any design is computed. For gears with few teeth,
// the range between undercut and pointed tips is small, and the contact ratio is also small. As in
// the search, trial_gear() computes the limits, and row_at() computes the contact ratios.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/design/search_problem.hpp"

namespace gearwright {

/// Tip thicknesses for which the charts show limits, modules: a pointed tip, and the usual minima
/// for through-hardened and for case-hardened gears.
inline constexpr std::array<double, 3> kChartTips{0.0, 0.2, 0.4};

/// The limits of the profile shift for one number of teeth, modules.
struct ShiftLimits {
  int teeth = 0;
  double undercut = 0.0;        ///< x_u
  std::array<double, 3> tip{};  ///< x_t for each of kChartTips
  double min = 0.0, max = 0.0;  ///< least and greatest shift that the limits of the problem permit;
                                ///< if min > max, none is possible
};

/// Returns the limits of gear `which` (0 or 1) with its rack and the given helix angle, for all
/// numbers of teeth from `from` to `to`.
///
/// Domain    1 ≤ from ≤ to (contract)
/// Accuracy  1e-12 modules for 7 … 100 teeth
std::vector<ShiftLimits> shift_limit_chart(const SearchProblem& problem, int rack, Angle helix,
                                           int which, int from, int to);

/// The point of the chart at which the curve of x_u intersects the curve of x_t for
/// kChartTips[tip]. where_limits_meet() returns none if the curves do not intersect.
///
/// Accuracy  0.01 teeth, because chords replace the curves between whole numbers of teeth
struct LimitsMeet {
  double teeth, shift;
  int fewest;  ///< the next greater whole number of teeth
};
std::optional<LimitsMeet> where_limits_meet(const std::vector<ShiftLimits>& chart, std::size_t tip);

/// Two identical gears with the shifts x = least + k/4 (greatest − least), k = 0 … 4.
struct IdenticalGears {
  ShiftLimits limits;
  std::array<std::optional<double>, 5>
      contact_ratio;  ///< ε_α; absent without a working pressure angle or a possible shift, and if
                      ///< shortened tips end inside their base circles
};
/// Returns pairs of identical gears with the rack of gear 1 and opposite hands, on parallel axes.
/// The problem gives the kind of mounting. The centre distance follows from the shifts.
///
/// Domain    1 ≤ from ≤ to (contract)
/// Accuracy  1e-12, absolute
std::vector<IdenticalGears> identical_gears_chart(const SearchProblem& problem, int rack,
                                                  Angle helix, int from, int to);

}  // namespace gearwright
