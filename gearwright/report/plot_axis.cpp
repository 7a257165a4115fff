#include "gearwright/report/plot_axis.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"

namespace gearwright {

double Axis::near(double v) const {
  const double length = std::abs(to - from);
  return std::clamp((*this)(v), std::min(from, to) - length, std::max(from, to) + length);
}

void draw_rows(Svg& svg, const Axis& x, const Axis& y, int most) {
  const Ticks ticks = round_ticks(y.lo, y.hi, most);
  for (const double v : ticks.values) {
    svg.line({x.from, y(v)}, {x.to, y(v)}, v == 0.0 ? "axis" : "grid");
    svg.text({x.from - 6, y(v) + 4}, tick_text(v, ticks.decimals), Anchor::end, "tick");
  }
  svg.line({x.from, y.from}, {x.to, y.from}, "axis");
}

void draw_foot(Svg& svg, const Axis& x, double top, double bottom, int most,
               std::string_view words) {
  const Ticks ticks = round_ticks(x.lo, x.hi, most);
  for (const double v : ticks.values) {
    svg.line({x(v), top}, {x(v), bottom + 4}, "grid");
    svg.text({x(v), bottom + 17}, tick_text(v, ticks.decimals), Anchor::middle, "tick");
  }
  svg.text({(x.from + x.to) / 2, bottom + 36}, words, Anchor::middle, "tick");
}

void draw_curve(Svg& svg, const Axis& x, const Axis& y, const std::vector<Vec2>& values,
                std::string_view style) {
  std::vector<Vec2> points;
  const auto draw = [&] {
    if (points.size() > 1) svg.polyline(points, style);
    points.clear();
  };
  for (const Vec2& v : values) {
    if (std::isfinite(v.x()) && std::isfinite(v.y()))
      points.push_back({x.near(v.x()), y.near(v.y())});
    else
      draw();
  }
  draw();
}

}  // namespace gearwright
