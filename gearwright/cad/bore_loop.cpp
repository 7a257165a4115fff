#include "gearwright/cad/bore_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

using std::numbers::pi;

// Returns columns on a circular arc from the angle `begin` to `end`, rad, including both ends.
std::vector<Column> arc_columns(double radius, double begin, double end, int segments) {
  std::vector<Column> columns;
  for (int i = 0; i <= segments; ++i) {
    const double angle = begin + (end - begin) * i / segments;
    const Vec2 radial(std::cos(angle), std::sin(angle));
    columns.push_back({radius * radial, -radial, -radial});
  }
  return columns;
}

WallLoop circle_with_keyway(double radius, double half, double bottom) {
  const double y = std::sqrt((radius - half) * (radius + half));
  const Complex left(-half, y);
  const Complex right(half, y);
  const Complex right_corner(half, bottom);
  const Complex left_corner(-half, bottom);
  const double side = std::asin(half / radius);
  WallLoop loop;
  loop.walls.push_back({WallShape::circle,
                        left,
                        right,
                        nullptr,
                        {},
                        radius,
                        pi / 2.0 + side,
                        pi / 2.0 + 2.0 * pi - side});
  const auto line = [&](Complex from, Complex to) {
    loop.walls.push_back({WallShape::line, from, to, nullptr, {}});
  };
  line(right, right_corner);
  line(right_corner, left_corner);
  line(left_corner, left);
  return loop;
}

}  // namespace

WallLoop circle_loop(double radius) {
  const Complex top(0.0, radius);
  WallLoop loop;
  loop.walls.push_back(
      {WallShape::circle, top, top, nullptr, {}, radius, pi / 2.0, pi / 2.0 + 2.0 * pi});
  return loop;
}

std::vector<Column> bore_columns(const Bore& bore, double chord, double facet_turn) {
  GW_EXPECTS(bore.diameter > 0.0 && bore.keyway_width < bore.diameter && chord > 0.0);
  constexpr double kDown = -pi / 2.0;
  const double r = bore.diameter / 2.0;
  const double half = bore.keyway_width / 2.0;
  // The step has the sagitta r (1 − cos(step/2)) = chord, or the length facet_turn if this is
  // smaller.
  const double step =
      std::min(facet_turn, 4.0 * std::asin(std::min(1.0, std::sqrt(chord / (2.0 * r)))));

  // The right half runs upwards from the lowest point. The left half is its mirror image.
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
  const std::size_t on_axis = bore.has_keyway() ? 0 : 1;  // a point on the axis is not mirrored
  for (std::size_t i = right.size() - on_axis; i-- > 1;) {
    columns.push_back({mirror(right[i].point), mirror(right[i].after), mirror(right[i].before)});
  }
  return columns;
}

Result<WallLoop> make_bore(const ToothedBody& body, double inner, double outer) {
  const bool ring = body.ring();
  const HoleLimits limits = body.hole_limits(ring ? outer : inner);
  if (auto error = hole_error(body.bore, limits)) return *std::move(error);
  const Bore& bore = *body.bore;
  if (ring) return circle_loop(bore.diameter / 2.0);
  const double radius = bore.diameter / 2.0;
  const double half = bore.keyway_width / 2.0;
  if (half == 0.0) return circle_loop(radius);
  const double bottom = radius + bore.keyway_depth;
  const double mouth = std::sqrt((radius - half) * (radius + half));
  if (bottom - mouth < kShortestArc_mm) return circle_loop(radius);
  return circle_with_keyway(radius, half, bottom);
}

Result<std::optional<BoreContour>> bore_contour(const ToothedBody& body, double inner,
                                                double outer) {
  if (!body.bore) return std::optional<BoreContour>();
  if (const auto checked = make_bore(body, inner, outer); !checked) return checked.error();
  const double r = body.bore->diameter / 2.0;
  const double half = body.bore->keyway_width / 2.0;
  if (half == 0.0) return std::optional(BoreContour{r, false, {{r, 0.0}, {-r, 0.0}}, {1.0, 1.0}});

  // The circular part of the bore spans more than half a turn. It is therefore divided into two
  // arcs, which meet at (0, −r).
  const double y = std::sqrt((r - half) * (r + half));
  const double floor = r + body.bore->keyway_depth;
  const double bulge = std::tan((pi - std::asin(half / r)) / 4.0);
  return std::optional(
      BoreContour{r,
                  true,
                  {{-half, y}, {0.0, -r}, {half, y}, {half, floor}, {-half, floor}},
                  {bulge, bulge, 0.0, 0.0, 0.0}});
}

}  // namespace gearwright
