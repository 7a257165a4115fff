// Two charts over the tooth number, on a logarithmic axis: between which profile shifts a gear can
// be made, and the contact ratio of two identical gears between these limits.
//
//                                              theory: docs/theory/09-design-search.md
#pragma once

#include <string>

#include "gearwright/design/design_row.hpp"

namespace gearwright {

inline constexpr int kChartMin = 7, kChartMax = 100;  ///< teeth

/// Undercut limit, limits of the tip thicknesses 0, 0.2, 0.4 modules and, filled, what the problem
/// itself leaves gear 1; rack and helix are those of the trial, with the design's shifts marked
/// when there is one.
std::string shift_limits_figure(const SearchProblem& problem, const Trial& trial,
                                const DesignRow* design);

/// ε_α at shifts 0, ¼, ½, ¾ and 1 of the way from the least to the greatest; empty for searches of
/// crossed axes and internal gears, about which it says nothing.
std::string identical_gears_figure(const SearchProblem& problem, const Trial& trial);

}  // namespace gearwright
