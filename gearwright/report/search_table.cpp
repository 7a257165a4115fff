#include "gearwright/report/search_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "gearwright/base/units.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/shown_values.hpp"

namespace gearwright {

namespace {

struct Cell {
  std::string text;
  std::optional<double> key;  // what the column sorts by; none comes last
};

struct Column {
  std::string heading;  // HTML
  std::string unit;
  std::string words;  // plain text
  std::function<Cell(const DesignRow&)> cell;
  bool greater_first = false;  // the better are the greater
};

Cell number(const std::optional<double>& value, int decimals) {
  return {fixed(value, decimals), value};
}
Cell whole(int value) { return {std::to_string(value), value}; }
Cell mark(bool is, const char* text) { return {is ? text : "", is ? 1.0 : 0.0}; }

std::string indexed(const char* symbol) { return symbol_html(symbol); }

std::vector<Column> columns_of(const SearchProblem& problem, const SearchAnswer& answer,
                               std::size_t rows) {
  using Row = DesignRow;
  const std::size_t n = std::min(rows, answer.designs.size());
  const auto any = [&](const std::function<bool(const Row&)>& is) {
    return std::any_of(answer.designs.begin(),
                       answer.designs.begin() + static_cast<std::ptrdiff_t>(n), is);
  };
  const bool helical = any([](const Row& r) { return r.trial.helix[0] != 0.0; });
  const bool crossed = problem.crossed();
  std::vector<Column> c;
  c.push_back({indexed("m_n"), "mm", "normal module", [](const Row& r) {
                 return Cell{fmt::format("{:.10g}", r.trial.module), r.trial.module};
               }});
  c.push_back(
      {indexed("z_1"), "", "teeth of gear 1", [](const Row& r) { return whole(r.trial.z1); }});
  c.push_back({indexed("z_2"), "", "teeth of gear 2; negative: a ring",
               [](const Row& r) { return whole(r.trial.z2); }});
  if (helical || crossed)
    c.push_back({indexed("β"), "°", "helix angle of gear 1, right hand positive",
                 [](const Row& r) { return number(kDegPerRad * r.trial.helix[0], 3); }});
  if (problem.racks.size() > 1)
    c.push_back({"rack", "", "which of the racks given",
                 [](const Row& r) { return whole(r.trial.rack + 1); }});
  c.push_back({indexed("u"), "", "gear ratio", [](const Row& r) { return number(r.ratio, 4); }});
  c.push_back({"Δ" + indexed("u"), "",
               fmt::format("gear ratio less its target, {:.10g}", problem.target_ratio),
               [&problem](const Row& r) { return number(r.ratio - problem.target_ratio, 4); }});
  c.push_back({indexed("a"), "mm", "centre distance",
               [](const Row& r) { return number(r.center_distance, kLengthDigits); }});
  for (std::size_t i : {0, 1})
    c.push_back({indexed(i == 0 ? "x_1" : "x_2"), "",
                 fmt::format("profile shift of gear {}, modules", i + 1),
                 [i](const Row& r) { return number(r.shift[i], 4); }});
  c.push_back(
      {"point", "",
       "where in the region the shifts stand: on the line of Eq. 11, or in the middle where "
       "that line misses the region",
       [](const Row& r) {
         return Cell{r.balanced ? "Eq. 11" : "middle", r.balanced ? 1.0 : 0.0};
       },
       true});
  c.push_back({indexed("ε_α"), "",
               crossed ? "contact ratio along the line of action" : "transverse contact ratio",
               [](const Row& r) { return number(r.contact_ratio, 3); }, true});
  c.push_back({indexed("ε_α") + " true", "",
               "the same with the path of contact clipped at the base tangent points",
               [](const Row& r) { return number(r.contact_ratio_true, 3); }, true});
  if (helical && !crossed)
    c.push_back({indexed("ε_β"), "", "overlap ratio",
                 [](const Row& r) { return number(r.overlap_ratio, 3); }, true});
  c.push_back({indexed(crossed ? "α_n" : "α_wt"), "°",
               crossed ? "normal pressure angle" : "working transverse pressure angle",
               [](const Row& r) { return number(kDegPerRad * r.working_angle, 3); }});
  c.push_back({indexed("j_bn"), "mm", "backlash along the common normal",
               [](const Row& r) { return number(r.backlash_normal, kLengthDigits); }});
  for (std::size_t i : {0, 1})
    c.push_back({indexed(i == 0 ? "s_an1" : "s_an2"), "mm",
                 fmt::format("normal tooth thickness at the tip of gear {}", i + 1),
                 [i](const Row& r) { return number(r.tip_thickness[i], 3); }, true});
  c.push_back(
      {indexed("c"), "mm", "least tip clearance of the two",
       [](const Row& r) { return number(std::min(r.tip_clearance[0], r.tip_clearance[1]), 3); },
       true});
  c.push_back(
      {indexed("ζ") + " max", "",
       "greatest specific sliding at the ends of the path of contact; –: a flank reaches its "
       "base tangent point",
       [](const Row& r) { return number(r.max_sliding(), 3); }});
  c.push_back({"area", "", "area of the feasible region, modules²",
               [](const Row& r) { return number(r.area, 4); }, true});
  c.push_back({"interf.", "", "a tip passes the start of the mate’s flank",
               [](const Row& r) { return mark(r.interference, "yes"); }});
  return c;
}

std::string heading(const Column& c) {
  return fmt::format(
      "<th scope=\"col\" class=\"value\" title=\"{}\" data-first=\"{}\">{}{}</th>",
      escaped(c.words), c.greater_first ? "descending" : "ascending", c.heading,
      c.unit.empty() ? "" : fmt::format(" <span class=\"unit\">{}</span>", escaped(c.unit)));
}

std::string cell_html(const Cell& cell) {
  return fmt::format("<td class=\"value\" data-v=\"{}\">{}</td>",
                     cell.key ? fmt::format("{:.12g}", *cell.key) : "", cell.text);
}

}  // namespace

std::string design_table(const SearchProblem& problem, const SearchAnswer& answer,
                         std::size_t rows) {
  const std::vector<Column> columns = columns_of(problem, answer, rows);
  const std::size_t n = std::min(rows, answer.designs.size());
  std::vector<bool> front(answer.designs.size(), false);
  for (const std::size_t i : answer.pareto) front[i] = true;
  const bool fronts = problem.objectives.size() > 1;

  std::string text =
      "<div class=\"scroll sheet\" tabindex=\"0\" role=\"region\" aria-label=\"Designs\"><table "
      "class=\"designs\">\n<thead><tr><th scope=\"col\" class=\"value\" aria-sort=\"ascending\" "
      "data-first=\"ascending\" title=\"rank\">#</th>";
  if (fronts)
    text +=
        "<th scope=\"col\" class=\"value\" title=\"on the Pareto front: no other design betters it "
        "in every "
        "objective\" data-first=\"descending\">front</th>";
  for (const Column& c : columns) text += heading(c);
  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < n; ++i) {
    const DesignRow& row = answer.designs[i];
    text += fmt::format(
        "<tr id=\"design-{0}\"{1}><th scope=\"row\" class=\"value\" data-v=\"{0}\">{0}</th>", i + 1,
        front[i] ? " class=\"front\"" : "");
    if (fronts) text += cell_html(mark(front[i], "●"));
    for (const Column& c : columns) text += cell_html(c.cell(row));
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string design_table_key(const SearchProblem& problem, const SearchAnswer& answer,
                             std::size_t rows) {
  std::string text;
  if (problem.objectives.size() > 1)
    text +=
        "<dt>front</dt><dd>● on the Pareto front: no other design betters it in every "
        "objective</dd>\n";
  for (const Column& c : columns_of(problem, answer, rows))
    text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", c.heading, escaped(c.words));
  return "<details class=\"column-key\"><summary>What the columns mean</summary>\n<dl>\n" + text +
         "</dl></details>\n";
}

}  // namespace gearwright
