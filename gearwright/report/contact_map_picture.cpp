#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/report/contact_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/plot_axis.hpp"

namespace gearwright {

namespace {

constexpr PlotArea kArea{640, 74, 138, 44, 350, 50};
constexpr int kMaxLevels = 9;

// Values of the map as a raster; what touches nothing lies above every level.
ContourField field_of(const ErrorMap& map) {
  ContourField field{map.x.size(), map.y.size(), {}};
  for (const auto& row : map.value)
    for (const double v : row) field.value.push_back(std::isnan(v) ? kInfinity : v * kArcsecPerRad);
  return field;
}

void draw_legend(Svg& svg, const std::vector<double>& levels, double most, bool gaps) {
  const double left = kArea.width - kArea.right + 22;
  svg.text({kArea.width - 12, 20}, "peak to peak, ″", Anchor::end, "panel");
  const double foot = draw_shades(svg, {left, kArea.top + 4}, levels, "≤ " + shown_arcsec(most));
  if (!gaps) return;
  const double y = foot + 14;
  svg.rect(left, y, kShadeBox, kShadeBox, "zone none");
  svg.text({left + kShadeBox + 9, y + 14}, "no contact", Anchor::start, "tick");
}

}  // namespace

std::vector<double> map_levels(const ErrorMap& map) {
  double lo = kInfinity;
  double hi = -kInfinity;
  for (const auto& row : map.value) {
    for (const double v : row) {
      if (std::isnan(v)) continue;
      lo = std::min(lo, v * kArcsecPerRad);
      hi = std::max(hi, v * kArcsecPerRad);
    }
  }
  // Rounding alone is no field.
  if (!(hi - lo > 1e-6)) return {};
  return levels_between(lo, hi, kMaxLevels);
}

std::string map_figure(const ContactReport& report) {
  GW_EXPECTS(report.map.has_value());
  const ErrorMap& map = report.map->map;
  const auto& names = report.map->axes;
  const Axis x = kArea.across(map.x.front(), map.x.back());
  const Axis y = kArea.up(map.y.front(), map.y.back());
  Svg svg("error-map", kArea.width, kArea.height(), "Peak to peak over two errors",
          fmt::format("Shades and contour lines of the transmission error's peak to peak over {} "
                      "and {}.",
                      names[0].name, names[1].name));
  const ContourField field = field_of(map);
  const std::vector<double> levels = map_levels(map);
  const auto px = [&](const Vec2& node) -> Vec2 {
    return {x.from + node.x() / static_cast<double>(field.columns - 1) * (x.to - x.from),
            y.from + node.y() / static_cast<double>(field.rows - 1) * (y.to - y.from)};
  };
  double most = 0.0;
  bool gaps = false;
  for (const double v : field.value) {
    if (std::isinf(v)) {
      gaps = true;
    } else {
      most = std::max(most, v);
    }
  }
  svg.text({12, 20}, escaped(names[1].name) + ", " + escaped(names[1].unit), Anchor::start,
           "panel");
  svg.begin_clip(x.from, kArea.top, x.to - x.from, kArea.tall);
  // From the whole down to the lowest step, one over the other.
  const std::size_t n = levels.size() + 1;
  svg.rect(x.from, kArea.top, x.to - x.from, kArea.tall, "zone none");
  svg.path(loops_path(regions_below(field, 2 * most + 1), px), shade_style(n - 1, n));
  for (std::size_t i = levels.size(); i-- > 0;) {
    const auto loops = regions_below(field, levels[i]);
    if (!loops.empty()) svg.path(loops_path(loops, px), shade_style(i, n) + " step");
  }
  svg.end_group();
  const Ticks rows = round_ticks(y.lo, y.hi, 6);
  for (const double v : rows.values) {
    svg.line({x.from - 4, y(v)}, {x.from, y(v)}, "axis");
    svg.text({x.from - 8, y(v) + 4}, fixed(v, rows.decimals), Anchor::end, "tick");
  }
  svg.rect(x.from, kArea.top, x.to - x.from, kArea.tall, "axis");
  draw_foot(svg, x, kArea.bottom(), kArea.bottom(), 6,
            escaped(names[0].name) + ", " + escaped(names[0].unit));
  draw_legend(svg, levels, most, gaps);
  const bool inside = names[0].value >= x.lo && names[0].value <= x.hi && names[1].value >= y.lo &&
                      names[1].value <= y.hi;
  if (inside) {
    const Vec2 at(x(names[0].value), y(names[1].value));
    svg.dot(at, 7.5, "here-ring");
    svg.dot(at, 3.0, "here-dot");
  }
  return captioned(svg.str(),
                   fmt::format("<strong>Peak to peak over two errors</strong>, all others as "
                               "specified; the brighter, the more.{}",
                               inside ? " The ringed dot: as specified." : ""));
}

}  // namespace gearwright
