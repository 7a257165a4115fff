#include "gearwright/cad/bore_walls.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "gearwright/cad/bore_loop.hpp"

namespace gearwright {
namespace {

using std::numbers::pi;

WallLoop circle(double radius) {
  // One wall from the +y axis once round.
  const Complex top(0.0, radius);
  WallLoop loop;
  loop.walls.push_back(
      {WallShape::circle, top, top, nullptr, {}, radius, pi / 2.0, pi / 2.0 + 2.0 * pi});
  return loop;
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

Result<WallLoop> make_rim(const ToothedBody& body, double outer) {
  const double room = outer + kShortestArc_mm;
  const double smallest = std::ceil(2.0 * room * 1000.0) / 1000.0;  // rounded up: it fits
  const std::string need = fmt::format(
      "a ring's bore is its rim and must lie around its roots: at least {:.3f} mm", smallest);
  if (!body.bore) return Error{"bore.diameter", "", need};
  const Bore& rim = *body.bore;
  if (rim.keyway_width > 0.0) {
    return refused("bore.keyway_width", rim.keyway_width, "a ring has no keyway; leave it out");
  }
  if (!(rim.diameter / 2.0 >= room)) {
    return refused("bore.diameter", rim.diameter, need);
  }
  return circle(rim.diameter / 2.0);
}

}  // namespace

Result<WallLoop> make_bore(const ToothedBody& body, double inner, double outer) {
  if (body.outline.teeth < 0) return make_rim(body, outer);
  const Bore& bore = *body.bore;
  if (auto error = bore_error(bore, inner - kShortestArc_mm)) return *std::move(error);
  const double radius = bore.diameter / 2.0;
  const double half = bore.keyway_width / 2.0;
  if (half == 0.0) return circle(radius);
  const double bottom = radius + bore.keyway_depth;
  // The slot's sides are faces; shorter than a sliver they, and with them the slot, are left out.
  const double mouth = std::sqrt((radius - half) * (radius + half));
  if (bottom - mouth < kShortestArc_mm) return circle(radius);
  return circle_with_keyway(radius, half, bottom);
}

}  // namespace gearwright
