#include <fmt/format.h>

#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/catalogue/scatter_tables.hpp"
#include "gearwright/figure/distribution_figures.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

std::string index_part(const ScatterView& view, UnitSystem units) {
  const auto& indices =
      view.scatter->indices[static_cast<std::size_t>(ScatterQuantity::peak_to_peak)];
  if (!indices) return {};
  IndexScene scene{"scatter-indices", scatter_entries()[0].words, {}};
  std::string names;
  for (std::size_t g = 0; g < view.task->groups.size(); ++g) {
    const std::string name = key_in(units, view.task->groups[g].name);
    scene.groups.push_back({name, indices->first[g].value, indices->total[g].value});
    names += fmt::format("{}{}: {}", g == 0 ? "" : ", ", g + 1, escaped(name));
  }
  return html_of(index_figure(scene)) + "<p>" + names + ".</p>\n";
}

}  // namespace

std::optional<DistributionScene> distribution_scene(const ScatterView& view,
                                                    ScatterQuantity quantity, const char* id) {
  const auto& spread = view.spread[static_cast<std::size_t>(quantity)];
  if (!spread || !(spread->spread->least < spread->spread->greatest)) return std::nullopt;
  const SpreadEntry& entry = *spread->entry;
  DistributionScene scene{id, entry.words, std::string(unit_text(entry.unit)), {}, {}};
  for (const ScatterSample& s : view.scatter->samples) {
    const auto value = s.member[quantity];
    if (!s.member.lost && value) scene.values.push_back(entry.shown(*value));
  }
  for (const Percentile& p : spread->spread->percentiles)
    scene.percentiles.emplace_back(p.percent, entry.shown(p.estimate.value));
  return scene;
}

std::vector<Figure> scatter_figures(const ScatterView& view) {
  std::vector<Figure> figures;
  if (const auto te = distribution_scene(view, ScatterQuantity::peak_to_peak, "scatter-te")) {
    figures.push_back(histogram_figure(*te));
    figures.push_back(cumulative_figure(*te));
  }
  if (const auto play = distribution_scene(view, ScatterQuantity::least_play, "scatter-play"))
    figures.push_back(histogram_figure(*play));
  for (std::size_t which = 0; view.density && which < 2; ++which) {
    const FlankDensity& flank = view.density->flanks[which];
    DensityScene scene{fmt::format("scatter-pattern{}", which + 1),
                       which,
                       flank.side,
                       flank.diameter,
                       flank.height,
                       {},
                       view.density->marking,
                       view.density->samples};
    for (std::size_t i = 0; i < flank.count.size(); ++i)
      scene.share.push_back(flank.share(i, view.density->samples));
    figures.push_back(density_figure(scene));
  }
  return figures;
}

std::string scatter_section(const ScatterView& view, UnitSystem units) {
  std::string text = fmt::format(
      "<section class=\"scatter\">\n<h2>Scatter</h2>\n<p>The tables show the effect of the "
      "tolerances on {} random pairs.</p>\n",
      counted(static_cast<std::int64_t>(view.scatter->samples.size())));
  std::string figures;
  for (const Figure& figure : scatter_figures(view))
    figures += figure_html(in_units(units, figure));
  text += side_by_side(figures);
  for (const TextTable& table : scatter_tables(view, units)) text += table_html(table);
  return text + index_part(view, units) + "</section>\n";
}

}  // namespace gearwright
