// Computes the regions of a raster in which the values are below a level, by marching squares.
//
// The nodes of a raster are (column, row). The value is linear between two nodes. A node with an
// infinite value is above every level, and the border of a region runs halfway between such a node
// and its finite neighbour. A region that reaches the edge of the raster ends there. Values are
// shown in ten shades, from dark (low) to bright (high).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gearwright/curve/curve.hpp"

namespace gearwright {

struct ContourField {
  std::size_t columns = 0, rows = 0;
  std::vector<double> value;  ///< [row · columns + column]; an infinite value is above every level

  double at(std::size_t row, std::size_t column) const { return value[row * columns + column]; }
};

/// Returns closed loops around all points below `level`. The coordinates of a point are (column,
/// row). The region is the interior of the loops by the even-odd rule. The last point of a loop
/// does not repeat the first.
///
/// Laws      (1) the corners of a loop lie on raster edges, where the linear value equals the
///           level, except next to infinite nodes and at the border of the raster
///           (2) regions grow with the level
/// Domain    2 × 2 nodes or more, no NaN (contract)
std::vector<std::vector<Vec2>> regions_below(const ContourField& field, double level);

/// Returns the area within the loops of regions_below(), in squares of the raster. Holes are
/// subtracted, because their loops run in the opposite direction.
double area_of(const std::vector<std::vector<Vec2>>& loops);

/// Returns the style classes of step i of n, counted from the lowest step.
std::string shade_style(std::size_t i, std::size_t n);

}  // namespace gearwright
