#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/correction_tables.hpp"
#include "gearwright/figure/contact_scene.hpp"
#include "gearwright/figure/designs.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/load_figures.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

bool scored(const LoadedScore& s) {
  return std::isfinite(s.peak_to_peak.rad()) && std::isfinite(s.max_pressure);
}

// Returns a figure of the greatest pressure versus the transmission error, with a numbered dot for
// each proposal. A proposal has no dot if one of the two values is not known, or if a proposal
// before it has the same spec.
std::string effects(const ProposeView& v) {
  std::vector<DesignDot> dots;
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < v.proposals.size(); ++i) {
    const LoadedScore& s = v.proposals[i].worst;
    if (!scored(s) || same_proposals(v.proposals, i).empty()) continue;
    dots.push_back({{s.peak_to_peak.arcsec(), s.max_pressure},
                    i == v.recommended ? "dot-front"
                    : s.edge_carries   ? "dot-middle"
                                       : "dot-design",
                    words_of(v.proposals[i])});
    numbers.push_back(std::to_string(i + 1));
  }
  if (dots.empty()) return {};
  Figure f = designs_figure({{"transmission error, peak to peak", "arc seconds"}},
                            {{"greatest pressure", "N/mm²"}}, dots);
  f.id = "proposals-plot";
  f.title = "Effects of the proposals";
  f.description = "Transmission error and greatest pressure of each proposal, by its number.";
  f.caption = fmt::format(
      ", as computed under load. Number 1 is the spec as given{}. At a hollow dot an edge carries "
      "load, so the pressure is a lower bound.",
      v.recommended > 0 ? fmt::format(", and {} is recommended", v.recommended + 1) : "");
  for (std::size_t i = 0; i < numbers.size(); ++i) f.marks[i].label = numbers[i];
  return figure_html(f);
}

std::string compared(const ProposeView& v) {
  std::vector<TeCurve> curves{{"before", "as given", v.proposals.front().transmission_error}};
  if (v.recommended > 0)
    curves.push_back({"curve g1", fmt::format("proposal {}", v.recommended + 1),
                      v.proposals[v.recommended].transmission_error});
  return html_of(compared_te_figure(curves));
}

std::string advice(const ProposeView& v, const std::string& taken) {
  if (!taken.empty())
    return fmt::format("<strong>The spec as given is also proposal {}.</strong>", escaped(taken));
  return fmt::format("<strong>* Recommended: {}, {}.</strong> {}", v.recommended + 1,
                     escaped(words_of(v.proposals[v.recommended])), escaped(v.reason));
}

}  // namespace

std::string propose_section(const ProposeView& view, UnitSystem units) {
  ProposeView v = view;
  // If the spec already has the modifications of a proposal, the user has decided, and no proposal
  // is marked as recommended.
  const std::string taken = words_of_same(v.proposals, same_proposals(v.proposals, 0));
  if (!taken.empty()) v.recommended = 0;
  std::string tables;
  for (const TextTable& table :
       proposal_tables(v, units, taken.empty() ? std::optional(v.recommended) : std::nullopt))
    tables += table_html(table);
  return fmt::format(
      "<section class=\"proposals\">\n<h2>Proposed modifications</h2>\n<p>The amounts follow from "
      "a torque of {} N m, the grades of the gears and the deflection of their shafts. The effect "
      "of each proposal is computed for the pair under load.</p>\n<p>{}</p>\n{}{}</section>\n",
      format_number(newton_metres(v.torque)), advice(v, taken),
      side_by_side(compared(v) + effects(v)), tables);
}

}  // namespace gearwright
