// Displays values in a notebook with the pictures and tables of the report, and makes whole pages.
//
// Each picture is in its own frame, so that the styles of picture and notebook do not affect each
// other. The user's preference for dark or light determines the colours.
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "apps/python/model.hpp"
#include "apps/python/watched.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/cad/figure_files.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/figure/figure_data.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/job/contact_report.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/report/crossed_figures.hpp"
#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/pair_figures.hpp"
#include "gearwright/report/report.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/report_tables.hpp"

namespace gearwright::python {

namespace {

const std::array<std::string, 2> kShapes{"gear1", "gear2"};

// Returns a frame with a picture. If the notebook permits scripts, the frame is as high as its
// content. Otherwise it scrolls.
std::string framed(const std::string& title, const std::string& body) {
  const std::string page = page_head(title, "body{padding:.5em 0}") + "<body>\n<main>\n" + body +
                           "</main>\n</body>\n</html>\n";
  return fmt::format(
      "<iframe title=\"{}\" style=\"width:100%;height:30em;border:0\" onload=\"this.style.height="
      "this.contentDocument.documentElement.scrollHeight+'px'\" srcdoc=\"{}\"></iframe>",
      escaped(title), escaped(page));
}

std::string verdict_line(const Verdict& v, UnitSystem units) {
  return fmt::format("<p class=\"verdict {}\"><b>{}</b> {}</p>\n", to_string(v.level),
                     to_string(v.level), escaped(sentence_in(units, v.headline)));
}

std::string gear_html(const GearValue& g) {
  const Gear& gear = g.gear();
  const UnitSystem units = g.model->job.spec.units();
  return framed(fmt::format("Gear with {} teeth", gear.spec.teeth),
                shape_definitions({&gear}, nullptr, kShapes) + "<div class=\"columns\"><div>" +
                    gear_table({&gear}, {g.halves()}, units) + "</div><div>" +
                    tooth_part(gear, kShapes[0], "Gear", units) + "</div></div>\n");
}

std::string pair_html(const PairValue& p) {
  const UnitSystem units = p.model->job.spec.units();
  if (p.rack()) {
    const Gear& pinion = p.rack()->pinion;
    return framed(fmt::format("Rack and pinion with {} teeth", pinion.spec.teeth),
                  shape_definitions({&pinion}, &*p.rack(), kShapes) +
                      verdict_line(p.verdict(), units) + rack_section(*p.rack(), kShapes, units));
  }
  const Pair& pair = p.pair();
  const ParallelPair* parallel = pair.parallel();
  const bool picture = parallel && has_outline(pair.gear(1)) && has_outline(pair.gear(2));
  return framed(fmt::format("Gear pair {} / {}", pair.gear(1).spec.teeth, pair.gear(2).spec.teeth),
                shape_definitions({&pair.gear(1), &pair.gear(2)}, nullptr, kShapes) +
                    verdict_line(judge(p.model->job), units) +
                    (picture ? mesh_part(*parallel, kShapes, units) : std::string()) +
                    pair_table(pair, units));
}

std::vector<Figure> in_units_of(const Model& model, std::vector<Figure> figures) {
  for (Figure& f : figures) f = in_units(model.job.spec.units(), std::move(f));
  return figures;
}

std::vector<Figure> gear_figures(const GearValue& g) {
  const Gear& gear = g.gear();
  if (!has_outline(gear)) return {};
  Figure tooth = tooth_figure(gear, kShapes[0], "Gear");
  tooth.definitions = gear_definition(gear, kShapes[0]);
  return in_units_of(*g.model, {std::move(tooth)});
}

struct PairFigures {
  std::vector<Figure> operator()(const ParallelPair& pair) const {
    std::vector<Figure> figures;
    for (Figure& f : mesh_figures(pair, kShapes)) {
      for (std::size_t i = 0; i < kShapes.size(); ++i)
        f.definitions += gear_definition(pair.gears[i], kShapes[i]);
      figures.push_back(std::move(f));
    }
    if (!pair.flanks_meet()) return figures;
    figures.push_back(path_figure(pair));
    figures.push_back(ratio_figure(pair));
    return figures;
  }
  std::vector<Figure> operator()(const CrossedPair& pair) const {
    const auto [plan, whole] = plan_figures(pair);
    std::vector<Figure> figures{plan, whole, section_figure(pair), face_width_figure(pair)};
    if (!pair.flanks_meet()) return figures;
    figures.push_back(face_use_figure(pair));
    figures.push_back(speed_figure(pair));
    return figures;
  }
  std::vector<Figure> operator()(const ArcPair& pair) const { return arc_contact_figures(pair); }
};

std::vector<Figure> pair_figures(const PairValue& p) {
  if (!p.rack()) return in_units_of(*p.model, p.pair().visit(PairFigures()));
  auto made = rack_figure(*p.rack(), kShapes);
  if (!made) raise(made.error(), *p.model);
  Figure mesh = std::move(made).take();
  mesh.definitions = gear_definition(p.rack()->pinion, kShapes[0]) + mesh.definitions;
  return in_units_of(*p.model, {std::move(mesh)});
}

// Makes a part of the report. Ctrl-C interrupts this computation.
template <class Part>
Part part_of(SolvedJob& job, Result<Part> (*make)(SolvedJob&, Progress*)) {
  return watched_result(job.spec.given, [&](Progress* progress) { return make(job, progress); });
}

// Returns the figures of a contact. There are none if no teeth touch.
std::vector<Figure> contact_figures(const ContactValue& c) {
  SolvedJob job = c.model->job;
  job.spec.contact.given = true;  // as if the spec had the table [contact]
  const auto part = part_of(job, contact_part);
  if (!part) return {};
  const ContactReport& r = part->report;
  std::vector<Figure> figures;
  for (const ContactResult* result : {&r.driving, &r.other})
    if (auto figure = transmission_error_figure(r, *result)) figures.push_back(*std::move(figure));
  const auto add_flanks = [&](const ContactReport& of) {
    for (const std::size_t i : {0u, 1u})
      if (of.gears[i]) figures.push_back(flank_figure(of, i, {.pattern = &of.patterns[i]}));
  };
  if (r.halves.empty()) add_flanks(r);
  for (const ContactReport& half : r.halves) add_flanks(half);
  return in_units_of(*c.model, std::move(figures));
}

std::string contact_html(const ContactValue& c) {
  std::string html;
  for (const Figure& figure : contact_figures(c)) html += figure_html(figure);
  return html.empty() ? "<p>No teeth touch.</p>" : framed("Tooth contact", side_by_side(html));
}

std::string page_of(const Model& source, const std::vector<int>& gears, bool contact) {
  SolvedJob job = source.job;
  std::optional<ContactPart> part;
  if (contact || wants_contact(job)) {
    job.spec.contact.given = true;
    if (job.mounted()) part = part_of(job, contact_part);
  }
  std::optional<LoadPart> load;
  if (gears.size() == 2 && job.pair) load = part_of(job, load_part);
  ReportInput input;
  input.title = job.spec.title;
  for (std::size_t i = 0; i < std::min(gears.size(), job.gears.size()); ++i) {
    input.gears.push_back(&job.gear(gears[i]));
    input.halves[i] = job.halves[static_cast<std::size_t>(gears[i] - 1)];
  }
  if (gears.size() == 2) input.pair = job.pair;
  if (gears.size() == 2 && job.rack) input.rack = &*job.rack;
  if (part) input.contact = &part->report;
  if (load && load->report) input.load = &*load->report;
  input.verdict = judge(job, {.contact = part ? &part->answer.judged() : nullptr});
  input.spec_text = source.job.spec.text;
  input.units = source.job.spec.units();
  return report_html(input);
}

}  // namespace

void bind_pictures(py::module_& m, py::class_<GearValue>& gear, py::class_<PairValue>& pair,
                   py::class_<ContactValue>& contact) {
  py::class_<Figure> type(m, "Figure", "A figure made by the engine, with the data of its curves");
  need_value(type);
  type.def_readonly("title", &Figure::title)
      .def_readonly("description", &Figure::description, "A description of the figure in words")
      .def_property_readonly(
          "data", [](const Figure& f) { return to_python(figure_data(f)); },
          "The axes of the figure, and the points of its curves, bars, circles and dots, each with "
          "its name")
      .def_property_readonly(
          "svg", [](const Figure& f) { return figure_svg(f); },
          "The picture as SVG without its style sheet, as in the report")
      .def(
          "save",
          [](const Figure& f, const std::filesystem::path& path) {
            write_file(path, value_or_raise(figure_file(f, path.extension().string())));
            return path;
          },
          py::arg("path"),
          "Writes the figure as a file and returns its path. The ending of the path selects the "
          "format: .svg, .pdf, or .dxf for figures of a plane, in mm")
      .def("_repr_html_", [](const Figure& f) { return framed(f.title, figure_html(f)); })
      .def("__repr__", [](const Figure& f) { return fmt::format("Figure({})", f.title); });
  gear.def("_repr_html_", &gear_html)
      .def_property_readonly("figures", &gear_figures,
                             "The figure of the report, which shows one tooth with its arcs and "
                             "circles; none if the gear has no outline")
      .def(
          "report", [](const GearValue& g) { return page_of(*g.model, g.gears(), false); },
          "The program's report as one HTML page");
  pair.def("_repr_html_", &pair_html)
      .def_property_readonly(
          "figures", &pair_figures,
          "The figures of the report. They show the mesh, both gears, the path of contact and the "
          "contact ratios. On crossed axes, they show plan, section, faces and sliding. For "
          "circular-arc teeth, they show the racks and the teeth")
      .def(
          "report", [](const PairValue& p) { return page_of(*p.model, p.gears(), false); },
          "The program's report as one HTML page");
  contact.def("_repr_html_", &contact_html)
      .def_property_readonly("figures", &contact_figures,
                             "The figures of the report, which show the transmission error of both "
                             "flanks and the flanks of both gears; empty if no teeth touch")
      .def(
          "report",
          [](const ContactValue& c) {
            return page_of(*c.model, {1, 2}, true);
          },
          "The program's report with this contact, as one HTML page");
}

}  // namespace gearwright::python
