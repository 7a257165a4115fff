#include "gearwright/report/report_sections.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/correction_tables.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/rack_mesh.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/pair_figures.hpp"
#include "gearwright/report/report_tables.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

std::string arcsec(const ContactScore& s) {
  return s.nothing_touches() ? "no contact" : fixed(s.span_or_sampled().arcsec(), 4);
}

// Returns a sentence about the result under load, for the torque that has the worst result before
// the corrections.
std::string finding_under_load(const CompensateView& v) {
  const bool pressure = v.aim == CompensateAim::pressure;
  const auto aimed = [&](const LoadedScore& s) {
    return pressure ? s.max_pressure : s.peak_to_peak.arcsec();
  };
  const auto worst = std::max_element(
      v.loads.begin(), v.loads.end(),
      [&](const auto& a, const auto& b) { return aimed(a.before) < aimed(b.before); });
  const auto text = [&](const LoadedScore& s) {
    return pressure ? fixed(s.max_pressure, 0) : fixed(s.peak_to_peak.arcsec(), 3);
  };
  const char* unit = pressure ? " N/mm²" : "″";
  return fmt::format(
      "With these corrections, the {1} under {0:.6g} N m is {2}{3} instead of {4}{5}.",
      newton_metres(worst->torque),
      pressure ? "greatest pressure on the flanks" : "peak-to-peak transmission error",
      text(worst->after), unit, text(worst->before), unit);
}

std::string finding(const CompensateView& v) {
  if (v.nothing_to_correct)
    return fmt::format(
        "There is nothing to correct, because none of these corrections improves the pair by at "
        "least {}.",
        least_gain(v.aim));
  if (!v.loads.empty()) return finding_under_load(v);
  // Position of the contact pattern along the face. If the position along the face is 0 in both
  // states, the position along the profile is used.
  const bool face = v.before.along_face != 0.0 || v.after.along_face != 0.0;
  const auto place = [&](const ContactScore& s) {
    return percent(face ? s.along_face : s.along_profile);
  };
  return fmt::format(
      "With these corrections, and for the worst combination of errors, the peak-to-peak "
      "transmission error is {}″ instead of {}″. The contact is {} % off the middle of the {} "
      "instead of {} %. An edge touches at {} % of the positions instead of {} %.",
      arcsec(v.after), arcsec(v.before), place(v.after), face ? "face" : "profile", place(v.before),
      percent(v.after.edge_share), percent(v.before.edge_share));
}

const char* aim_words(CompensateAim aim) {
  switch (aim) {
    case CompensateAim::loaded_transmission_error:
      return "The objective is the transmission error of the loaded teeth at the worst torque.";
    case CompensateAim::pressure:
      return "The objective is the greatest pressure on the flanks at the worst torque.";
    case CompensateAim::transmission_error: break;
  }
  return "The objective is the transmission error and, for equal transmission errors, the contact "
         "nearest to the middle of the flank.";
}

std::string scores(const CompensateView& v, UnitSystem units) {
  const auto& quantities = score_quantities();
  const auto& loaded = loaded_score_quantities();
  TableBuilder t("Results for the worst combination of errors", {"Before", "After"});
  for (const AimedLoad& l : v.loads) {
    t.group(fmt::format("Under {:.6g} N m", newton_metres(l.torque)));
    for (const TextGroup& g :
         text_groups(loaded.table(), {loaded.of(l.before), loaded.of(l.after)}, kPage, units))
      t.rows(g);
  }
  const auto unloaded = text_groups(
      quantities.table(), {quantities.of(v.before), quantities.of(v.after)}, kPage, units);
  if (v.loads.empty()) {
    t.groups(unloaded);
  } else {
    t.group("Without load");
    for (const TextGroup& g : unloaded) t.rows(g);
  }
  return t.str() +
         (v.scenarios.size() > 1 ? table_html(scenario_table(v.scenarios, units)) : std::string());
}

std::string finding(const Rating& r) {
  const auto least = [](const FactorPair& f) {
    return fmt::format("{} (gear {})", fixed(std::min(f[0].value, f[1].value), 2),
                       f[0].value <= f[1].value ? 1 : 2);
  };
  return fmt::format(
      "The least safety against root breakage is {}, and the least safety against pitting is {}. "
      "Allowable stress numbers from the table of materials are reference values of the standard. "
      "Compare them with the certificate of the material.",
      least(r.S_F), least(r.S_H));
}

std::string table(const RatingAnswer& view, UnitSystem units) {
  TableBuilder t("Strength, as rated", {"Gear 1", "Gear 2", "Clause of the standard, branch"});
  const auto both = [](const FactorPair& f) {
    return fixed(f[0].value, 2) + " / " + fixed(f[1].value, 2);
  };
  t.decisive(fmt::format("S_F {}; S_H {}", both(view.rating.S_F), both(view.rating.S_H)));
  const auto& quantities = rating_quantities();
  for (const TextGroup& group :
       text_groups(quantities.table(), {quantities.of(view)}, kPage, units)) {
    t.group(group.title.empty() ? "Standard" : group.title);
    for (const TextRow& row : group.rows) {
      const std::string place = source_text(view.rating, row.info->key);
      if (row.texts.size() > 1)
        t.row(row, {row.texts.front(), row.texts.back(), place});
      else
        t.common(row, row.texts.front(), place);
    }
  }
  return t.str();
}

}  // namespace

std::string measure_section(const std::vector<ValueRecord>& measures,
                            const std::vector<std::vector<ValueRecord>>& ends,
                            const std::vector<KDiagram>& diagrams, UnitSystem units) {
  const auto groups = text_groups(measure_quantities().table(), measures, kPage, units);
  if (groups.empty()) return {};
  const std::vector<std::string> columns = gear_headings(measures.size());
  TableBuilder table("Inspection dimensions, including the thickness allowances", columns);
  table.decisive_rows({"length_mm", "dimension_mm"});
  table.groups(groups);
  std::string text = table.str();
  for (std::size_t i = 0; i < std::min(ends.size(), columns.size()); ++i) {
    const auto differing = text_groups(measure_quantities().table(), ends[i], kPage, units);
    if (differing.empty()) continue;
    TableBuilder interval(columns[i] + " at the limits of the thickness allowance",
                          {"Lower", "Upper"});
    interval.decisive_rows({"length_mm", "dimension_mm"});
    interval.groups(differing);
    text += interval.str();
  }
  return "<section>\n<h2>Inspection</h2>\n" + text + k_figures(diagrams, units) + "</section>\n";
}

std::string compensate_section(const CompensateView& view, UnitSystem units) {
  GW_EXPECTS(!view.before.nothing_touches() && !view.corrections.empty());
  const std::string what = fmt::format(
      "\n<p>The following changes of the gears compensate the errors of this pair. {} "
      "<code>gearwright compensate --take</code> prints the specification with the "
      "corrections.</p>\n<p><strong>{}</strong></p>\n{}",
      aim_words(view.aim), finding(view),
      table_html(correction_table("Corrections", view.corrections, units)));
  return "<section class=\"compensate\">\n<h2>Corrections</h2>\n" +
         in_columns(what, "\n" + scores(view, units)) +
         (view.setting || view.lead ? table_html("Results in closed form", {"Value"}, units,
                                                 compensate_quantities(), view)
                                    : "") +
         "</section>\n";
}

std::string rating_section(const RatingAnswer& view, UnitSystem units) {
  const bool plastic = view.rating.edition == RatingEdition::vdi_2736;
  const std::string method =
      fmt::format("{}{}", name(view.rating.edition), plastic ? "" : ", method B");
  return fmt::format(
      "<section class=\"rating\">\n<h2>Strength</h2>\n<p>The strength is rated by {}. Scuffing and "
      "micropitting are not rated{}.</p>\n<p><strong>{}</strong></p>\n{}</section>\n",
      method, plastic ? ". Wear and deformation are not rated either" : "", finding(view.rating),
      table(view, units));
}

std::string halves_part(std::string_view shared, std::string_view alike,
                        const std::vector<std::string>& pictures) {
  constexpr std::array kNames{"Half at z &gt; 0", "Half at z &lt; 0"};
  std::string text = fmt::format(
      "<p>The results above are for the whole gears. One gear can move along its axis, so "
      "{}.{}</p>\n",
      shared, pictures.size() == 1 ? fmt::format(" {}", alike) : "");
  for (std::size_t i = 0; i < pictures.size(); ++i)
    text += fmt::format("<h3 class=\"half\">{}</h3>\n", kNames[i]) + pictures[i];
  return text;
}

constexpr double kRackAspect = 640.0 / 560.0;

Result<Figure> rack_figure(const RackPair& pair, const std::array<std::string, 2>& shapes) {
  auto definition = rack_definition(pair, shapes[1]);
  if (!definition) return definition.error();
  const RackScene scene{&pair, shapes};
  Figure figure = rack_mesh_figure(scene, rack_window(scene, MeshFrame::mesh, kRackAspect));
  figure.definitions = std::move(definition).take();
  figure.caption = fmt::format(
      " C, with the pinion driving clockwise and the rack moving down. {} {} Tip circle and tip "
      "line are full, pitch circle and datum line dash-dotted, and the base circle is dashed. T is "
      "the base tangent point.",
      caption_key("action", "path of contact A–E"),
      caption_key("trailing", "line of action of the trailing flanks"));
  return figure;
}

std::string shape_definitions(const std::vector<const Gear*>& gears, const RackPair* rack,
                              const std::array<std::string, 2>& shapes) {
  std::string text;
  for (std::size_t i = 0; i < gears.size(); ++i) text += gear_definition(*gears[i], shapes[i]);
  if (rack)
    if (auto bar = rack_definition(*rack, shapes[1])) text += std::move(bar).take();
  if (text.empty()) return {};
  return "<svg class=\"definitions\" aria-hidden=\"true\" focusable=\"false\"><defs>\n" + text +
         "</defs></svg>\n";
}

std::string rack_section(const RackPair& pair, const std::array<std::string, 2>& shapes,
                         const FigureForm& form, std::string_view head) {
  auto figure = rack_figure(pair, shapes);
  std::string picture;
  if (figure) {
    Figure drawn = std::move(figure).take();
    drawn.definitions.clear();  // the page contains them
    picture = form.html(std::move(drawn), kWideFigure);
  } else {
    picture = fmt::format("<p><strong>The rack has no outline</strong>: {}</p>\n",
                          escaped(figure.error().message()));
  }
  return fmt::format("<section class=\"pair\">\n{}{}{}{}</section>\n", head, picture,
                     table_html("Rack and pinion, symbols of ISO 21771", {"Pinion", "Rack"},
                                form.units, rack_pair_quantities(), pair),
                     table_html("Rack data, symbols of ISO 21771", {"Rack"}, form.units,
                                rack_quantities(), pair.rack));
}

}  // namespace gearwright
