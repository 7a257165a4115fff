// Regions of a raster in which its values stay below a level, by marching squares.
//
// A raster's nodes are (column, row); between two of them the value is linear. An infinite node
// lies above every level, and the border runs halfway to it, because the end of the values between
// the nodes is unknown. The raster's own edge closes every region. Values are shown as ten shades
// from dark (low) to bright, with the levels at which they change.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gearwright/curve/curve.hpp"

namespace gearwright {

struct ContourField {
  std::size_t columns = 0, rows = 0;
  std::vector<double> value;  ///< [row · columns + column]; infinite: above every level

  double at(std::size_t row, std::size_t column) const { return value[row * columns + column]; }
};

/// Closed loops, (column, row), around all places below `level`; filled by the even-odd rule they
/// are the region. The last point is not repeated.
///
///   Laws      (1) a loop's corners lie on the raster's edges, where the linear value is the level
///             (2) regions grow with the level
/// Domain    2 × 2 nodes or more, no NaN (contract)
std::vector<std::vector<Vec2>> regions_below(const ContourField& field, double level);

/// The enclosed area in squares of the raster, even-odd.
double area_of(const std::vector<std::vector<Vec2>>& loops);

/// Classes of step i of n, from the lowest on.
std::string shade_style(std::size_t i, std::size_t n);

}  // namespace gearwright
