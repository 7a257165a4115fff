// Places the labels of a figure's marks. Internal to figure/.
#pragma once

#include <functional>

#include "gearwright/figure/figure.hpp"
#include "gearwright/figure/free_labels.hpp"

namespace gearwright {

/// Transformation from a figure to its picture.
struct FigurePlace {
  PixelBox plot;
  std::function<Vec2(const Vec2&)> px;
  double per_unit;  ///< px per unit of x
};

/// Writes the label of each mark where it has the fewest overlaps. Dots and crosses come first and
/// are always labelled, even if a label overlaps others. Lines, and then circles, are labelled only
/// if there is room.
void write_labels(Svg& svg, const Figure& figure, const FigurePlace& place);

}  // namespace gearwright
