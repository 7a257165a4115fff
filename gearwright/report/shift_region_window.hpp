// What a picture of the s1–s2 graph shows of it.
//
// Points are (x1, x2), normal modules.
#pragma once

#include <optional>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// A rectangle of the graph, modules.
struct ShiftBox {
  Vec2 lo{0.0, 0.0}, hi{0.0, 0.0};
  void hold(const Vec2& p);
  Vec2 size() const { return hi - lo; }
};

/// The rectangle of the shift limits of both gears.
ShiftBox limits_box(const ShiftGraph& graph);

/// What the picture shows, and whether that is a part only: the whole rectangle where the region is
/// at least `fair_part` as long. In the given ratio of width to height; never without extent.
struct RegionWindow {
  ShiftBox box;
  bool zoomed;
};
RegionWindow region_window(const ShiftBox& limits, const ShiftBox& region, double aspect,
                           double fair_part);

/// Σx at which the pair stands at the centre distance a; none within the window.
///
/// Units     a mm
std::optional<double> sum_at_distance(const ShiftGraph& graph, double a, const ShiftBox& window);

}  // namespace gearwright
