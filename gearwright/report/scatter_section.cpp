#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/figure/distribution_figures.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

std::string shown(const SpreadEntry& entry, double value) {
  return fixed(entry.shown(value), entry.digits);
}

template <class Spreads>
std::string distribution_table(const ScatterView& view, UnitSystem units, const std::string& title,
                               const Spreads& spreads) {
  std::vector<std::string> columns{"Mean", "Standard deviation"};
  for (const double p : view.task->percentiles) columns.push_back(format_number(p) + " %");
  TableBuilder table(title, columns);
  for (const auto& spread : spreads) {
    if (!spread) continue;
    const SpreadEntry& entry = *spread->entry;
    const auto text = [&](double value) {
      return text_in(units, entry.unit, entry.shown(value), entry.digits);
    };
    std::vector<std::string> values{text(spread->spread->mean.value),
                                    text(spread->spread->standard_deviation.value)};
    for (const Percentile& p : spread->spread->percentiles)
      values.push_back(text(p.estimate.value));
    table.row(entry.words, "", unit_text(units, entry.unit), values);
  }
  return table.str();
}

std::string event(const char* words, const Probability& p) {
  return fmt::format("{} in {} of {} pairs ({} %)", words, counted(p.count), counted(p.of),
                     p.count == 0 ? fmt::format("less than {:.2g}", 100 * p.interval.upper)
                                  : fmt::format("{:.3g}", 100 * p.value));
}

std::string loaded_part(const ScatterView& view, UnitSystem units) {
  std::string part;
  for (const LoadedSpreadView& v : view.loaded) {
    const LoadedSpread& l = *v.loaded;
    part += distribution_table(
        view, units, fmt::format("Under {} N m", format_number(newton_metres(l.torque))), v.spread);
    part += fmt::format("<p>{}.</p>\n", event("An edge of a tooth carries load", l.edge_carries));
  }
  return part;
}

// The range of every input, and the key of the spec that determines it. Waves and pitches have no
// range here, because they vary within a grade.
std::string input_table(const ScatterView& view, UnitSystem units) {
  TableBuilder table("Inputs", {"Least", "Greatest", "From"});
  for (const ScatterTolerance& t : view.task->tolerances) {
    const Unit unit = unit_of(t);
    const bool number = t.coordinates() == 1 || t.bore();
    const auto end = [&](double value) {
      return number ? format_number(value_in(units, unit, value)) : std::string();
    };
    table.row(
        key_in(units, t.name), "", number ? unit_text(units, unit) : "",
        {end(t.distribution.least()), end(t.distribution.greatest()), key_in(units, t.source)});
  }
  return table.str();
}

std::string correlation_table(const ScatterView& view, UnitSystem units) {
  if (view.task->correlations.empty()) return {};
  const std::vector<std::string> names = coordinate_names(view.task->tolerances);
  TableBuilder table("Correlations of the inputs", {"Correlation"});
  for (const ToleranceCorrelation& c : view.task->correlations)
    table.row(key_in(units, names[c.first]) + ", " + key_in(units, names[c.second]), "ρ", "",
              {format_number(c.value)});
  return table.str();
}

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

// The percentiles of the quantities under each torque, with and without the corrections.
std::string robust_load_part(const RobustView& r) {
  std::string part;
  for (std::size_t k = 0; k < r.before.loaded.size(); ++k) {
    TableBuilder table(fmt::format("{} % points under {} N m", format_number(r.percent),
                                   format_number(newton_metres(r.before.loaded[k].loaded->torque))),
                       {"Without the corrections", "With the corrections"});
    for (std::size_t i = 0; i < loaded_entries().size(); ++i) {
      const LoadedEntry& entry = loaded_entries()[i];
      const auto& before = r.before.loaded[k].spread[i];
      const auto& after = r.after.loaded[k].spread[i];
      if (!before || !after) continue;
      table.row(entry.words, "", unit_text(entry.unit),
                {shown(entry, before->spread->percentiles[0].estimate.value),
                 shown(entry, after->spread->percentiles[0].estimate.value)});
    }
    part += table.str();
  }
  return part;
}

std::string robust_part(const ScatterView& view, UnitSystem units) {
  if (!view.robust) return {};
  const RobustView& r = *view.robust;
  std::string list;
  for (const FoundCorrection& c : r.corrections)
    if (c.value != 0.0)
      list += fmt::format("{}{} {} {}", list.empty() ? "" : ", ", c.words,
                          format_number(value_in(units, unit_of(c.key), c.value)),
                          unit_text(units, unit_of(c.key)));
  if (list.empty()) list = "none";
  const auto percentile = [](const JudgedView& j) {
    return shown(scatter_entries()[0], j.family->percentile().estimate.value);
  };
  return fmt::format(
             "<p>Corrections that lower the {} % point of the {}: {}. For samples that the search "
             "did not use, this point is {}″ instead of {}″.</p>\n",
             format_number(r.percent),
             r.under_load ? "transmission error at the worst torque" : "transmission error",
             escaped(list), percentile(r.after), percentile(r.before)) +
         robust_load_part(r);
}

std::string loosening_part(const ScatterView& view, UnitSystem units) {
  if (!view.scatter->loosening) return {};
  const Loosening& l = *view.scatter->loosening;
  const SpreadEntry& te = scatter_entries()[0];
  TableBuilder table(
      fmt::format("Factor on one tolerance alone that increases the {} % point by {:g} %",
                  format_number(l.percent), 100 * kLooser),
      {"Factor", fmt::format("{} % point with half the tolerance", format_number(l.percent))});
  for (std::size_t i = 0; i < l.by_tolerance.size(); ++i) {
    const Loosening::Change& c = l.by_tolerance[i];
    table.row(key_in(units, view.inputs[i]), "", "″",
              {c.factor ? fixed(*c.factor, 2) : fmt::format("over {:g}", kMostFactor),
               shown(te, c.halved)});
  }
  if (!l.tighten_first) return table.str();
  const ScatterTolerance& first = view.task->tolerances[*l.tighten_first];
  return table.str() + fmt::format("<p>Tighten {}{} first.</p>\n",
                                   escaped(key_in(units, first.name)), first.of_grade());
}

}  // namespace

std::optional<DistributionScene> distribution_scene(const ScatterView& view,
                                                    ScatterQuantity quantity, const char* id) {
  const auto& spread = view.spread[static_cast<std::size_t>(quantity)];
  if (!spread || !(spread->spread->least < spread->spread->greatest)) return std::nullopt;
  const SpreadEntry& entry = *spread->entry;
  DistributionScene scene{id, entry.words, std::string(unit_text(entry.unit)), {}, {}};
  for (const ScatterSample& s : view.scatter->samples) {
    const double value = s.member[quantity];
    if (!s.member.lost && !std::isnan(value)) scene.values.push_back(entry.shown(value));
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
                       flank.internal,
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
  const Scatter& s = *view.scatter;
  std::string figures;
  for (const Figure& figure : scatter_figures(view))
    figures += figure_html(in_units(units, figure));
  return fmt::format(
             "<section class=\"scatter\">\n<h2>Scatter</h2>\n<p>The table shows the effect of the "
             "tolerances on {} random pairs. {}, {}, and {}.</p>\n",
             counted(static_cast<std::int64_t>(s.samples.size())),
             event("An edge of a tooth touches", s.edge_contact), event("the gears jam", s.jam),
             event("contact is lost", s.contact_lost)) +
         distribution_table(view, units, "Distribution over all pairs", view.spread) +
         side_by_side(figures) + input_table(view, units) + correlation_table(view, units) +
         loaded_part(view, units) + index_part(view, units) + loosening_part(view, units) +
         robust_part(view, units) + "</section>\n";
}

}  // namespace gearwright
