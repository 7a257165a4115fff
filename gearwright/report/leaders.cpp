#include "gearwright/report/leaders.hpp"

#include <algorithm>
#include <cmath>

namespace gearwright {

namespace {

constexpr double kLabelGap = 19.0;  // px

}  // namespace

void draw_leaders(Svg& svg, const std::vector<Leader>& leaders, double x, double height) {
  std::vector<double> wanted;
  for (const Leader& l : leaders) wanted.push_back(l.from.y());
  const std::vector<double> placed = spread(wanted, kLabelGap, 12.0, height - 10.0);
  for (std::size_t i = 0; i < leaders.size(); ++i) {
    const Vec2& from = leaders[i].from;
    svg.polyline({from, {std::max(x - 8, from.x()), placed[i]}, {x, placed[i]}}, "leader");
    svg.text({x, placed[i]}, leaders[i].markup, Anchor::start, "", {3.0, 4.0});
  }
}

Vec2 leaves_right(const Vec2& axis, double radius, double edge) {
  const double dx = std::min(edge - axis.x(), 0.94 * radius);
  return {axis.x() + dx, axis.y() - std::sqrt(std::max(0.0, (radius - dx) * (radius + dx)))};
}

}  // namespace gearwright
