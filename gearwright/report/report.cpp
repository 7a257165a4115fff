#include "gearwright/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/overloaded.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/catalogue/file_quantities.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/load_figures.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/pair_figures.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/report_tables.hpp"

namespace gearwright {

namespace {

const std::array<std::string, 2> kShapes{"gear1", "gear2"};

std::string default_title(const ReportInput& input) {
  const int z1 = input.gears[0]->spec.teeth;
  if (input.rack) return fmt::format("Rack and pinion with {} teeth", z1);
  if (input.gears.size() == 1) {
    return fmt::format("{} with {} teeth", z1 < 0 ? "Internal gear" : "Gear", std::abs(z1));
  }
  return fmt::format("{} {} / {}", input.pair ? "Gear pair" : "Gears", z1,
                     input.gears[1]->spec.teeth);
}

const char* teeth_of(const Gear& gear, bool halves) {
  return halves ? "Double-helical" : gear.spec.helix_angle.rad() != 0.0 ? "Helical" : "Spur";
}

std::string kind_of(const ArcPair&, bool halves) {
  return fmt::format("{} gear pair on parallel axes",
                     halves ? "Double-helical circular-arc" : "Circular-arc");
}

std::string kind_of(const CrossedPair& pair, bool) {
  return fmt::format("Crossed helical gear pair, shaft angle {:.8g}°", pair.shaft_angle.deg());
}

std::string kind_of(const ParallelPair& pair, bool halves) {
  return fmt::format("{} gear pair on parallel axes{}", teeth_of(pair.gears[0], halves),
                     pair.margins ? ", internal" : "");
}

std::string kind_of(const ReportInput& input) {
  const bool halves = input.halves[0].has_value();
  if (input.rack) return fmt::format("{} rack and pinion", teeth_of(*input.gears[0], false));
  if (input.pair)
    return input.pair->visit([&](const auto& pair) { return kind_of(pair, halves); }) +
           (halves ? "; contact ratios and axial force apply to one half" : "");
  if (input.gears.size() == 2) return "Two cylindrical gears, not mounted";
  return fmt::format("{} {}{}", teeth_of(*input.gears[0], halves),
                     input.gears[0]->involute() ? "" : "circular-arc ",
                     input.gears[0]->internal() ? "internal gear" : "gear");
}

std::string few_teeth_section(const ReportInput& input) {
  std::string roots;
  std::string shifts;
  int pictures = 0;
  for (std::size_t i = 0; i < input.gears.size(); ++i) {
    const std::string name = fmt::format("Gear {}", i + 1);
    roots += root_figure(*input.gears[i], kShapes[i], name, input.units);
    if (root_is_worth_a_picture(*input.gears[i])) ++pictures;
    shifts += shift_figures(*input.gears[i], kShapes[i], name);
  }
  const std::string table = few_teeth_table(input.gears, input.units);
  if (table.empty() && pictures == 0) return {};
  // If there is one picture, the table is beside it. Two pictures are side by side above the table.
  const std::string first = pictures == 0 ? table
                            : pictures == 1 && !table.empty()
                                ? in_columns(roots, table)
                                : fmt::format("<div class=\"figures\">{}</div>\n{}", roots, table);
  return fmt::format("<section>\n<h2>Roots and tips</h2>\n{}{}</section>\n", first, shifts);
}

std::string gear_section(const ReportInput& input) {
  std::string pictures;
  for (std::size_t i = 0; i < input.gears.size(); ++i) {
    pictures += tooth_part(*input.gears[i], kShapes[i], fmt::format("Gear {}", i + 1), input.units);
  }
  const std::string table = gear_table(input.gears, input.halves, input.units);
  if (input.gears.size() == 1) {
    return fmt::format("<section>\n<h2>{}</h2>\n", input.rack ? "Pinion" : "Gear") +
           in_columns(table, pictures) + "</section>\n";
  }
  return "<section>\n<h2>Gears</h2>\n" + side_by_side(pictures) + table + "</section>\n";
}

std::string title_block(const DrawingInput& drawing) {
  if (!drawing.given()) return {};
  std::string rows;
  for (const Member& m : drawing_quantities().of(drawing))
    if (!m.value.nothing())
      rows += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", capitalised(m.info->words),
                          escaped(text_of(*m.info, m.value)));
  return "<dl class=\"titleblock\">" + rows + "</dl>\n";
}

std::string foot(const ReportInput& input) {
  const bool crossed = input.pair && input.pair->crossed();
  const bool by_pinion = std::any_of(input.gears.begin(), input.gears.end(),
                                     [](const Gear* gear) { return gear->cut_by.has_value(); });
  return fmt::format(
      "The geometry is the nominal geometry of the teeth as cut by the "
      "given {}. Symbols and terms are those of ISO 21771. Lengths are in {} and angles in "
      "degrees; “{}” means that there is no such value.{}</p>\n<p>Numbers are computed in double "
      "precision, by closed formulas, or by iteration until only rounding errors remain. Lengths "
      "are shown with {} decimals of {}, and angles with {} decimals of a degree. Outlines of "
      "teeth follow the exact curves within {:g} normal modules. {}{}{}",
      by_pinion ? "racks and pinion cutters" : "racks", to_string(input.units), kNoValue,
      crossed ? " On crossed axes, teeth touch at points. The contact ratio is the mean number of "
                "these points on the line of action."
              : "",
      digits_in(input.units, Unit::mm, kLengthDigits),
      input.units == UnitSystem::mm ? "a millimetre" : "an inch", kAngleDigits, kOutlineTolerance,
      input.scatter ? "Manufacturing deviations are considered only in the distributions, and "
                      "temperature is not considered."
                    : "Manufacturing deviations and temperature are not considered.",
      input.load ? " Load and deflection are considered only in the part under load."
                 : " Load and deflection are not considered.",
      input.rating ? " Strength is considered only in the rating."
                   : " Strength is not considered.");
}

// Returns the most important figures, at most three. The first shows the gears in mesh. The others
// show the load, the contact or the pair.
std::vector<Figure> deciding_figures(const ReportInput& input) {
  constexpr std::size_t kMost = 3;
  std::vector<Figure> figures, of_pair;
  const auto add = [&](std::optional<Figure> figure) {
    if (figure) figures.push_back(std::move(*figure));
  };
  if (input.pair)
    of_pair = input.pair->visit(
        Overloaded{[](const ArcPair& pair) {
                     std::vector<Figure> contacts;
                     for (std::size_t i = 0; i < pair.contacts.size(); ++i)
                       contacts.push_back(arc_mesh_figure(pair, i, kShapes));
                     return contacts;
                   },
                   [](const CrossedPair& pair) {
                     std::vector<Figure> views{plan_figures(pair)[0], section_figure(pair)};
                     if (pair.flanks_meet()) views.push_back(face_use_figure(pair));
                     return views;
                   },
                   [](const ParallelPair& pair) {
                     std::vector<Figure> views{mesh_figures(pair, kShapes)[0]};
                     if (pair.flanks_meet())
                       views.insert(views.end(), {path_figure(pair), ratio_figure(pair)});
                     return views;
                   }});
  if (input.rack) {
    if (auto made = rack_figure(*input.rack, kShapes)) {
      of_pair.push_back(std::move(made).take());
      of_pair.back().definitions.clear();  // the page contains them
    }
  }
  if (!of_pair.empty()) add(of_pair.front());
  // A figure of one half of a double-helical pair remains under the heading of this half.
  if (input.load) {
    const LoadScene& load = *input.load;
    add(loaded_te_figure(load));
    if (load.halves.empty())
      add(load.contact.regime == LoadRegime::point ? ellipse_figure(load, 0)
                                                   : pressure_figure(load, 0));
  } else if (input.contact) {
    const ContactReport& contact = *input.contact;
    add(transmission_error_figure(contact, contact.driving));
    if (contact.halves.empty()) add(flank_figure(contact, 0, {.pattern = &contact.patterns[0]}));
  }
  for (std::size_t i = 1; i < of_pair.size() && figures.size() < kMost; ++i) add(of_pair[i]);
  return figures;
}

std::string deciding_part(const ReportInput& input, const std::vector<Figure>& figures) {
  if (figures.empty()) return {};
  const ParallelPair* const turning = input.pair ? input.pair->parallel() : nullptr;
  const FigureForm form(input.units);
  std::string first = form.html(figures.front(), kWideFigure,
                                turning ? turn_control(*turning) : std::string()),
              others;
  if (figures.size() == 1) return side_by_side(first);
  for (std::size_t i = 1; i < figures.size(); ++i) others += form.html(figures[i], kNarrowFigure);
  return "<div class=\"figures mesh\">\n" + first + "<div>" + others + "</div>\n</div>\n";
}

}  // namespace

std::string finding_list(const Verdict& verdict, std::string_view whole) {
  std::string text;
  for (const Finding& f : verdict.findings) {
    const auto [name, word] = f.level == Level::red     ? std::pair{"problem", "Problem"}
                              : f.level == Level::amber ? std::pair{"caution", "Caution"}
                                                        : std::pair{"note", "Note"};
    const std::string where = f.gear == 0 ? std::string(whole) : fmt::format("Gear {}", f.gear);
    text += fmt::format("<li class=\"{}\"><b>{}</b><span class=\"where\">{}</span>{}</li>\n", name,
                        word, where, with_symbols(f.whole()));
  }
  return text.empty() ? text : "<ul class=\"warnings\">\n" + text + "</ul>\n";
}

std::string pair_section(const ParallelPair& pair, const std::array<std::string, 2>& shapes,
                         const FigureForm& form, std::string_view head) {
  const bool meet = pair.flanks_meet();
  const std::string table = path_table(pair, form.units);
  const std::string drawn = meet ? form.html(path_figure(pair), kWideFigure) : std::string();
  const std::string path = drawn.empty() ? table : side_by_side(drawn + "<div>" + table + "</div>");
  return fmt::format("<section class=\"pair\">\n{}{}{}{}{}{}</section>\n", head,
                     mesh_part(pair, shapes, form,
                               meet ? form.html(ratio_figure(pair), kNarrowFigure) : std::string()),
                     pair_table(pair, form.units), interference_table(pair, form.units), path,
                     centrode_figures(pair, form));
}

std::string pair_section(const CrossedPair& pair, const std::array<std::string, 2>&,
                         const FigureForm& form) {
  const UnitSystem units = form.units;
  const auto wide = [&](Figure figure) { return form.html(std::move(figure), kWideFigure); };
  std::string figures = wide(section_figure(pair)), tables;
  if (pair.flanks_meet()) {
    figures += wide(face_use_figure(pair)) + wide(speed_figure(pair));
    tables = speed_table(pair, units);
  }
  return "<section class=\"pair\">\n<h2>Pair</h2>\n" + plan_part(pair, form) +
         pair_table(pair, units) + interference_table(pair, units) +
         side_by_side(figures + "<div>" + tables + path_table(pair, units) + "</div>") +
         "<h3>Other positions of these gears</h3>\n" +
         in_columns(range_figure(pair, units), wide(face_width_figure(pair))) +
         min_distance_part(pair, units) + "</section>\n";
}

namespace {

// Returns links to the files that were written together with the page. The result may be empty.
std::string file_section(const std::vector<ReportFile>& files) {
  if (files.empty()) return {};
  std::string text =
      "<section>\n<h2>Files</h2>\n<div class=\"scroll\"><table>\n<thead><tr><th "
      "scope=\"col\">File</th><th scope=\"col\">Content</th><th "
      "scope=\"col\">Note</th></tr></thead>\n<tbody>\n";
  for (const ReportFile& file : files) {
    text += fmt::format(
        "<tr><th scope=\"row\"><a href=\"{}\">{}</a></th><td>{}</td><td>{}</td></tr>\n",
        file_link(file.name), escaped(file.name), escaped(file.what), escaped(file.note));
  }
  return text + "</tbody></table></div>\n</section>\n";
}

}  // namespace

std::string page_of(const PageInput& input, ReportPage page) {
  if (!input.title.empty()) page.title = input.title;
  page.verdict = escaped(sentence_in(input.units, input.verdict.headline));
  page.level = to_string(input.verdict.level);
  page.sections = sentence_in(input.units, page.sections + file_section(input.files));
  page.spec = input.spec_text;
  page.script = turn_script();
  return page_html(page);
}

std::string report_html(const ReportInput& input) {
  GW_EXPECTS(input.gears.size() == 1 || input.gears.size() == 2);
  for (const Gear* gear : input.gears) GW_EXPECTS(gear != nullptr);
  GW_EXPECTS(!input.rack || input.gears.size() == 1);
  GW_EXPECTS(!input.pair || input.gears.size() == 2);
  const UnitSystem units = input.units;
  // The most important sections come first, and the data sheets of the gears later. Under a given
  // load, the contact of rigid teeth is less important than the loaded one.
  const std::vector<Figure> deciding = deciding_figures(input);
  FigureForm form(units);
  for (const Figure& figure : deciding) form.above.push_back(figure.id);
  std::string sections;
  if (input.pair) {
    sections += input.pair->visit(
        Overloaded{[&](const ArcPair& pair) { return arc_pair_section(pair, kShapes, form); },
                   [&](const auto& pair) { return pair_section(pair, kShapes, form); }});
  }
  if (input.rack) sections += rack_section(*input.rack, kShapes, form);
  if (input.load) sections += load_section(*input.load, kShapes, form);
  if (input.contact)
    sections += contact_section(*input.contact, form,
                                input.load ? "Tooth contact without load" : "Tooth contact");
  if (input.propose) sections += propose_section(*input.propose, input.units);
  if (input.compensate) sections += compensate_section(*input.compensate, units);
  if (input.scatter) sections += scatter_section(*input.scatter, units);
  if (input.rating) sections += rating_section(*input.rating, units);
  sections += gear_section(input) + few_teeth_section(input) +
              measure_section(input.measures, input.measure_ends, input.k_diagrams, units);
  const std::string head =
      title_block(input.drawing) + key_figures(input) +
      sentence_in(units, deciding_part(input, deciding) +
                             finding_list(input.verdict, input.pair   ? "Pair"
                                                         : input.rack ? "Rack and pinion"
                                                                      : "")) +
      picture_hint();
  return page_of(input, {.title = default_title(input),
                         .kind = kind_of(input),
                         .head = head,
                         .definitions = shape_definitions(input.gears, input.rack, kShapes),
                         .sections = sections,
                         .foot = foot(input)});
}

}  // namespace gearwright
