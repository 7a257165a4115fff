#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gearwright/base/contract.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/load_figures.hpp"
#include "gearwright/load/load_summary.hpp"
#include "gearwright/report/contact_report.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

std::string finding(const LoadScene& report) {
  const LoadedTorque& t = shown_torque(report);
  std::string text = fmt::format(
      "At {} the transmission error is {}″ peak to peak, the greatest pressure on the flanks is {} "
      "N/mm²{}, and the greatest root stresses are {} and {} N/mm²{}.",
      torque_words(t), shown_arcsec(t.peak_to_peak.arcsec()), fixed(t.max_pressure, 0),
      t.edge_carries   ? " (a lower bound, because an edge carries load)"
      : t.beyond_flank ? " (a lower bound, because an ellipse extends beyond the flank)"
                       : "",
      fixed(t.max_root_stress[0], 0), fixed(t.max_root_stress[1], 0),
      t.edge_carries ? ", which depend on the number of slices because an edge carries load" : "");
  if (const LoadedTorque* quiet = quietest(report.contact); quiet && quiet != &t)
    text += fmt::format(" The pair is quietest at {}, with {}″.", torque_words(*quiet),
                        shown_arcsec(quiet->peak_to_peak.arcsec()));
  const LoadedTorque& loudest =
      *std::max_element(report.contact.torques.begin(), report.contact.torques.end(),
                        [](const LoadedTorque& a, const LoadedTorque& b) {
                          return a.peak_to_peak.arcsec() < b.peak_to_peak.arcsec();
                        });
  if (loudest.peak_to_peak.arcsec() > t.peak_to_peak.arcsec())
    text += fmt::format(" The transmission error is greatest at {}, with {}″.",
                        torque_words(loudest), shown_arcsec(loudest.peak_to_peak.arcsec()));
  return text;
}

std::string facts(const LoadScene& report, UnitSystem units) {
  std::vector<ValueRecord> records;
  std::vector<std::string> columns;
  const auto& quantities = load_torque_quantities();
  const auto views = torque_views(report.contact, report.standard);
  for (const std::size_t i : shown_torques(report)) {
    records.push_back(quantities.of(views[i]));
    columns.push_back(torque_words(*views[i].torque));
  }
  TableBuilder table("Under load", columns);
  for (const TextGroup& group : text_groups(quantities.table(), records, kPage, units)) {
    for (const TextRow& row : group.rows) {
      if (row.info->key == "torque_Nm") continue;  // the column headings contain this value
      // The number of texts for one torque. It is 2 if each gear has its own value, otherwise 1.
      const std::size_t each = row.texts.size() / columns.size();
      std::vector<std::string> texts;
      for (std::size_t i = 0; i < columns.size(); ++i)
        texts.push_back(each == 2 ? row.texts[2 * i] + ", " + row.texts[2 * i + 1] : row.texts[i]);
      table.row(row, texts);
    }
  }
  return table.str() + "<p>If a row has two values in a column, the first is for gear 1.</p>\n";
}

std::string te_part(const LoadScene& report, const FigureForm& form) {
  const std::string harris = html_of(harris_figure(report));
  return "<h3>Transmission error under load</h3>\n<p>Gear 2 lags by the deflection of the teeth. "
         "The deflection is less where two tooth pairs share the load than where one pair carries "
         "it alone, so gear 2 oscillates at the tooth frequency even if the flanks are perfect. A "
         "tip relief compensates this oscillation at one torque. At lower torques the relief "
         "itself causes noise, and at higher torques the deflection causes noise.</p>\n" +
         form.row({loaded_te_figure(report)}, harris) +
         (harris.empty() ? "<p>If several torques are given, a Harris map shows the torque at "
                           "which the pair is quietest.</p>\n"
                         : "");
}

bool at_points(const LoadScene& report) { return report.contact.regime == LoadRegime::point; }

std::string share_part(const LoadScene& report) {
  return "<h3>Load shares and stiffness</h3>\n<p>The curves show how the tooth pairs share the "
         "load. If a share rises from zero and falls to zero without a jump, the teeth enter "
         "contact without an impact. The stiffness of the mesh is the " +
         std::string(at_points(report) ? "force" : "line load") +
         " divided by the approach of the gears; its variation during rotation causes "
         "vibration.</p>\n" +
         side_by_side(html_of(pair_share_figure(report)) + html_of(share_figure(report)) +
                      html_of(stiffness_figure(report)));
}

std::string ellipse_part(const LoadScene& report, const FigureForm& form) {
  return "<h3>Pressure on the flanks</h3>\n<p>These teeth touch at points. Under load, a point "
         "grows into a contact ellipse, whose long axis points in the direction in which the "
         "flanks fit most closely. The bending of the teeth makes the ellipse still longer. The "
         "pressure is highest in the middle of the ellipse. If an ellipse extends beyond an end of "
         "the flank, or if an edge touches, the pressure is higher than drawn.</p>\n" +
         side_by_side(form.html(ellipse_figure(report, 0)) + form.html(ellipse_figure(report, 1)) +
                      html_of(point_pressure_figure(report)));
}

std::string pressure_part(const LoadScene& report, const FigureForm& form) {
  // The control is below the first figure of this section. If the figure of gear 1 is already at
  // the head of the page, the control is below the figure of gear 2.
  const std::string control = turn_control(*report.pair);
  const std::string first = form.html(pressure_figure(report, 0), kFigureWidth, control);
  return fmt::format(
             "<h3>Pressure on the flanks</h3>\n<p>The picture shows the Hertz pressure of the "
             "teeth that carry load. It should be greatest in the middle of the face and decrease "
             "towards tips and ends. A bright border means that an edge carries load, or "
             "that one end of the face carries most of the load{}.</p>\n",
             shown_torque(report).edge_carries
                 ? ". An edge carries load here, and the true pressure is higher than drawn"
                 : "") +
         side_by_side(first +
                      form.html(pressure_figure(report, 1), kFigureWidth,
                                first.empty() ? control : std::string()) +
                      form.html(pressure_along_figure(report)));
}

std::string root_part(const LoadScene& report, const std::array<std::string, 2>& shapes,
                      UnitSystem units) {
  const std::string figures = root_stress_figures(report, shapes, units);
  if (figures.empty()) return {};
  return "<h3>Stress at the roots</h3>\n<p>Each tooth bends at its root. The fillet on the loaded "
         "side is in tension, and a crack would begin there. The stress is computed for the exact "
         "fillet. The neighbouring teeth and the body, which is held at its bore or rim, are "
         "included.</p>\n" +
         figures;
}

std::string pictures_of(const LoadScene& report, const std::array<std::string, 2>& shapes,
                        const FigureForm& form) {
  return share_part(report) +
         (at_points(report) ? ellipse_part(report, form) : pressure_part(report, form)) +
         root_part(report, shapes, form.units);
}

// Writes the pictures of each half of a double-helical pair, under half of the torque.
std::string halves_of(const LoadScene& report, const std::array<std::string, 2>& shapes,
                      const FigureForm& form) {
  std::vector<std::string> pictures;
  for (const LoadScene& half : report.halves) pictures.push_back(pictures_of(half, shapes, form));
  return halves_part(
      "each half carries half of the torque",
      "The halves are mirror images of each other, and the pictures show one of them.", pictures);
}

}  // namespace

std::string load_section(const LoadScene& report, const std::array<std::string, 2>& shapes,
                         const FigureForm& form) {
  const auto& torques = report.contact.torques;
  GW_EXPECTS((report.pair || at_points(report)) && !torques.empty());
  return fmt::format(
      "<section class=\"loaded\">\n<h2>Under load</h2>\n<p>Here the teeth are elastic. Every tooth "
      "bends, its root deforms the body, and the flanks flatten where they touch. At each of {} "
      "positions of a pitch the load is shared so that no flanks overlap and no force is "
      "tensile.</p>\n<p><strong>{}</strong></p>\n{}{}{}</section>\n",
      torques.front().positions.size(), finding(report), facts(report, form.units),
      te_part(report, form),
      report.halves.empty() ? pictures_of(report, shapes, form) : halves_of(report, shapes, form));
}

}  // namespace gearwright
