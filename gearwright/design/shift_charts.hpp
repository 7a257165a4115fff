// Two charts as functions of the tooth number: the range of possible profile shifts, and the contact
// ratio of two identical gears within this range.
//
//   x_u      the undercut limit                     s_an     normal tip tooth thickness
//   x_t(s)   the shift at which s_an = s modules    ε_α      contact ratio of two identical gears
//                                              theory: docs/theory/09-design-search.md
//
// The charts show the range of good designs before any design is computed. Gears of few teeth have a
// small range between undercut and pointed tips, and a small contact ratio. The limits are those of
// trial_gear(), and the contact ratios those of row_at(), as in the search.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/design/search_problem.hpp"

namespace gearwright {

/// Tip thicknesses of the charted limits, modules: pointed tip, and the usual minimum of
/// through-hardened and of case-hardened gears.
inline constexpr std::array<double, 3> kChartTips{0.0, 0.2, 0.4};

/// The shifts of one tooth number, modules.
struct ShiftLimits {
  int teeth = 0;
  double undercut = 0.0;        ///< x_u
  std::array<double, 3> tip{};  ///< x_t of kChartTips
  double min = 0.0, max = 0.0;  ///< limits of the problem; no shift is possible if min > max
};

/// The limits of gear `which` (0, 1) with this rack and helix angle, for every tooth number from … to.
///
/// Domain    1 ≤ from ≤ to (contract)
/// Accuracy  1e-12 modules for 7 … 100 teeth
std::vector<ShiftLimits> shift_limit_chart(const SearchProblem& problem, int rack, Angle helix,
                                           int which, int from, int to);

/// The point of the chart at which the curves of x_u and of x_t for kChartTips[tip] intersect; none if
/// they do not intersect.
///
/// Accuracy  0.01 teeth, because the curves are replaced by chords between whole tooth numbers
struct LimitsMeet {
  double teeth, shift;
  int fewest;  ///< the next greater whole tooth number
};
std::optional<LimitsMeet> where_limits_meet(const std::vector<ShiftLimits>& chart, std::size_t tip);

/// Two identical gears at shifts x = least + k/4 (greatest − least), k = 0 … 4.
struct IdenticalGears {
  ShiftLimits limits;
  std::array<std::optional<double>, 5>
      contact_ratio;  ///< ε_α; none without a working pressure angle, or if no shift is possible
};
/// Identical gears with the rack of gear 1 and opposite hands, on parallel axes. They are mounted as in
/// the problem, at the centre distance that follows from their shifts.
///
/// Domain    1 ≤ from ≤ to (contract)
/// Accuracy  1e-12, absolute
std::vector<IdenticalGears> identical_gears_chart(const SearchProblem& problem, int rack,
                                                  Angle helix, int from, int to);

}  // namespace gearwright
