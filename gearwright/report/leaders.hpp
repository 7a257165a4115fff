// Labels in a column beside a plot, each with a line to what it names.
#pragma once

#include <string>
#include <vector>

#include "gearwright/report/svg.hpp"

namespace gearwright {

struct Leader {
  Vec2 from;           ///< px, what is named
  std::string markup;  ///< SVG text content
};

/// Draws the labels at `x` and to its right, one below the other in the order of what they name,
/// between the top and `height`.
void draw_leaders(Svg& svg, const std::vector<Leader>& leaders, double x, double height);

/// Where a circle about `axis` leaves a plot at its right edge, or before when it is small; px.
Vec2 leaves_right(const Vec2& axis, double radius, double edge);

}  // namespace gearwright
