#include "gearwright/report/drive_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/figure/drive_figures.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/report_tables.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

constexpr std::array<std::string_view, 6> kKeyFigures{
    "ratio", "efficiency", "efficiency_backward", "center_distance_mm", "output_deg", "output_mm"};
constexpr double kSchemeWidth = 640.0;

std::string drive_title(const Drive& drive) {
  std::string teeth;
  for (const DriveGear& gear : drive.graph.gears)
    teeth += (teeth.empty() ? "" : " / ") +
             (gear.rack ? std::string("rack") : fmt::format("{}", std::abs(gear.teeth)));
  return fmt::format("{} {}", drive.sets.empty() ? "Gear train" : "Planetary drive", teeth);
}

std::string drive_kind(const Drive& drive) {
  const DriveGraph& graph = drive.graph;
  const auto name = [&](std::size_t b) { return graph.bodies[b].name; };
  std::string text = drive.sets.empty() ? "Gear train" : "Planetary drive";
  for (const std::size_t in : graph.inputs)
    text += fmt::format("{}{}", in == graph.inputs.front() ? ": in " : ", ", name(in));
  text += ", out " + name(graph.output);
  for (const std::size_t held : graph.fixed)
    text += fmt::format("{}{}", held == graph.fixed.front() ? ", held " : ", ", name(held));
  return text;
}

// A table with a column for each body, or for each mesh.
template <class View, class List>
std::string table_of(const std::string& caption, const Quantities<View>& quantities,
                     const Drive& drive, const List& list, UnitSystem units) {
  std::vector<std::string> names;
  std::vector<ValueRecord> records;
  for (std::size_t i = 0; i < list.size(); ++i) {
    names.push_back(list[i].name);
    records.push_back(quantities.of({&drive, i}));
  }
  TableBuilder table(caption, names);
  table.groups(text_groups(quantities.table(), records, kPage, units));
  return table.str();
}

std::string drive_overview(const DriveReportInput& input) {
  const Drive& drive = *input.drive;
  std::string text = "<section>\n<h2>The drive</h2>\n";
  if (input.places) text += figure_html(scheme_figure(drive, *input.places), kSchemeWidth);
  text += table_of("Bodies", drive_body_quantities(), drive, drive.graph.bodies, input.units);
  return text + "</section>\n";
}

std::string section_part(const DriveReportInput& input) {
  const std::string head = "<section>\n<h2>In section</h2>\n";
  if (!input.layout)
    return head +
           fmt::format("<p class=\"nopicture\">{}</p>\n</section>\n", escaped(input.why_no_layout));
  return head + drive_section_figures(*input.drive, *input.layout, input.units) + "</section>\n";
}

std::string power_part(const Drive& drive, UnitSystem units) {
  std::string text = "<section>\n<h2>Power</h2>\n";
  if (const auto figure = power_figure(drive)) text += figure_html(*figure, kSchemeWidth);
  text += table_of("Meshes", drive_mesh_quantities(), drive, drive.graph.meshes, units);
  return text + table_html("The whole drive", {"Value"}, units, drive_quantities(), drive) +
         "</section>\n";
}

std::string strength_part(const Drive& drive, UnitSystem units) {
  if (drive.ratings.empty()) return "";
  std::string text = "<section>\n<h2>Strength</h2>\n";
  for (std::size_t m = 0; m < drive.ratings.size(); ++m) {
    const auto rating = mesh_rating(drive, m);
    if (!rating) continue;
    TableBuilder table(drive.graph.meshes[m].name, {"Gear 1", "Gear 2"});
    table.decisive_rows({"S_F", "S_H"});
    table.groups(text_groups(rating_quantities().table(), {*rating}, kPage, units));
    text += table.str();
  }
  return text + "</section>\n";
}

std::string load_part(const Drive& drive, UnitSystem units) {
  if (!drive.loaded) return "";
  const LoadedDrive& loaded = *drive.loaded;
  std::string text = fmt::format(
      "<section>\n<h2>Under load</h2>\n<p>The torque on the input is {} N m. The teeth of every "
      "mesh are elastic, and each planet has its own position in the mesh. The planets turn "
      "freely on rigid pins.",
      format_number(loaded.torque));
  if (const auto computed = mesh_load_factor(drive)) {
    text += fmt::format(" The most loaded planet carries {} times an equal share.",
                        fixed_decimals(*computed, 3));
    if (const auto rated = rated_mesh_load_factor(drive))
      text += fmt::format(" The rating uses K_γ = {}.", fixed_decimals(*rated, 3));
  }
  text += "</p>\n";
  std::string figures;
  for (std::size_t s = 0; s < loaded.sets.size(); ++s) {
    if (loaded.sets[s].share.size() < 2) continue;
    figures += html_of(planet_share_figure(drive, s)) +
               html_of(in_units(units, displacement_figure(drive, s)));
  }
  for (std::size_t c = 0; c < loaded.curves.size(); ++c)
    figures += html_of(loaded_output_figure(drive, c));
  text += side_by_side(figures);
  text += table_html("Under load", {"Value"}, units, drive_load_quantities(), drive);
  for (const PlanetShares& shares : loaded.sets) {
    const std::size_t carrier = drive.sets[shares.set].group.carrier;
    text += table_html(fmt::format("Planets of {} under load", drive.graph.bodies[carrier].name),
                       {"Value"}, units, planet_share_quantities(), {&drive, &shares});
  }
  return text + "</section>\n";
}

std::string planets_part(const Drive& drive, UnitSystem units) {
  std::string text;
  for (const PlanetSet& set : drive.sets) {
    TableBuilder table(fmt::format("Planets of {}", drive.graph.bodies[set.group.carrier].name),
                       {"Value"});
    table.groups(units, assembly_quantities(), set);
    table.groups(units, phasing_quantities(), set);
    text += table.str();
  }
  return text.empty() ? text : "<section>\n<h2>Planets</h2>\n" + text + "</section>\n";
}

// The position after the names that begin at `at`. `mark` is the text before the names. After
// "url(#", they end at a parenthesis. After any other mark, they end at a quote.
std::size_t end_of_names(const std::string& html, std::string_view mark, std::size_t at) {
  return std::min(html.find(mark.front() == 'u' ? ')' : '"', at), html.size());
}

std::set<std::string> ids_in(const std::string& html) {
  constexpr std::string_view kId = " id=\"";
  std::set<std::string> ids;
  for (std::size_t at = html.find(kId); at != std::string::npos; at = html.find(kId, at)) {
    at += kId.size();
    ids.insert(html.substr(at, end_of_names(html, kId, at) - at));
  }
  return ids;
}

// Adds a prefix to the ids in the HTML of a mesh and to the references to these ids, because ids
// must be unique in a page. References to the shapes of the drive, which the page defines once, are
// kept.
std::string with_prefix(const std::string& html, const std::string& prefix) {
  constexpr std::array<std::string_view, 4> kMarks{" id=\"", " aria-labelledby=\"", "url(#",
                                                   " href=\"#"};
  const std::set<std::string> own = ids_in(html);
  std::string text;
  for (std::size_t at = 0; at < html.size();) {
    std::size_t next = html.size();
    std::string_view mark;
    for (const std::string_view m : kMarks) {
      const std::size_t found = html.find(m, at);
      if (found < next) {
        next = found;
        mark = m;
      }
    }
    text += html.substr(at, next - at);
    if (mark.empty()) break;
    text += mark;
    at = next + mark.size();
    const std::size_t end = end_of_names(html, mark, at);
    while (at < end) {
      const std::string name = html.substr(at, std::min(html.find(' ', at), end) - at);
      text += (own.contains(name) ? prefix : "") + name;
      at += name.size();
      if (at < end) text += html[at++];
    }
  }
  return text;
}

std::string mesh_parts(const Drive& drive, UnitSystem units) {
  std::string text;
  for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m) {
    const auto& pair = drive.geometry.pairs[m];
    const auto& rack = drive.geometry.racks[m];
    const ParallelPair* const parallel = pair ? pair->parallel() : nullptr;
    if (!parallel && !rack) continue;
    const DriveMesh& mesh = drive.graph.meshes[m];
    const std::string head = fmt::format(
        "<h2>Mesh {}</h2>\n<p>Gear 1 is {}, gear 2 is {}.</p>\n", escaped(mesh.name),
        escaped(drive.graph.gear(mesh, 0).name), escaped(drive.graph.gear(mesh, 1).name));
    const std::array<std::string, 2> shapes{shape_name(mesh.gears[0]), shape_name(mesh.gears[1])};
    text += with_prefix(rack ? rack_section(*rack, shapes, units, head)
                             : pair_section(*parallel, shapes, units, head),
                        fmt::format("mesh{}-", m + 1));
  }
  return text;
}

std::string gears_part(const Drive& drive, UnitSystem units) {
  std::string pictures;
  for (std::size_t g = 0; g < drive.geometry.gears.size(); ++g)
    if (const auto& gear = drive.geometry.gears[g])
      pictures += tooth_part(*gear, shape_name(g), drive.graph.gears[g].name, units);
  if (pictures.empty()) return {};
  return "<section>\n<h2>Gears</h2>\n" + side_by_side(pictures) + "</section>\n";
}

std::string drive_foot(const DriveReportInput& input) {
  return fmt::format(
      "<footer>\n<p>Gearwright{}. Speeds and ratios are exact fractions. The teeth are as cut by "
      "the given racks and pinion cutters. Lengths are in {} and angles in degrees; “{}” means "
      "that there is no such value. Speeds and torques are positive counter-clockwise, and powers "
      "are positive where power enters the drive. Only the power losses of the teeth are "
      "considered.</p>\n</footer>\n",
      input.version.empty() ? std::string() : " " + escaped(input.version), to_string(input.units),
      kNoValue);
}

}  // namespace

std::string drive_report_html(const DriveReportInput& input) {
  GW_EXPECTS(input.drive != nullptr);
  const Drive& drive = *input.drive;
  const std::string title = input.title.empty() ? drive_title(drive) : input.title;
  std::string page = page_head(title, input.version) + "<body>\n" + drive_definitions(drive);
  page += fmt::format(
      "<header>\n<p class=\"kind\">{}</p>\n<h1>{}</h1>\n<p class=\"verdict {}\"><b>{}</b> "
      "{}</p>\n<dl class=\"keyfigures\">\n{}</dl>\n{}{}</header>\n",
      escaped(drive_kind(drive)), escaped(title), to_string(input.verdict.level),
      to_string(input.verdict.level), escaped(sentence_in(input.units, input.verdict.headline)),
      key_boxes(drive_quantities().table(), {drive_quantities().of(drive)}, kKeyFigures,
                input.units),
      sentence_in(input.units, finding_list(input.verdict, "")), picture_hint());
  const std::string sections =
      sentence_in(input.units,
                  drive_overview(input) + section_part(input) + power_part(drive, input.units) +
                      strength_part(drive, input.units) + load_part(drive, input.units) +
                      planets_part(drive, input.units) + mesh_parts(drive, input.units) +
                      gears_part(drive, input.units) + file_section(input.files)) +
      spec_section(input.spec_text);
  page += "<main>\n" + with_contents(sections) + "</main>\n" + drive_foot(input);
  return page + page_end(turn_script());
}

}  // namespace gearwright
