#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/figure/ticks.hpp"

namespace gearwright {

namespace {

constexpr int kMaxLevels = 9;

// Returns the values of the map as a raster, arcsec. Points without contact are above every level.
FlankRaster raster_of(const ErrorMap& map) {
  FlankRaster raster{map.y, map.x, {}};
  for (const auto& row : map.value)
    for (const double v : row) raster.gap.push_back(std::isnan(v) ? kInfinity : v * kArcsecPerRad);
  return raster;
}

}  // namespace

std::vector<double> map_levels(const ErrorMap& map) {
  double lo = kInfinity;
  double hi = -kInfinity;
  for (const double v : raster_of(map).gap) {
    if (v == kInfinity) continue;
    lo = std::min(lo, v);
    hi = std::max(hi, v);
  }
  // A field that consists of rounding errors is not drawn.
  if (!(hi - lo > 1e-6)) return {};
  return levels_between(lo, hi, kMaxLevels);
}

Figure error_map_figure(const ContactMap& both) {
  const ErrorMap& map = both.map;
  const auto& [across, up] = both.axes;
  Figure f{
      "error-map",
      "Peak-to-peak transmission error as a function of two errors",
      fmt::format("Shades and contour lines of the peak-to-peak transmission error as a function "
                  "of {} and {}.",
                  across.name, up.name),
      ", with all other errors as specified. Brighter shades show greater values.",
      {across.name, across.unit, map.x.front(), map.x.back()},
      {up.name, up.unit, map.y.front(), map.y.back()},
      "",
      0.85};
  const FlankRaster raster = raster_of(map);
  const std::vector<double> levels = map_levels(map);
  double most = 0.0;
  bool gaps = false;
  for (const double v : raster.gap) {
    if (std::isinf(v))
      gaps = true;
    else
      most = std::max(most, v);
  }
  f.shades = {levels, "≤ " + shown_arcsec(most) + "″",
              !gaps        ? ""
              : both.whole ? "no contact"
                           : "not yet computed"};
  f.bar({-kInfinity, -kInfinity}, {kInfinity, kInfinity}, "zone none");
  add_map(f, raster, levels, "transmission error, peak to peak", "″");
  const bool inside = across.value >= map.x.front() && across.value <= map.x.back() &&
                      up.value >= map.y.front() && up.value <= map.y.back();
  if (!inside) return f;
  f.dot({across.value, up.value}, 7.5, "here-ring");
  f.dot({across.value, up.value}, 3.0, "here-dot", "as specified");
  f.caption += " The ringed dot is the pair as specified.";
  return f;
}

}  // namespace gearwright
