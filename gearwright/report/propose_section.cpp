#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/contact_scene.hpp"
#include "gearwright/figure/designs.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/load_figures.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/report_sections.hpp"

namespace gearwright {

namespace {

bool scored(const LoadedScore& s) {
  return std::isfinite(s.peak_to_peak.rad()) && std::isfinite(s.max_pressure);
}

// A figure with a numbered dot for each proposal, at its transmission error and its pressure.
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
  Figure f = designs_figure({"transmission error, peak to peak", "arc seconds"},
                            {"greatest pressure", "N/mm²"}, dots);
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

std::vector<std::string> cells(const LoadedScore& s) {
  if (!scored(s)) return {"–", "–", "–", "–"};
  return {shown_arcsec(s.peak_to_peak.arcsec()), fixed(s.max_pressure, 0),
          s.face_load_factor ? fixed(*s.face_load_factor, 2) : "", s.edge_carries ? "yes" : "no"};
}

std::string table(const ProposeView& v) {
  const bool limits = v.proposals.front().at_limits.has_value();
  std::vector<std::string> heads{"", "TE, ″", "Pressure, N/mm²", "K_Hβ", "Edge carries load"};
  if (limits) heads.push_back("Pressure at the limits of the helix slopes");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < v.proposals.size(); ++i) {
    const std::vector<std::size_t> same = same_proposals(v.proposals, i);
    if (same.empty()) continue;
    const Proposal& p = v.proposals[i];
    std::string name = fmt::format("{} {}{}", i + 1, escaped(words_of(p)),
                                   i == v.recommended && i > 0 ? " (recommended)" : "");
    if (const std::string also = words_of_same(v.proposals, same); !also.empty())
      name += fmt::format("<br><small>also {}</small>", escaped(also));
    for (std::size_t g = 0; g < 2; ++g)
      if (const std::string amounts = amounts_of(p.gears[g]); !amounts.empty())
        name += fmt::format("<br><small>gear {}: {}</small>", g + 1, amounts);
    std::vector<std::string> row{std::move(name)};
    for (std::string& cell : cells(p.worst)) row.push_back(std::move(cell));
    if (limits) row.push_back(p.at_limits ? cells(*p.at_limits)[1] : "–");
    rows.push_back(std::move(row));
  }
  return value_table("Proposals", heads, rows);
}

std::string advice(const ProposeView& v, const std::string& taken) {
  if (!taken.empty())
    return fmt::format("<strong>The spec as given is also proposal {}.</strong>", escaped(taken));
  return fmt::format("<strong>Recommended: {}, {}.</strong> {}", v.recommended + 1,
                     escaped(words_of(v.proposals[v.recommended])), escaped(v.reason));
}

}  // namespace

std::string propose_section(const ProposeView& view) {
  ProposeView v = view;
  // A spec that already has the modifications of a proposal is a decision of the user.
  const std::string taken = words_of_same(v.proposals, same_proposals(v.proposals, 0));
  if (!taken.empty()) v.recommended = 0;
  return fmt::format(
      "<section class=\"proposals\">\n<h2>Proposed modifications</h2>\n<p>The amounts follow from "
      "a torque of {} N m, the grades of the gears and the deflection of their shafts. The effect "
      "of each proposal is computed for the pair under load.</p>\n<p>{}</p>\n{}{}</section>\n",
      format_number(newton_metres(v.torque)), advice(v, taken),
      side_by_side(compared(v) + effects(v)), table(v));
}

}  // namespace gearwright
