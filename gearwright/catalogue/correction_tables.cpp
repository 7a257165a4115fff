#include "gearwright/catalogue/correction_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/error_keys.hpp"

namespace gearwright {

namespace {

// Returns the errors in words, "out-of-plane shaft deviation -0.01°".
std::string in_words(const std::vector<ErrorValue>& errors) {
  if (errors.empty()) return errors_text(errors);
  std::string text;
  for (const auto& [index, value] : errors) {
    const ErrorEntry& e = error_entries()[index];
    const Unit unit = unit_of(e.key);
    text += fmt::format("{}{} {}{}{}", text.empty() ? "" : ", ", e.words, value,
                        unit == Unit::deg ? "" : " ", unit_text(unit));
  }
  return text;
}

}  // namespace

TextTable correction_table(std::string title, const std::vector<FoundCorrection>& corrections,
                           UnitSystem units) {
  TextTable table{std::move(title), {"change"}};
  const bool any = std::any_of(corrections.begin(), corrections.end(),
                               [](const FoundCorrection& c) { return c.value != 0.0; });
  if (any) table.columns.emplace_back("key in the spec");
  for (const FoundCorrection& c : corrections) {
    const Unit unit = unit_of(c.key);
    std::vector<std::string> cells{text_in(units, unit, c.value, 4)};
    if (any) cells.push_back(c.value != 0.0 ? key_in(units, c.spec_key) : "");
    table.rows.push_back({c.words, std::string(unit_text(units, unit)), std::move(cells)});
    if (c.at_bound)
      table.notes.push_back(fmt::format("The {} is at the end of the range.", c.words));
  }
  return table;
}

TextTable scenario_table(const std::vector<Scenario>& scenarios, UnitSystem units) {
  TextTable table{"Transmission error, peak to peak, for each combination of errors",
                  {"before", "after"}};
  table.units = {"″", "″"};
  const auto arcsec = [](const ContactScore& s) {
    return s.nothing_touches() ? "no contact" : fixed_decimals(s.span_or_sampled().arcsec(), 4);
  };
  for (const Scenario& s : scenarios)
    table.rows.push_back({capitalised(sentence_in(units, in_words(s.errors))),
                          "",
                          {arcsec(s.before), arcsec(s.after)}});
  return table;
}

std::vector<TextTable> proposal_tables(const ProposeView& view, UnitSystem units,
                                       std::optional<std::size_t> marked) {
  TextTable amounts{"Amounts of the modifications; reliefs are rounded up", {}};
  std::vector<std::string> names;
  std::vector<ValueRecord> records;
  for (std::size_t i = 0; i < view.proposals.size(); ++i) {
    const std::vector<std::size_t> same = same_proposals(view.proposals, i);
    const std::size_t number = i + 1;
    if (same.size() > 1)
      amounts.notes.push_back(
          fmt::format("Proposal {} is also {}", number, words_of_same(view.proposals, same)));
    if (same.empty()) continue;
    const Proposal& p = view.proposals[i];
    const char* const mark = marked == i ? "*" : " ";
    names.push_back(fmt::format("{} {:>2}  {}", mark, number, words_of(p)));
    records.push_back(proposal_quantities().of(p));
    for (std::size_t gear = 0; gear < 2 && number > 1; ++gear)
      if (const std::string text = amounts_of(p.gears[gear]); !text.empty())
        amounts.notes.push_back(
            fmt::format("Proposal {}, gear {}: {}", number, gear + 1, sentence_in(units, text)));
  }
  const bool several = view.proposals.front().loads.size() > 1;
  std::vector<TextTable> tables{
      std::move(amounts),
      record_table(units, several ? "Effects, worst values over the torques" : "Effects", names,
                   records,
                   {"worst.peak_to_peak_arcsec", "peak_to_peak_without_load_arcsec",
                    "worst.max_pressure_MPa", "worst.face_load_factor", "worst.edge_carries"})};
  if (view.proposals.front().at_limits)
    tables.push_back(record_table(
        units, "Effects with the helix slope deviations in the less favourable direction", names,
        records,
        {"at_helix_limits.peak_to_peak_arcsec", "at_helix_limits.max_pressure_MPa",
         "at_helix_limits.face_load_factor", "at_helix_limits.edge_carries"}));
  return tables;
}

}  // namespace gearwright
