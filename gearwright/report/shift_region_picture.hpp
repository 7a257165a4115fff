// The s1–s2 graph of one pair of tooth numbers: which profile shifts its limits leave.
//
//   x1 to the right, x2 up, normal modules, one scale for both: lines Σx = const fall at 45°
//   lo, hi   middles of the slices at the least and the greatest Σx
//                                              theory: docs/theory/09-design-search.md
//
// The window follows the region: the whole rectangle of shift limits where the region fills a fair
// part of it, else the region with a small map of the whole in a corner.
#pragma once

#include <string>
#include <vector>

#include "gearwright/design/design_row.hpp"
#include "gearwright/design/shift_region.hpp"

namespace gearwright {

/// The figure with everything named.   Domain: the design's region exists (contract)
std::string shift_region_figure(const ShiftGraph& graph, const DesignRow& row);

/// A small figure with its caption, which leads to `row_link` ("#design-3").   Domain: as above
std::string shift_region_thumbnail(const ShiftGraph& graph, const DesignRow& row,
                                   std::string_view id, std::string_view row_link);

}  // namespace gearwright
