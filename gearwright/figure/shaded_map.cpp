#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "gearwright/figure/contact_figures.hpp"

namespace gearwright {

namespace {

constexpr double kAll = std::numeric_limits<double>::max();

}  // namespace

std::string step_words(const std::vector<double>& levels, std::size_t i, std::string_view unit) {
  const auto value = [&](std::size_t k) {
    return fmt::format("{:g}{}{}", levels[k], unit == "″" ? "" : " ", unit);
  };
  if (levels.empty()) return {};
  if (i == 0) return "below " + value(0);
  if (i == levels.size()) return "above " + value(i - 1);
  return value(i - 1) + " to " + value(i);
}

void add_map(Figure& f, const FlankRaster& raster, const std::vector<double>& levels,
             std::string words, std::string unit, std::optional<double> above) {
  // The regions above a level are computed from the negated values.
  ContourField field = field_of(raster);
  for (double& v : field.value)
    if (std::isfinite(v)) v = -v;
  const std::size_t n = levels.size() + 1;
  for (std::size_t i = 0; i < n; ++i)
    f.area(region_below(raster, field,
                        i > 0   ? -levels[i - 1]
                        : above ? -*above
                                : kAll),
           shade_style(i, n) + (i > 0 ? " step" : ""), step_words(levels, i, unit));
  f.grid =
      FigureGrid{std::move(words), std::move(unit), raster.height, raster.diameter, raster.gap};
}

}  // namespace gearwright
