// Where the labels of a figure's marks stand. Internal to figure.
#pragma once

#include <functional>

#include "gearwright/figure/figure.hpp"
#include "gearwright/figure/free_labels.hpp"

namespace gearwright {

/// How a figure lies in its picture.
struct FigurePlace {
  PixelBox plot;
  std::function<Vec2(const Vec2&)> px;
  double per_unit;  ///< px per unit of x
};

/// Writes the label of each mark where it touches no other: first of dots and crosses, which always
/// have one, then of lines, then of circles, which have one where there is room.
void write_labels(Svg& svg, const Figure& figure, const FigurePlace& place);

}  // namespace gearwright
