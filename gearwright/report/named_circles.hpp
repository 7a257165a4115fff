// Circles of both gears around their mesh, with their symbols where they leave the picture: gear
// 1's at the top, gear 2's at the bottom.
#pragma once

#include <string>
#include <vector>

#include "gearwright/figure/svg.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/report/free_labels.hpp"

namespace gearwright {

struct NamedCircle {
  std::string symbol;
  double radius;      ///< mm
  const char* style;  ///< classes beside "thin" and the gear's colour, with a space before: " dash"
};

/// Tip, working pitch and base circle of gear `i` (0, 1), named d_a1, d_w1, d_b1.
std::vector<NamedCircle> mesh_circles(const InvolutePair& pair, std::size_t i);

/// Draws circles about `axis` (mm). `side` is where the mesh lies: +1 to the right of the axis;
/// `gear` is 0 or 1. A circle that lies entirely in the window is named next to it, on the other
/// side. Returns  the boxes of the names.
std::vector<PixelBox> draw_named_circles(Svg& svg, const Viewport& view, const Vec2& axis,
                                         double side, std::size_t gear,
                                         const std::vector<NamedCircle>& circles);

}  // namespace gearwright
