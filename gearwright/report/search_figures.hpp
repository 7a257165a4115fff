// Draws the pictures of a design search. They show the designs by their objectives, the regions of
// their profile shifts, and the limits for each number of teeth.
//
//   front    the designs that no other design dominates; a staircase joins them
//   x1, x2   profile shifts, to the right and up, normal modules, at the same scale
//   Σx       x1 + x2; lines of constant Σx fall at 45°
//   lo, hi   midpoints of the region on its lines of least and greatest Σx
//                                              theory: docs/theory/09-design-search.md
#pragma once

#include <string>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/design/search.hpp"
#include "gearwright/design/shift_region.hpp"

namespace gearwright {

/// Number of designs with a dot, besides the front. More dots cannot be distinguished.
inline constexpr std::size_t kMaxDots = 2000;

/// Returns a figure of the designs over the first two objectives. If there is only one objective,
/// the second axis shows the centre distance, or the ratio if one exact centre distance is given.
/// The figure shows the first kMaxDots designs and the whole front. If the user points at a dot,
/// its design is shown. The result is empty if no design has both values.
std::string pareto_figure(const SearchProblem& problem, const SearchAnswer& answer,
                          UnitSystem units = UnitSystem::mm);

/// Draws the s1–s2 graph of one pair of tooth numbers. It shows all limits with their names, and
/// the profile shifts within the limits. If the region fills a large part of the rectangle of shift
/// limits, the figure shows this whole rectangle. Otherwise it shows the region, with a small map
/// of the rectangle in a corner.
///
/// Domain    the region of the design exists (contract), here and below
std::string shift_region_figure(const ShiftGraph& graph, const DesignRow& row,
                                UnitSystem units = UnitSystem::mm);

/// Draws a small figure of the region of the design. The caption links to `row_link` ("#design-3").
std::string shift_region_thumbnail(const ShiftGraph& graph, const DesignRow& row,
                                   std::string_view id, std::string_view row_link);

inline constexpr int kChartMin = 7, kChartMax = 100;  ///< range of tooth numbers in the charts

/// Draws the range of possible profile shifts over the number of teeth, on a logarithmic axis.
/// Curves show the undercut limit, and the limits for tip thicknesses of 0, 0.2 and 0.4 modules.
/// The filled area is the range of gear 1 within the limits of the problem. Rack and helix angle
/// are taken from the trial. The shifts of the given design are marked.
std::string shift_limits_figure(const SearchProblem& problem, const Trial& trial,
                                const DesignRow* design);

/// Draws the contact ratio ε_α of two identical gears over their number of teeth. There are five
/// curves, at 0, ¼, ½, ¾ and 1 of the way from the least to the greatest profile shift that the
/// search allows. The result is empty for a search for crossed axes or internal gears, to which the
/// chart does not apply.
std::string identical_gears_figure(const SearchProblem& problem, const Trial& trial);

}  // namespace gearwright
