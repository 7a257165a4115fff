#include "gearwright/report/shades.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gearwright {

std::string shade_style(std::size_t i, std::size_t n) {
  const std::size_t shade = n <= 1 ? 0 : (9 * i + (n - 1) / 2) / (n - 1);
  return fmt::format("shade s{}", std::min<std::size_t>(9, shade));
}

double draw_shades(Svg& svg, const Vec2& corner, const std::vector<double>& levels,
                   std::string_view most) {
  const std::size_t n = levels.size() + 1;
  const double left = corner.x();
  const double top = corner.y();
  for (std::size_t i = 0; i < n; ++i) {
    const double y = top + kShadeBox * static_cast<double>(n - 1 - i);
    svg.rect(left, y, kShadeBox, kShadeBox, shade_style(i, n));
    if (i + 1 < n) {
      svg.line({left, y}, {left + kShadeBox + 5, y}, "axis");
      svg.text({left + kShadeBox + 9, y + 4}, fmt::format("{:g}", levels[i]), Anchor::start,
               "tick");
    }
  }
  svg.text({left + kShadeBox + 9, top + 8}, most, Anchor::start, "tick");
  return top + kShadeBox * static_cast<double>(n);
}

}  // namespace gearwright
