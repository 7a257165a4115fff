// Values as ten shades from dark (low) to bright, with the levels at which they change.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/report/svg.hpp"

namespace gearwright {

constexpr double kShadeBox = 20.0;  ///< px, of the key

/// Classes of step i of n, from the lowest on.
std::string shade_style(std::size_t i, std::size_t n);

/// The key: a box for each step, the lowest at the bottom, with the levels between them and the
/// words at its upper end (SVG markup). Where it ends, px.
double draw_shades(Svg& svg, const Vec2& corner, const std::vector<double>& levels,
                   std::string_view most);

}  // namespace gearwright
