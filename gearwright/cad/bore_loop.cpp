#include "gearwright/cad/bore_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

// Columns of an arc of the circle from `begin` to `end` rad, both ends included.
std::vector<Column> arc_columns(double radius, double begin, double end, int segments) {
  std::vector<Column> columns;
  for (int i = 0; i <= segments; ++i) {
    const double angle = begin + (end - begin) * i / segments;
    const Vec2 radial(std::cos(angle), std::sin(angle));
    columns.push_back({radius * radial, -radial, -radial});
  }
  return columns;
}

}  // namespace

std::vector<Column> bore_columns(const Bore& bore, double chord, double facet_turn) {
  GW_EXPECTS(bore.diameter > 0.0 && bore.keyway_width < bore.diameter && chord > 0.0);
  constexpr double kDown = -std::numbers::pi / 2.0;
  const double r = bore.diameter / 2.0;
  const double half = bore.keyway_width / 2.0;
  // Sagitta r (1 − cos(step/2)) = chord.
  const double step =
      std::min(facet_turn, 4.0 * std::asin(std::min(1.0, std::sqrt(chord / (2.0 * r)))));

  // The right half from the lowest point up; the left half is its mirror image.
  const double top = bore.has_keyway() ? std::acos(half / r) : -kDown;
  const int segments = std::max(3, static_cast<int>(std::ceil((top - kDown) / step)));
  std::vector<Column> right = arc_columns(r, kDown, top, segments);
  right.front() = {{0.0, -r}, {0.0, 1.0}, {0.0, 1.0}};
  if (bore.has_keyway()) {
    right.back().point.x() = half;
    right.back().after = {-1.0, 0.0};
    right.push_back({{half, r + bore.keyway_depth}, {-1.0, 0.0}, {0.0, -1.0}});
  } else {
    right.back() = {{0.0, r}, {0.0, -1.0}, {0.0, -1.0}};
  }

  std::vector<Column> columns = right;
  const auto mirror = [](const Vec2& v) { return Vec2(-v.x(), v.y()); };
  const std::size_t on_axis = bore.has_keyway() ? 0 : 1;  // the top point is its own image
  for (std::size_t i = right.size() - on_axis; i-- > 1;) {
    columns.push_back({mirror(right[i].point), mirror(right[i].after), mirror(right[i].before)});
  }
  return columns;
}

}  // namespace gearwright
