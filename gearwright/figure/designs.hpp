// Shows the designs of a search as dots over two of their quantities.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearwright/figure/figure.hpp"

namespace gearwright {

/// The direction in which the values of an axis become better. It is `none` if the axis is not an
/// objective.
enum class Better { none, smaller, greater };
struct DesignAxis {
  FigureAxis axis;
  Better better = Better::none;
};

struct DesignDot {
  Vec2 at;
  std::string style;       ///< "dot-front", "dot-design", "dot-middle"
  std::string words = {};  ///< name of the design, shown at the pointer together with both values
};

/// Returns the corners of the staircase through the points that no other point dominates. The
/// staircase separates the designs found from the part of the plane without designs. `greater` is
/// true for an axis on which greater values are better.
///
/// Laws      (1) no given point lies beyond the staircase
///           (2) along the staircase, one value becomes worse as the other becomes better
std::vector<Vec2> staircase(const std::vector<Vec2>& points, const std::array<bool, 2>& greater);

/// Draws the dots in the given order. If both axes are objectives and the front has several dots,
/// the staircase of the dots of the front is drawn behind them. The axis of an objective states
/// which values are better. The axes extend a little beyond the dots. An axis of positive values is
/// logarithmic if the greatest value exceeds fifteen times the least.
///
/// Domain    at least one dot, all of them finite (contract)
Figure designs_figure(DesignAxis x, DesignAxis y, const std::vector<DesignDot>& dots);

}  // namespace gearwright
