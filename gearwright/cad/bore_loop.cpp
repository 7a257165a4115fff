#include "gearwright/cad/bore_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

bool has_keyway(const Bore& bore) { return bore.keyway_width > 0.0; }

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

double bore_reach(const Bore& bore) {
  const double r = bore.diameter / 2.0;
  return has_keyway(bore) ? std::hypot(bore.keyway_width / 2.0, r + bore.keyway_depth) : r;
}

std::optional<Error> bore_error(const Bore& bore, double room) {
  if (!(bore.diameter > 0.0)) {
    return refused("bore.diameter", bore.diameter,
                   "a bore must be greater than 0; leave it out for a solid body");
  }
  if (!(bore.keyway_width >= 0.0 && bore.keyway_width < bore.diameter)) {
    return refused("bore.keyway_width", bore.keyway_width, {0.0, bore.diameter},
                   "a keyway must be at least {} and narrower than the bore, {} mm");
  }
  if (has_keyway(bore) && !(bore.keyway_depth >= 0.0)) {
    return refused("bore.keyway_depth", bore.keyway_depth,
                   "a keyway's depth, measured from the bore circle, must not be negative");
  }
  if (bore_reach(bore) <= room) return std::nullopt;

  const double half = bore.keyway_width / 2.0;
  const double depth = has_keyway(bore) ? bore.keyway_depth : 0.0;
  const double largest =
      room > half ? 2.0 * (std::sqrt((room - half) * (room + half)) - depth) : 0.0;
  const double printed = std::floor(largest * 1000.0) / 1000.0;  // rounded down: it fits
  const char* with = has_keyway(bore) ? " with its keyway" : "";
  return refused(
      "bore.diameter", bore.diameter,
      printed > bore.keyway_width
          ? fmt::format("the bore{} must stay inside the root: at most {:.3f} mm", with, printed)
          : fmt::format("the bore{} must stay inside the root; none does", with));
}

std::vector<Column> bore_columns(const Bore& bore, double chord, double facet_turn) {
  GW_EXPECTS(bore.diameter > 0.0 && bore.keyway_width < bore.diameter && chord > 0.0);
  constexpr double kDown = -std::numbers::pi / 2.0;
  const double r = bore.diameter / 2.0;
  const double half = bore.keyway_width / 2.0;
  // Sagitta r (1 − cos(step/2)) = chord.
  const double step =
      std::min(facet_turn, 4.0 * std::asin(std::min(1.0, std::sqrt(chord / (2.0 * r)))));

  // The right half from the lowest point up; the left half is its mirror image.
  const double top = has_keyway(bore) ? std::acos(half / r) : -kDown;
  const int segments = std::max(3, static_cast<int>(std::ceil((top - kDown) / step)));
  std::vector<Column> right = arc_columns(r, kDown, top, segments);
  right.front() = {{0.0, -r}, {0.0, 1.0}, {0.0, 1.0}};
  if (has_keyway(bore)) {
    right.back().point.x() = half;
    right.back().after = {-1.0, 0.0};
    right.push_back({{half, r + bore.keyway_depth}, {-1.0, 0.0}, {0.0, -1.0}});
  } else {
    right.back() = {{0.0, r}, {0.0, -1.0}, {0.0, -1.0}};
  }

  std::vector<Column> columns = right;
  const auto mirror = [](const Vec2& v) { return Vec2(-v.x(), v.y()); };
  const std::size_t on_axis = has_keyway(bore) ? 0 : 1;  // the top point is its own image
  for (std::size_t i = right.size() - on_axis; i-- > 1;) {
    columns.push_back({mirror(right[i].point), mirror(right[i].after), mirror(right[i].before)});
  }
  return columns;
}

}  // namespace gearwright
