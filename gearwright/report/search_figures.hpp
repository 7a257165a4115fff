// The pictures of a design search: the designs by their objectives, the regions of their profile
// shifts, and the limits for each tooth number.
//
//   front    the designs that no other design dominates, joined as a staircase
//   x1, x2   to the right and up, normal modules, at the same scale, so lines Σx = const fall at
//            45°
//   lo, hi   middles of the slices at the least and the greatest Σx
//                                              theory: docs/theory/09-design-search.md
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearwright/design/search.hpp"
#include "gearwright/design/shift_region.hpp"

namespace gearwright {

inline constexpr std::size_t kMaxDots = 2000;  ///< in one picture; more cannot be distinguished

/// The corners of the staircase through the points that no other point dominates. It separates the
/// designs found from the impossible ones. `greater` is true for an axis on which greater values
/// are better.
///
/// Laws   (1) no given point lies beyond it   (2) along it, one value gets worse as the other gets
///            better
std::vector<Vec2> staircase(const std::vector<Vec2>& points, const std::array<bool, 2>& greater);

/// The designs over the first two objectives. A single objective is shown over the centre distance,
/// or over the ratio if the centre distance is given. The first kMaxDots designs and the whole
/// front are drawn. Each dot shows its design at the pointer. Empty if there are no designs.
std::string pareto_figure(const SearchProblem& problem, const SearchAnswer& answer);

/// The s1–s2 graph of one pair of tooth numbers with all names: the profile shifts within the
/// limits. The window is the whole rectangle of shift limits if the region fills a large part of
/// it. Otherwise it is the region, with a small map of the whole in a corner.
///
/// Domain    the region of the design exists (contract), here and below
std::string shift_region_figure(const ShiftGraph& graph, const DesignRow& row);

/// A small figure whose caption links to `row_link` ("#design-3").
std::string shift_region_thumbnail(const ShiftGraph& graph, const DesignRow& row,
                                   std::string_view id, std::string_view row_link);

inline constexpr int kChartMin = 7, kChartMax = 100;  ///< teeth

/// The range of possible profile shifts over the tooth number on a logarithmic axis: the undercut
/// limit, the limits for tip thicknesses of 0, 0.2 and 0.4 modules, and, filled, the range of gear
/// 1 within the limits of the problem. Rack and helix are those of the trial. The shifts of a
/// design are marked.
std::string shift_limits_figure(const SearchProblem& problem, const Trial& trial,
                                const DesignRow* design);

/// The contact ratio of two identical gears: ε_α at shifts 0, ¼, ½, ¾ and 1 of the way from the
/// least to the greatest. Empty for searches of crossed axes and internal gears, to which it does
/// not apply.
std::string identical_gears_figure(const SearchProblem& problem, const Trial& trial);

}  // namespace gearwright
