// Shows the s1–s2 graph of one pair of tooth numbers, which contains the profile shifts that
// satisfy the limits. The figure contains the rectangle of the shift limits, the region with its
// named edges, the lines of the centre distances and the line of balanced shifts.
//
// Points are (x1, x2) in normal modules. Both axes have the same scale, so lines with a constant
// sum Σx = x1 + x2 fall at 45°.
//                                              theory: docs/theory/09-design-search.md
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/design/shift_graph.hpp"
#include "gearwright/design/shift_region.hpp"
#include "gearwright/figure/figure.hpp"

namespace gearwright {

/// Returns the name of an edge, for example "least shift of gear 1" or "contact ratio".
std::string_view words_of(ShiftEdge edge);
/// Returns the style class of an edge, for example "edge-g1 far".
std::string_view style_of(ShiftEdge edge);

Bounds limits_box(const ShiftGraph& graph);

/// The window of the picture. If the longer side of the region is at least `fair_part` times the
/// longer side of the limits, the window covers all limits. Otherwise, it covers only the region
/// (`zoomed`). The window has the given ratio of width to height and is never empty.
struct RegionWindow {
  Bounds box;
  bool zoomed;
};
RegionWindow region_window(const Bounds& limits, const Bounds& region, double aspect,
                           double fair_part);

/// Returns the Σx at which the pair has the centre distance a, or nothing if the line of this Σx is
/// outside the window.
///
/// Units     a mm
std::optional<double> sum_at_distance(const ShiftGraph& graph, double a, const Bounds& window);

/// Returns true if one exact centre distance is required, not a range.
bool exact_distance(const SearchProblem& problem);

struct ShiftChart {
  const ShiftGraph& graph;
  ShiftRegion region;
  std::vector<std::vector<RegionEdge>> loops;  ///< the boundary of every piece
  Bounds around;                               ///< bounds of the region and the design
};
/// Domain    the graph has a region (contract)
ShiftChart shift_chart(const ShiftGraph& graph, const Vec2& design);

/// Returns the description of a picture of the region.
std::string region_words(const ShiftRegion& region);

/// Draws only the rectangle of the limits and the lines of the centre distances, for a graph
/// without a region.
Figure shift_limits_figure(const ShiftGraph& graph, const Bounds& window);

/// Draws the region with the names of its edges, which the legend also lists, and marks the points
/// with the least and the greatest Σx. If the window shows only a part of the limits, a small map
/// of all limits is in a corner.
Figure shift_region_figure(const ShiftChart& chart, const RegionWindow& window);

/// Draws the limits, the region with its edges and the lines of the centre distances, without axes.
Figure small_shift_region(const ShiftChart& chart, const Bounds& window);

/// Returns the figure with gear 1 and gear 2 exchanged.
Figure exchanged(Figure figure);

}  // namespace gearwright
