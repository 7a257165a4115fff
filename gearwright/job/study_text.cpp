// Writes the result of a study as JSON, CSV, a table for a terminal and a page. All outputs except
// JSON use the same table of columns.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/catalogue/scattered_design_quantities.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/scatter_study.hpp"
#include "gearwright/report/search_report.hpp"

namespace gearwright {

namespace {

// A column with its heading in CSV and the path of its value in a row. In this path, % stands for
// the index of the percentile by which the designs are ranked. The other texts are those of the
// quantity at the path.
struct StudyColumn {
  const char* csv;
  const char* place;
  int digits = -1;             ///< decimals; if negative, as many as needed
  const char* head = nullptr;  ///< heading in a terminal, by default the symbol
  bool shown = true;           ///< false if only CSV has the column
  bool share = false;          ///< true if a terminal shows the value as a percentage
};
constexpr StudyColumn kColumns[] = {
    {"design", "/design", -1, "design"},
    {"module_mm", "/module_mm"},
    {"z1", "/teeth/0"},
    {"z2", "/teeth/1"},
    {"helix1_deg", "/helix_angle_deg/0"},
    {"helix2_deg", "/helix_angle_deg/1", -1, "", false},
    {"x1", "/profile_shift/0", 4},
    {"x2", "/profile_shift/1", 4},
    {"center_distance_mm", "/center_distance_mm", 4},
    {"face_width_mm", "/face_width_mm", -1, "", false},
    {"percentile_arcsec", "/peak_to_peak_arcsec/percentiles/%", 4, "%"},
    {"percentile_lower_arcsec", "/peak_to_peak_arcsec/lower/%", 4, "from"},
    {"percentile_upper_arcsec", "/peak_to_peak_arcsec/upper/%", 4, "to"},
    {"mean_arcsec", "/peak_to_peak_arcsec/mean", 4, "mean"},
    {"edge_contact", "/probability/edge_contact/value", 1, "edge", true, true},
    {"edge_contact_lower", "/probability/edge_contact/lower", -1, "", false},
    {"edge_contact_upper", "/probability/edge_contact/upper", -1, "", false},
    {"jam", "/probability/jam/value", 1, "jam", true, true},
    {"jam_upper", "/probability/jam/upper", -1, "", false},
    {"contact_lost", "/probability/contact_lost/value", 1, "lost", true, true},
    {"contact_lost_upper", "/probability/contact_lost/upper", -1, "", false}};

std::string percent_words(const JobSpec& spec) {
  return format_number(spec.scatter.percentiles[ranking_percentile(spec)]) + " %";
}

// Calls use(column, heading, unit, meaning) for each column that a terminal and the page show. The
// texts are those of the quantity at the place of the column and of the record that contains it.
template <class Use>
void each_shown(const JobSpec& spec, const Use& use) {
  for (const StudyColumn& c : kColumns) {
    if (!c.shown) continue;
    const QuantityTable* table = &scattered_design_quantities().table();
    const QuantityInfo *record = nullptr, *info = nullptr;
    std::string gear;
    std::istringstream keys(c.place + 1);
    for (std::string key; std::getline(keys, key, '/');) {
      const QuantityInfo* const next = table ? table->find(key) : nullptr;
      if (next) record = std::exchange(info, next);
      if (!next && info->two == Two::gears) gear = key == "0" ? "1" : "2";
      table = next && next->of ? &next->of() : nullptr;
    }
    const std::string head = c.head ? c.head : info->symbol + gear;
    const std::string of = record         ? ": " + plain_words(record->meaning)
                           : gear.empty() ? ""
                                          : " of gear " + gear;
    use(c, head == "%" ? percent_words(spec) : head,
        std::string(unit_text(c.share ? Unit::percent : (record ? record : info)->unit)),
        info->words + of);
  }
}

Json cell(const JobSpec& spec, const StudyColumn& column, const Json& row) {
  std::string place = column.place;
  if (place.ends_with('%'))
    place.replace(place.size() - 1, 1, std::to_string(ranking_percentile(spec)));
  const Json::json_pointer at(place);
  return row.contains(at) ? row[at] : Json();
}

std::optional<double> number_or_none(const Json& value) {
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::string shown(const StudyColumn& column, const Json& value) {
  if (!value.is_number()) return "–";
  if (column.digits < 0) return format_number(value.get<double>());
  return fixed_decimals((column.share ? 100 : 1) * value.get<double>(), column.digits);
}

// Returns, for example, "63 designs, 1024 samples of each (8 replicates of 128), ranked by the 95 %
// point of …"
std::string study_words(const JobSpec& spec, const StudyRun& run) {
  const ScatterInput& in = spec.scatter;
  return fmt::format(
      "{} design{}, {} samples of each ({} replicates of {}), ranked by the {} point of the "
      "peak-to-peak transmission error",
      run.of, run.of == 1 ? "" : "s", in.samples * in.replicates, in.replicates, in.samples,
      percent_words(spec));
}

std::string lost_words(const JobSpec& spec, const StudyRun& run) {
  const auto lost = std::count_if(run.designs.begin(), run.designs.end(),
                                  [&](const Json& row) { return loses_contact(spec, row); });
  if (lost == 0) return "";
  return fmt::format("The last {} contact in more than {:g} % of the samples.",
                     lost == 1 ? "design loses" : fmt::format("{} designs lose", lost),
                     100.0 - spec.scatter.percentiles[ranking_percentile(spec)]);
}

// Returns a sentence if the gears of the best design jam in some samples, otherwise an empty text.
std::string jam_words(const StudyRun& run) {
  if (run.designs.empty()) return "";
  const Json& best = run.designs[0];
  const double jam = best["probability"]["jam"]["value"].get<double>();
  if (jam == 0.0) return "";
  return fmt::format(
      "The gears of design {} jam in {:.3g} % of the samples. To avoid this, give thinner teeth by "
      "thickness_series or backlash_mm in [search].",
      best["design"].get<std::int64_t>(), 100 * jam);
}

std::string design_words(const Json& row) {
  return fmt::format("design {}, {}:{} teeth, module {}", row["design"].get<std::int64_t>(),
                     row["teeth"][0].get<int>(), row["teeth"][1].get<int>(),
                     format_number(row["module_mm"].get<double>()));
}

}  // namespace

Json study_json(const JobSpec& spec, const StudyRun& run) {
  const ScatterInput& in = spec.scatter;
  Json study = to_json(scatter_study_quantities().of(
      {in.percentiles[ranking_percentile(spec)], in.samples, in.replicates, in.seed, run.of}));
  study["designs"] = run.designs;
  study["refused"] = run.refused;
  return study;
}

std::string study_json_text(const JobSpec& spec, const StudyRun& run) {
  Json head = study_json(spec, run);
  head.erase("designs");
  head.erase("refused");
  std::string text = json_text(head);
  const auto add = [&](const char* key, const std::vector<Json>& rows) {
    add_row_lines(text, key, rows.size(), [&](std::size_t i) { return rows[i]; });
  };
  add("designs", run.designs);
  add("refused", run.refused);
  const std::string title =
      spec.title.empty() ? "" : "  \"title\": " + json_text(Json(spec.title)) + ",\n";
  return "{\n" + title + "  \"scatter_designs\": " + text + ",\n  \"warnings\": []\n}\n";
}

Json unfinished_study(const StudyRun& run) {
  return {{"scatter_designs", {{"finished", false}, {"done", run.done}, {"count", run.of}}},
          {"warnings", Json::array()}};
}

std::string study_listing(const JobSpec& spec, const StudyRun& run, std::size_t most) {
  std::string text = spec.title.empty() ? "" : spec.title + "\n";
  text += wrapped(study_words(spec, run)) + "\n";
  std::vector<ListingColumn> columns{{"rank", "rank", "", {}}};
  for (std::size_t i = 0; i < run.designs.size() && i < most; ++i)
    columns[0].cells.push_back(std::to_string(i + 1));
  each_shown(spec, [&](const auto& c, const auto& head, const auto& unit, const auto& meaning) {
    ListingColumn& column =
        columns.emplace_back(ListingColumn{meaning.substr(0, meaning.find(';')), head, unit, {}});
    for (std::size_t i = 0; i < columns[0].cells.size(); ++i)
      column.cells.push_back(shown(c, cell(spec, c, run.designs[i])));
  });
  text += design_listing(columns);
  if (run.designs.size() > most)
    text += fmt::format("    … {} more; --csv, --json and --out DIR give all of them\n",
                        run.designs.size() - most);
  for (const std::string& line : {lost_words(spec, run), jam_words(run)})
    if (!line.empty()) text += line + "\n";
  if (!run.refused.empty())
    text += fmt::format("\nDesigns whose scatter was not computed: {}\n", run.refused.size());
  for (std::size_t i = 0; i < run.refused.size() && i < most; ++i)
    text += fmt::format("  {}: {}\n", design_words(run.refused[i]),
                        run.refused[i]["reason"].get<std::string>());
  if (!run.designs.empty())
    text += fmt::format(
        "\nThe command `gearwright search SPEC --take {}` prints the spec of the best design.\n",
        run.designs[0]["design"].get<std::int64_t>());
  return text;
}

std::string study_csv(const JobSpec& spec, const StudyRun& run) {
  std::string text = "rank";
  for (const StudyColumn& c : kColumns) text += fmt::format(",{}", c.csv);
  text += ",reason\r\n";
  const auto add = [&](const std::string& rank, const Json& row) {
    text += rank;
    for (const StudyColumn& c : kColumns) text += "," + csv_cell(to_value(cell(spec, c, row)));
    text += "," + (row.contains("reason") ? csv_cell(to_value(row["reason"])) : "") + "\r\n";
  };
  for (std::size_t i = 0; i < run.designs.size(); ++i) add(std::to_string(i + 1), run.designs[i]);
  for (const Json& row : run.refused) add("", row);
  return text;
}

std::string study_page(const JobSpec& spec, const StudyRun& run) {
  StudyReport report;
  report.title = spec.title.empty() ? "Designs and their tolerances" : spec.title;
  report.sentence = study_words(spec, run) + ".";
  for (const std::string& words : {lost_words(spec, run), jam_words(run)})
    if (!words.empty()) report.sentence += " " + words;
  report.spec_text = spec.text;
  report.percentile = percent_words(spec);
  each_shown(spec, [&](const auto&, const auto& head, const auto& unit, const auto& meaning) {
    report.columns.push_back({escaped(head), unit, meaning});
  });
  const std::size_t at = ranking_percentile(spec);
  for (const Json& row : run.designs) {
    TableRow& cells = report.rows.emplace_back();
    for (const StudyColumn& c : kColumns) {
      if (!c.shown) continue;
      const Json value = cell(spec, c, row);
      cells.cells.push_back({escaped(shown(c, value)), number_or_none(value)});
    }
    const Json& te = row["peak_to_peak_arcsec"];
    const auto end = [&](const char* key) {
      return te[key].is_array() ? number_or_none(te[key][at]) : std::nullopt;
    };
    report.ranking.push_back({design_words(row), te["percentiles"][at].get<double>(),
                              te["mean"].get<double>(), end("lower"), end("upper")});
  }
  for (const Json& row : run.refused)
    report.refused.push_back(design_words(row) + ": " + row["reason"].get<std::string>());
  return study_report(report);
}

}  // namespace gearwright
