#include "gearwright/report/drive_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/drive/drive_rating.hpp"
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

// Writes a table with a column for each body, or for each mesh.
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
  if (input.places)
    text += figure_html(scheme_figure(drive, *input.places, kWideFigure), kWideFigure);
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
  if (const auto figure = power_figure(drive)) text += figure_html(*figure, kWideFigure);
  text += table_of("Meshes", drive_mesh_quantities(), drive, drive.graph.meshes, units);
  return text + table_html("The whole drive", {"Value"}, units, drive_quantities(), drive) +
         "</section>\n";
}

std::string strength_part(const Drive& drive, UnitSystem units) {
  if (drive.ratings.empty()) return "";
  std::string text = "<section>\n<h2>Strength</h2>\n";
  if (rates_equal_shares(drive)) text += fmt::format("<p>{}</p>\n", kEqualShares);
  for (std::size_t m = 0; m < drive.ratings.size(); ++m) {
    const auto rating = mesh_rating(drive, m);
    if (!rating) continue;
    const DriveMesh& mesh = drive.graph.meshes[m];
    TableBuilder table(mesh.name, {drive.graph.gear(mesh, 0).name, drive.graph.gear(mesh, 1).name});
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
  for (const Figure& figure : drive_load_figures(drive)) figures += FigureForm(units).html(figure);
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

std::string mesh_parts(const Drive& drive, UnitSystem units) {
  std::string text;
  for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m) {
    const auto& pair = drive.geometry.pairs[m];
    const auto& rack = drive.geometry.racks[m];
    if (!pair && !rack) continue;
    const DriveMesh& mesh = drive.graph.meshes[m];
    const std::string head = fmt::format(
        "<h2>Mesh {}</h2>\n<p>Gear 1 is {}, gear 2 is {}.</p>\n", escaped(mesh.name),
        escaped(drive.graph.gear(mesh, 0).name), escaped(drive.graph.gear(mesh, 1).name));
    const FigureForm form{units, fmt::format("mesh{}-", m + 1)};
    const std::array<std::string, 2> shapes{shape_name(mesh.gears[0]), rack_shape_name(drive, m)};
    // The axes of a drive are parallel, so a pair without involute teeth has circular arcs.
    const ParallelPair* const involutes = drive.geometry.involutes(m);
    text += rack        ? rack_section(*rack, shapes, form, head)
            : involutes ? pair_section(*involutes, shapes, form, head)
                        : arc_pair_section(*pair->arcs(), shapes, form, head);
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

std::string drive_foot(UnitSystem units) {
  return fmt::format(
      "Speeds and ratios are exact fractions. The teeth are as cut by the given racks and pinion "
      "cutters. Lengths are in {} and angles in degrees; “{}” means that there is no such value. "
      "Speeds and torques are positive counter-clockwise, and powers are positive where power "
      "enters the drive. Only the power losses of the teeth are considered.",
      to_string(units), kNoValue);
}

}  // namespace

std::string drive_report_html(const DriveReportInput& input) {
  GW_EXPECTS(input.drive != nullptr);
  const Drive& drive = *input.drive;
  const std::string head = "<dl class=\"keyfigures\">\n" +
                           key_boxes(drive_quantities().table(), {drive_quantities().of(drive)},
                                     kKeyFigures, input.units) +
                           "</dl>\n" + sentence_in(input.units, finding_list(input.verdict, "")) +
                           picture_hint();
  return page_of(input,
                 {.title = drive_title(drive),
                  .kind = escaped(drive_kind(drive)),
                  .head = head,
                  .definitions = drive_definitions(drive),
                  .sections = drive_overview(input) + section_part(input) +
                              power_part(drive, input.units) + strength_part(drive, input.units) +
                              load_part(drive, input.units) + planets_part(drive, input.units) +
                              mesh_parts(drive, input.units) + gears_part(drive, input.units),
                  .foot = drive_foot(input.units)});
}

}  // namespace gearwright
