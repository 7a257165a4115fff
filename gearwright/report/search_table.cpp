#include "gearwright/report/search_table.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/catalogue/search_quantities.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

// The columns in the order of the page. If the explanation in the catalogue does not suit the page,
// `meaning` replaces it.
struct Entry {
  std::string_view key;
  std::optional<std::string_view> meaning;
};
constexpr Entry kEntries[] = {
    {"interference", {}},
    {"module_mm", {}},
    {"normal_diametral_pitch_per_in", {}},
    {"teeth", ""},
    {"helix_angle_deg", {}},
    {"rack", {}},
    {"ratio", {}},
    {"ratio_error", ""},
    {"center_distance_mm", ""},
    {"profile_shift", "in modules"},
    {"point",
     "“balanced” is a point on the line on which the teeth of both gears are about equally strong. "
     "If this line does not cross the region, the point is “middle”, the middle of the region"},
    {"contact_ratio", "from tip to tip, by the formula"},
    {"contact_ratio_true", "for the part of the path on which both flanks are usable"},
    {"overlap_ratio", ""},
    {"working_normal_pressure_angle_deg", ""},
    {"working_transverse_pressure_angle_deg", ""},
    {"backlash_normal_mm", ""},
    {"tip_thickness_mm", ""},
    {"tip_clearance_mm", "from the tip of this gear to the root of the mating gear"},
    {"sliding_max",
     "at the ends of the path of contact; there is no value (–) if a flank reaches its base "
     "tangent point"},
    {"face_width_mm", "of both gears"},
    {"S_H", ""},
    {"S_F", ""},
    {"mass_kg", {}},
    {"efficiency", {}},
    {"balance", {}},
    {"relative_cost", {}},
    {"noise_um", {}},
    {"loaded_noise_um", {}},
    {"area", "size of the region of profile shifts within the limits, in modules²"}};

struct Column {
  const QuantityInfo* info;
  std::string_view meaning;
  std::optional<std::size_t> gear;  // index of the gear, if each gear has its own value
};

TableCell mark(bool is, const char* text) { return {is ? text : "", is ? 1.0 : 0.0}; }

TableCell cell_of(const Column& column, const ValueRecord& record, UnitSystem units) {
  const Member* member = member_for(record, column.info);
  if (!member) return {std::string(kNoValue), std::nullopt};
  const Value& v = column.gear ? (*member->value.list())[*column.gear] : member->value;
  if (const auto* flag = std::get_if<bool>(&v.variant())) return mark(*flag, "yes");
  if (const auto* word = std::get_if<std::string>(&v.variant())) {
    const bool balanced = *word == "eq11";
    return {balanced ? "balanced" : "middle", balanced ? 1.0 : 0.0};
  }
  if (column.info->key == "module_mm") return {fmt::format("{:.10g}", *v.number()), v.number()};
  return {text_of(*column.info, v, kNoValue, units), v.number()};
}

// Returns the columns of the table. A column without a value for any design is omitted.
std::vector<Column> columns_of(const std::vector<ValueRecord>& records) {
  std::vector<Column> columns;
  for (const Entry& entry : kEntries) {
    const QuantityInfo* info = design_quantities().table().find(entry.key);
    GW_EXPECTS(info != nullptr);
    if (std::none_of(records.begin(), records.end(), [&](const ValueRecord& r) {
          const Member* m = member_for(r, info);
          return m && m->shown;
        }))
      continue;
    const std::string_view meaning = entry.meaning.value_or(info->meaning);
    const bool one = info->two != Two::gears || info->key == "helix_angle_deg";
    if (one)
      columns.push_back(
          {info, meaning, info->two == Two::gears ? std::optional<std::size_t>(0) : std::nullopt});
    for (std::size_t gear = 0; !one && gear < 2; ++gear) columns.push_back({info, meaning, gear});
  }
  return columns;
}

std::vector<ValueRecord> records_of(const SearchProblem& problem, const SearchAnswer& answer,
                                    std::size_t rows) {
  std::vector<ValueRecord> records;
  for (std::size_t i = 0; i < std::min(rows, answer.designs.size()); ++i)
    records.push_back(design_quantities().of({&problem, &answer.designs[i]}));
  return records;
}

std::string symbol_of(const Column& c) {
  if (c.info->symbol.empty()) return c.info->key;
  if (!c.gear) return symbol_html(c.info->symbol);
  const bool indexed = c.info->symbol.find('_') != std::string::npos;
  return symbol_html(c.info->symbol + (indexed ? "" : "_") + std::to_string(*c.gear + 1));
}

std::string words_of(const Column& c) {
  std::string words = c.info->words;
  if (c.gear) words += fmt::format(" of gear {}", *c.gear + 1);
  return c.meaning.empty() ? words : fmt::format("{}: {}", words, c.meaning);
}

TableColumn heading(const Column& c, UnitSystem units) {
  return {symbol_of(c), std::string(unit_text(system_of(*c.info, units), c.info->unit)),
          words_of(c), c.info->greater_first ? "descending" : "ascending"};
}

TableColumn front_heading() {
  return {
      "front", "",
      "design on the Pareto front, which means that no other design is better in every objective",
      "descending"};
}

}  // namespace

std::string sortable_table(const std::vector<TableColumn>& columns,
                           const std::vector<TableRow>& rows) {
  std::string text =
      "<div class=\"scroll sheet\" tabindex=\"0\" role=\"region\" aria-label=\"Designs\"><table "
      "class=\"designs\">\n<thead><tr><th scope=\"col\" class=\"value\" aria-sort=\"ascending\" "
      "data-first=\"ascending\" title=\"rank\">#</th>";
  for (const TableColumn& c : columns)
    text += fmt::format(
        "<th scope=\"col\" class=\"value\" title=\"{}\" data-first=\"{}\">{}{}</th>",
        escaped(c.meaning), c.first, c.head,
        c.unit.empty() ? "" : fmt::format(" <span class=\"unit\">{}</span>", escaped(c.unit)));
  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += fmt::format("<tr{1}><th scope=\"row\" class=\"value\" data-v=\"{0}\">{0}</th>", i + 1,
                        rows[i].attributes);
    for (const TableCell& cell : rows[i].cells)
      text += fmt::format("<td class=\"value\" data-v=\"{}\">{}</td>",
                          cell.key ? fmt::format("{:.12g}", *cell.key) : "", cell.html);
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string column_key(const std::vector<TableColumn>& columns) {
  std::string text;
  for (const TableColumn& c : columns)
    text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", c.head, escaped(c.meaning));
  return "<details class=\"column-key\"><summary>Meaning of the columns</summary>\n<dl>\n" + text +
         "</dl></details>\n";
}

std::string design_table(const SearchProblem& problem, const SearchAnswer& answer, std::size_t rows,
                         UnitSystem units) {
  const std::vector<ValueRecord> records = records_of(problem, answer, rows);
  const std::vector<Column> columns = columns_of(records);
  std::vector<bool> front(answer.designs.size(), false);
  for (const std::size_t i : answer.pareto) front[i] = true;
  const bool fronts = problem.objectives.size() > 1;
  std::vector<TableColumn> heads;
  if (fronts) heads.push_back(front_heading());
  for (const Column& c : columns) heads.push_back(heading(c, units));
  std::vector<TableRow> table;
  for (std::size_t i = 0; i < records.size(); ++i) {
    TableRow& row = table.emplace_back();
    row.attributes = fmt::format(" id=\"design-{}\"{}", i + 1, front[i] ? " class=\"front\"" : "");
    if (fronts) row.cells.push_back(mark(front[i], "●"));
    for (const Column& c : columns) row.cells.push_back(cell_of(c, records[i], units));
  }
  return sortable_table(heads, table);
}

std::string design_table_key(const SearchProblem& problem, const SearchAnswer& answer,
                             std::size_t rows, UnitSystem units) {
  std::vector<TableColumn> heads;
  if (problem.objectives.size() > 1) {
    heads.push_back(front_heading());
    heads.back().meaning = "● " + heads.back().meaning;
  }
  for (const Column& c : columns_of(records_of(problem, answer, rows)))
    heads.push_back(heading(c, units));
  return column_key(heads);
}

namespace {

// The order is the order of the enumerators of Limit.
constexpr std::array<std::string_view, kLimits> kLimitWords{
    "undercut or a thin tip at every profile shift",
    "centre distance out of reach",
    "contact ratio too small",
    "overlap ratio too small",
    "specific sliding too great",
    "tip clearance too small",
    "interference",
    "safety against pitting too small",
    "safety against root breakage too small",
    "a finding in the verdict on the drawn pair"};

}  // namespace

std::string_view words_of(Limit limit) { return kLimitWords[static_cast<std::size_t>(limit)]; }

std::vector<RejectedBy> rejected_by(const SearchCounts& counts) {
  std::vector<RejectedBy> list;
  for (std::size_t i = 0; i < counts.rejected.size(); ++i)
    if (counts.rejected[i] > 0)
      list.push_back({std::string(words_of(static_cast<Limit>(i))), counts.rejected[i], false});
  // The findings follow their limit, which is the last one. Some drawings have no finding, because
  // they cannot be made or rated.
  std::int64_t rest = counts.rejected[static_cast<std::size_t>(Limit::verdict)];
  for (const WarningMeaning& finding : warning_meanings()) {
    const std::int64_t n = counts.findings[static_cast<std::size_t>(finding.code)];
    if (n == 0) continue;
    list.push_back({*finding.reason ? finding.reason : finding.text, n, true});
    rest -= n;
  }
  if (rest > 0) list.push_back({"a pair that cannot be drawn or rated", rest, true});
  return list;
}

ObjectiveWords words_of(Objective objective) {
  switch (objective) {
    case Objective::contact_ratio: return {"contact ratio", "ε_α", ""};
    case Objective::formula_contact_ratio: return {"contact ratio by formula", "ε_α", ""};
    case Objective::ratio: return {"error of the ratio", "", ""};
    case Objective::size: return {"size m²(z₁² + z₂²)", "", "mm²"};
    case Objective::shift: return {"sum of profile shifts", "Σx", "modules"};
    case Objective::area: return {"area of the region of profile shifts", "", "modules²"};
    case Objective::sliding: return {"greatest specific sliding", "ζ", ""};
    case Objective::mass: return {"mass", "m", "kg"};
    case Objective::safety: return {"least ratio of safety to required safety", "", ""};
    case Objective::efficiency: return {"efficiency", "η", ""};
    case Objective::balance: return {"balance of the load reserves", "", ""};
    case Objective::cost: return {"relative cost", "", ""};
    case Objective::noise: return {"estimated transmission error under load", "", "µm"};
  }
  contract_failed("postcondition", "known objective", __FILE__, __LINE__);
}

std::string order_in_words(const SearchProblem& problem) {
  const auto& objectives = problem.objectives;
  std::string text = fmt::format("by {}", words_of(objectives[0]).name);
  if (objectives.size() == 1) return text;
  text += "; the designs on the Pareto front over ";
  for (std::size_t i = 0; i < objectives.size(); ++i) {
    const char* before = i == 0 ? "" : i + 1 == objectives.size() ? " and " : ", ";
    text += fmt::format("{}{}", before, words_of(objectives[i]).name);
  }
  return text + " come first";
}

std::optional<double> value_of(const SearchProblem& problem, const DesignRow& row,
                               Objective objective) {
  // cost() has a value only for a design with a rank, which is a balanced design. The figure also
  // shows designs without a rank, so the value is computed for a copy of the row that is marked as
  // balanced.
  DesignRow any = row;
  any.balanced = true;
  const auto value = cost(problem, any, objective);
  if (!value) return std::nullopt;
  return seeks_greatest(objective) ? -*value : *value;
}

std::string design_name(const Trial& trial) {
  const double beta = trial.helix[0].deg();
  return fmt::format("{:.10g} · {}:{}{}", trial.module, trial.z1, trial.z2,
                     beta == 0.0 ? "" : fmt::format(" · {:.6g}°", beta));
}

}  // namespace gearwright
