#include <fmt/format.h>

#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/figure/shift_region.hpp"
#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/search_figures.hpp"
#include "gearwright/report/search_table.hpp"

namespace gearwright {

namespace {

constexpr double kRegionAspect = 554.0 / 450.0;
constexpr double kSmallRegionAspect = 200.0 / 170.0;
// If the longer side of the region is at least this fraction of the longer side of the rectangle of
// shift limits, the whole rectangle is shown.
constexpr double kFairPart = 0.62;
// kFairPart for small pictures. The value is lower, because most small pictures should have the
// same scale.
constexpr double kSmallFairPart = 0.12;

Vec2 design_of(const DesignRow& row) { return {row.shift[0], row.shift[1]}; }

std::string description(const ShiftRegion& region, const DesignRow& row) {
  return region_words(region) +
         fmt::format(" The design is at ({}, {}).", fixed(row.shift[0], 4), fixed(row.shift[1], 4));
}

std::string caption(const ShiftGraph& graph, const ShiftRegion& region, UnitSystem units) {
  const SearchProblem& problem = graph.problem();
  const std::string area =
      region.area >= 0.01 ? "an area of " + fixed(region.area, 4) + " modules²"
      : region.area > 0.0 ? fmt::format("an area of {:.3g} modules²", region.area)
                          : std::string("no area, because the limits leave only a line or a point");
  const std::string line =
      problem.internal()
          ? std::string("the line on which only the pinion has a profile shift")
          : fmt::format(
                "the line on which the teeth of both gears are about equally strong ({} = {:g})",
                symbol_html("λ"), problem.lambda);
  return fmt::format(
      ". The filled region has {}. The faint rectangle shows the limits of the profile shifts. "
      "{}The dashed line is {}; its feasible part is thick. The dots mark the middles of the lines "
      "of least and greatest {} in the region. The ring marks the design. Edges of the region:",
      area,
      problem.center_distance
          ? fmt::format("The thin lines are centre distances in {}. ", to_string(units))
          : "",
      line, symbol_html("Σx"));
}

}  // namespace

std::string shift_region_figure(const ShiftGraph& graph, const DesignRow& row, UnitSystem units) {
  const ShiftChart chart = shift_chart(graph, design_of(row));
  Figure f = shift_region_figure(
      chart, region_window(limits_box(graph), chart.around, kRegionAspect, kFairPart));
  f.title = fmt::format("Where {} is feasible", design_name(row.trial));
  f.description = description(chart.region, row);
  f.caption = caption(graph, chart.region, units);
  f.dot(design_of(row), 7.0, "design-ring");
  f.point(design_of(row), 2.5, "design-dot", "design", {13.0, 0.0});
  f.marks.back().label_style = "halo letter";
  return figure_html(in_units(units, f), kWideFigure);
}

std::string shift_region_thumbnail(const ShiftGraph& graph, const DesignRow& row,
                                   std::string_view id, std::string_view row_link) {
  const ShiftChart chart = shift_chart(graph, design_of(row));
  const std::string name = design_name(row.trial);
  Figure f = small_shift_region(
      chart,
      region_window(limits_box(graph), chart.around, kSmallRegionAspect, kSmallFairPart).box);
  f.id = id;
  f.title = "Feasible profile shifts of " + name;
  f.description = description(chart.region, row);
  f.dot(design_of(row), 4.0, "design-small");
  return captioned(figure_svg(f, kSmallFigure),
                   fmt::format("<strong><a href=\"{}\">{}</a></strong><br>{} {}", row_link, name,
                               symbol_html("ε_α"), fixed(row.contact_ratio, 3)));
}

}  // namespace gearwright
