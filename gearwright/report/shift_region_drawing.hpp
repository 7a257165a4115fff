// The parts of a picture of the s1–s2 graph, large or small: a window with the rectangle of the
// shift limits, the region with its edges, and the lines of the centre distances.
//
// Points are (x1, x2), normal modules.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/design/shift_graph.hpp"
#include "gearwright/design/shift_region.hpp"
#include "gearwright/report/free_labels.hpp"
#include "gearwright/report/plot_axis.hpp"

namespace gearwright {

/// The rectangle of the shift limits of both gears.
Bounds limits_box(const ShiftGraph& graph);

/// The window of the picture, and whether it is only a part: the whole rectangle if the region is
/// at least `fair_part` as long. It has the given ratio of width to height, and is never empty.
struct RegionWindow {
  Bounds box;
  bool zoomed;
};
RegionWindow region_window(const Bounds& limits, const Bounds& region, double aspect,
                           double fair_part);

/// Σx at the centre distance a; none if outside the window.   Units     a mm
std::optional<double> sum_at_distance(const ShiftGraph& graph, double a, const Bounds& window);

/// The boundary of every piece of a region.
using Loops = std::vector<std::vector<RegionEdge>>;

/// A window of the graph on a rectangle of the picture.
struct GraphFrame {
  Axis x, y;
  Vec2 px(const Vec2& p) const { return {x(p.x()), y(p.y())}; }
  std::vector<Vec2> px(const std::vector<Vec2>& points) const;
  Bounds box() const { return {{x.lo, y.lo}, {x.hi, y.hi}}; }
};
GraphFrame frame_on(const Bounds& box, const PixelBox& place);

/// All points of a loop, in order.
std::vector<Vec2> outline_of(const std::vector<RegionEdge>& loop);

void draw_box(Svg& svg, const GraphFrame& g, const Bounds& box, std::string_view style);

/// Draws the region filled, each edge in the colour of its kind. A single point is a dot.
void draw_region(Svg& svg, const GraphFrame& g, const Loops& loops, const ShiftRegion& region);

/// True if one centre distance is requested instead of a range.
bool exact_distance(const SearchProblem& problem);

/// The requested centre distances, as thin lines through the whole window.
struct DistanceLine {
  double distance;  ///< a  mm
  std::vector<Vec2> px;
};
std::vector<DistanceLine> draw_distances(Svg& svg, const ShiftGraph& graph, const GraphFrame& g);

}  // namespace gearwright
