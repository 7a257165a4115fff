// Two charts over the tooth number: the range of possible profile shifts, and the contact ratio of
// two identical gears within this range.
//
//   x_u      the undercut limit                     s_an     normal tip tooth thickness
//   x_t(s)   the shift at which s_an = s modules    ε_α      contact ratio of two identical gears
//                                              theory: docs/theory/09-design-search.md
//
// Both show the range of good designs before any design is computed. Few teeth leave little room
// between undercut and pointed tips, which reduces the contact ratio. All numbers are those of the
// search: limits of trial_gear(), contact ratios of row_at().
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/design/search_problem.hpp"

namespace gearwright {

/// Tip thicknesses of the charted limits, modules: pointed, through-hardened, case-hardened.
inline constexpr std::array<double, 3> kChartTips{0.0, 0.2, 0.4};

/// The shifts of one tooth number, modules.
struct ShiftLimits {
  int teeth = 0;
  double undercut = 0.0;        ///< x_u
  std::array<double, 3> tip{};  ///< x_t of kChartTips
  double min = 0.0, max = 0.0;  ///< those of the problem; none if min > max
};

/// The limits of gear `which` (0, 1) with this rack and helix, for every tooth number of from … to.
///
/// Domain    1 ≤ from ≤ to (contract)
/// Accuracy  1e-12 modules for 7 … 100 teeth
std::vector<ShiftLimits> shift_limit_chart(const SearchProblem& problem, int rack, Angle helix,
                                           int which, int from, int to);

/// The point at which x_u meets x_t of kChartTips[tip] on the chart, between two neighbouring tooth
/// numbers; none if they do not meet.
///
/// Accuracy  0.01 teeth: chords between whole tooth numbers, not the limits of broken ones
struct LimitsMeet {
  double teeth, shift;
  int fewest;  ///< the next whole tooth number
};
std::optional<LimitsMeet> where_limits_meet(const std::vector<ShiftLimits>& chart, std::size_t tip);

/// Two identical gears at shifts x = least + k/4 (greatest − least), k = 0 … 4.
struct IdenticalGears {
  ShiftLimits limits;
  std::array<std::optional<double>, 5>
      contact_ratio;  ///< ε_α; none without a working angle or limits
};

/// Gears of gear 1's rack with opposite hands on parallel axes, mounted as in the problem, at the
/// centre distance that follows from their shifts.
///
/// Domain    1 ≤ from ≤ to (contract)
/// Accuracy  1e-12, absolute
std::vector<IdenticalGears> identical_gears_chart(const SearchProblem& problem, int rack,
                                                  Angle helix, int from, int to);

}  // namespace gearwright
